#pragma once

#include "common/geometry/meshes.hpp"
#include "common/simulation/body.hpp"

namespace enduring {

/// A surface that turns about an axis at a constant rate, whatever pushes it: a turntable, a drum. It takes
/// impulses as a static body does. Only code can make one; scenes have none.
class TurningBody final : public Body {
public:
    /// @param mesh              where it is at first [m]
    /// @param centre            a point of the axis [m]
    /// @param angular_velocity  [rad/s]
    TurningBody(std::string name, const SurfaceMesh& mesh, const Vec3& centre, const Vec3& angular_velocity);

    void predict(const Vec3& gravity, double dt) override;
    void update_prediction(double) override {}
    void commit(double dt) override;

    void apply_impulse(int, const Vec3&) override {}
    Vec3 velocity(int vertex) const override;
    Mat3 inverse_mass(int) const override { return Mat3::Zero(); }

    void visit_state(StateArchive& archive) override;

    bool is_static() const override { return true; }
    double mass() const override { return 0; }
    Energy energy(const Vec3&) const override { return {}; }
    Vec3 linear_momentum() const override { return Vec3::Zero(); }
    Vec3 angular_momentum(const Vec3&) const override { return Vec3::Zero(); }

    /// Where a point of the world [m] would lie if it had turned along
    /// since the beginning, and now came back.
    Vec3 turned_back(const Vec3& point) const;

private:
    Vec3 centre_, angular_velocity_;
    double time_ = 0;  ///< committed [s]
    std::vector<Vec3> at_first_;
};

}  // namespace enduring
