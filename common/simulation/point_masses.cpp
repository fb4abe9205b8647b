#include "common/simulation/point_masses.hpp"

#include <numeric>
#include <utility>

namespace enduring {
namespace {

class PointTrial final : public Trial {
public:
    PointTrial(std::vector<Vec3> velocities, double mass) : velocities_(std::move(velocities)), mass_(mass) {}
    void push(int vertex, const Vec3& impulse) override { velocities_[vertex] += impulse / mass_; }
    Vec3 velocity(int vertex) override { return velocities_[vertex]; }

private:
    std::vector<Vec3> velocities_;
    double mass_;
};

}  // namespace

PointMasses::EachAlone::EachAlone(std::size_t points) : numbers_(points)
{
    std::iota(numbers_.begin(), numbers_.end(), 0);
}

PointMasses::PointMasses(std::string name, std::vector<Vec3> positions, std::vector<Face> faces,
                         double mass_of_each, const Vec3& velocity)
    : Body(std::move(name), SurfaceTopology(static_cast<int>(positions.size()), std::move(faces))),
      mass_(mass_of_each), velocities_(positions.size(), velocity), parts_(positions.size())
{
    positions_t1_ = positions;
    positions_t0_ = std::move(positions);
    measure();
}

std::unique_ptr<Trial> PointMasses::begin_trial() const
{
    return std::make_unique<PointTrial>(velocities_, mass_);
}

void PointMasses::predict(const Vec3& gravity, double dt)
{
    for (Vec3& velocity : velocities_)
        velocity += dt * gravity;
    update_prediction(dt);
}

void PointMasses::update_prediction(double dt)
{
    for (std::size_t i = 0; i < velocities_.size(); ++i)
        positions_t1_[i] = positions_t0_[i] + dt * velocities_[i];
}

void PointMasses::commit(double dt)
{
    update_prediction(dt);
    positions_t0_ = positions_t1_;
}

Energy PointMasses::energy(const Vec3& gravity) const
{
    Energy energy;
    for (std::size_t i = 0; i < velocities_.size(); ++i) {
        energy.kinetic += 0.5 * mass_ * velocities_[i].squaredNorm();
        energy.gravitational -= mass_ * gravity.dot(positions_t0_[i]);
    }
    return energy;
}

Vec3 PointMasses::linear_momentum() const
{
    Vec3 sum = Vec3::Zero();
    for (const Vec3& velocity : velocities_)
        sum += mass_ * velocity;
    return sum;
}

Vec3 PointMasses::angular_momentum(const Vec3& about) const
{
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < velocities_.size(); ++i)
        sum += mass_ * (positions_t0_[i] - about).cross(velocities_[i]);
    return sum;
}

}  // namespace enduring
