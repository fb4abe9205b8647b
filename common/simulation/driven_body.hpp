#pragma once

#include "common/geometry/meshes.hpp"
#include "common/rigid/rigid_motion.hpp"
#include "common/simulation/body.hpp"
#include "common/simulation/given_motion.hpp"

namespace enduring {

/// A surface that moves as given, whatever pushes it: a turntable, a drum, a piston. It takes impulses as a
/// static body does. Pairs feel its velocity by where its vertices are at both ends of the step.
class DrivenBody final : public Body {
public:
    /// @param mesh    as it is placed, without its motion [m]
    /// @param centre  the point that the motion displaces, and turns the body about; placed as well [m]
    /// @param time    at which it begins [s]
    DrivenBody(std::string name, const SurfaceMesh& mesh, const Vec3& centre, GivenMotion motion,
               double time = 0);

    void predict(const Vec3& gravity, double dt) override;
    void update_prediction(double dt) override;
    void commit(double dt) override;

    void apply_impulse(int, const Vec3&) override {}
    /// At the start of the step.
    Vec3 velocity(int vertex) const override;
    double turning_speed() const override { return motion_.at(time_).angular_velocity.norm(); }
    Mat3 inverse_mass(int) const override { return Mat3::Zero(); }

    std::span<const Vec3> shape() const override { return placed_; }
    void take_contact_surface(const std::vector<Vec3>& shape) override
    {
        contact_placed_ = contact_t0_ = contact_t1_ = shape;
        place(time_, contact_placed_, contact_t0_);
    }
    bool is_driven() const override { return true; }
    bool is_static() const override { return true; }
    double mass() const override { return 0; }
    Energy energy(const Vec3&) const override { return {}; }
    Vec3 linear_momentum() const override { return Vec3::Zero(); }
    Vec3 angular_momentum(const Vec3&) const override { return Vec3::Zero(); }

    /// From where it was placed to where the motion has brought it at a time [s].
    Pose pose(double time) const;
    /// Where a point of the world [m] would lie if it had moved along since the body was placed, and now came
    /// back.
    Vec3 brought_back(const Vec3& point) const;

private:
    void place(double time, const std::vector<Vec3>& placed, std::vector<Vec3>& positions) const;

    Vec3 centre_;
    GivenMotion motion_;
    std::vector<Vec3> placed_, contact_placed_;  ///< without the motion [m]
};

}  // namespace enduring
