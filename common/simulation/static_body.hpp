#pragma once

#include "common/simulation/body.hpp"

namespace enduring {

/// A surface that never moves: the ground, a slope, a bowl held in place. It takes every impulse without an
/// answer, as a body of infinite mass would.
class StaticBody final : public Body {
public:
    /// @param vertices  world positions [m], one for each vertex of `surface`
    /// @throws std::invalid_argument  as many positions as the surface has vertices are needed
    StaticBody(std::string name, SurfaceTopology surface, std::vector<Vec3> vertices);

    void predict(const Vec3&, double) override {}
    void update_prediction(double) override {}
    void commit(double) override {}

    void apply_impulse(int, const Vec3&) override {}
    Vec3 velocity(int) const override { return Vec3::Zero(); }
    Mat3 inverse_mass(int) const override { return Mat3::Zero(); }

    void visit_state(StateArchive&) override {}

    bool is_static() const override { return true; }
    double mass() const override { return 0; }
    Energy energy(const Vec3&) const override { return {}; }
    Vec3 linear_momentum() const override { return Vec3::Zero(); }
    Vec3 angular_momentum(const Vec3&) const override { return Vec3::Zero(); }
};

}  // namespace enduring
