#pragma once

#include "common/simulation/step.hpp"

namespace enduring {

/// Detection in the first step: appends the pairs that touch already and move inwards, from the start of the
/// step on. Chapter 2's queries follow everything that begins outside, without a gap from step to step. What
/// is laid exactly on a surface begins outside, on it or inside, as its coordinates have been rounded. What
/// begins inside crosses nothing, and its box may not even overlap that of the face.
void append_touching_pairs(const World& world, Contacts& contacts);

}  // namespace enduring
