#pragma once

#include "chapters/08_contact_by_distance/experiments/forces_rows.hpp"

#include <doctest/doctest.h>

namespace enduring::chapter08::force_rows {

inline void check_rows(const Rows& rows)
{
    for (const Row& row : rows) {
        CAPTURE(row.key);
        CAPTURE(row.worst);
        CAPTURE(row.off);
        CHECK(row.holds());
    }
}

}  // namespace enduring::chapter08::force_rows
