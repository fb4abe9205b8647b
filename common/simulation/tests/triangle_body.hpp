#pragma once

#include "common/simulation/point_masses.hpp"

#include <memory>

namespace enduring {

/// One triangle of three point masses of 1 kg in the plane y = height, facing up.
inline std::unique_ptr<PointMasses> triangle(const std::string& name, double height = 0,
                                             const Vec3& velocity = Vec3::Zero())
{
    return std::make_unique<PointMasses>(name,
                                         std::vector<Vec3>{{0, height, 0}, {0, height, 1}, {1, height, 0}},
                                         std::vector<Face>{{0, 1, 2}}, 1.0, velocity);
}

}  // namespace enduring
