#pragma once

#include "common/simulation/body.hpp"

#include <limits>
#include <memory>
#include <utility>

namespace enduring {

/// The simplest moving body: independent point masses on one surface. Every number of a step can be checked by hand.
class PointMasses final : public Body {
public:
    PointMasses(std::string name, std::vector<Vec3> positions, std::vector<Face> faces, double mass_of_each)
        : Body(std::move(name), SurfaceTopology(static_cast<int>(positions.size()), std::move(faces))),
          mass_(mass_of_each), velocities_(positions.size(), Vec3::Zero())
    {
        positions_t1_ = positions;
        positions_t0_ = std::move(positions);
    }

    void set_velocity(const Vec3& v) { velocities_.assign(velocities_.size(), v); }

    void predict(const Vec3& gravity, double dt) override
    {
        for (Vec3& v : velocities_)
            v += dt * gravity;
        update_prediction(dt);
    }
    void update_prediction(double dt) override
    {
        for (std::size_t i = 0; i < velocities_.size(); ++i)
            positions_t1_[i] = positions_t0_[i] + dt * velocities_[i];
    }
    void commit(double dt) override
    {
        update_prediction(dt);
        positions_t0_ = positions_t1_;
    }
    void apply_impulse(int vertex, const Vec3& impulse) override { velocities_[static_cast<std::size_t>(vertex)] += impulse / mass_; }
    Vec3 velocity(int vertex) const override { return velocities_[static_cast<std::size_t>(vertex)]; }
    Mat3 inverse_mass(int) const override { return Mat3::Identity() / mass_; }
    double mass() const override { return mass_ * static_cast<double>(velocities_.size()); }

    Energy energy(const Vec3& gravity) const override
    {
        Energy energy;
        for (std::size_t i = 0; i < velocities_.size(); ++i) {
            energy.kinetic += 0.5 * mass_ * velocities_[i].squaredNorm();
            energy.gravitational -= mass_ * gravity.dot(positions_t0_[i]);
        }
        return energy;
    }
    Vec3 linear_momentum() const override
    {
        Vec3 sum = Vec3::Zero();
        for (const Vec3& v : velocities_)
            sum += mass_ * v;
        return sum;
    }
    Vec3 angular_momentum(const Vec3& about) const override
    {
        Vec3 sum = Vec3::Zero();
        for (std::size_t i = 0; i < velocities_.size(); ++i)
            sum += mass_ * (positions_t0_[i] - about).cross(velocities_[i]);
        return sum;
    }

private:
    double mass_;
    std::vector<Vec3> velocities_;
};

/// One triangle of three point masses of 1 kg in the plane y = height.
inline std::unique_ptr<PointMasses> triangle(const std::string& name, double height = 0)
{
    return std::make_unique<PointMasses>(
        name, std::vector<Vec3>{{0, height, 0}, {0, height, 1}, {1, height, 0}}, std::vector<Face>{{0, 1, 2}}, 1.0);
}

}  // namespace enduring
