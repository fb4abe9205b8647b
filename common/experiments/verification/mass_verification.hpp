#pragma once

#include "common/experiments/report/table.hpp"

namespace enduring::verification {

/// Shares of an element's mass at a corner and at an edge node, by three ways of lumping the ten-node
/// element. Columns lumping, corner, edge.
Table ways_of_lumping();

}  // namespace enduring::verification
