#include "common/simulation/deforming_body.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace enduring {

DeformingBody::DeformingBody(std::string name, SurfaceTopology surface, std::vector<Shape> shapes,
                             double time)
    : Body(std::move(name), std::move(surface)), shapes_(std::move(shapes))
{
    const auto not_later = [](const Shape& one, const Shape& next) { return !(one.time < next.time); };
    const auto has_others = [&](const Shape& shape) {
        return static_cast<int>(shape.vertices.size()) != this->surface().vertex_count();
    };
    if (shapes_.size() < 2 || std::any_of(shapes_.begin(), shapes_.end(), has_others) ||
        std::adjacent_find(shapes_.begin(), shapes_.end(), not_later) != shapes_.end())
        throw std::invalid_argument(
            "deforming body '" + this->name() +
            "': two shapes or more are needed, with times that ascend and a position for each vertex");
    set_time(time);
    positions_t0_ = shapes_.front().vertices;
    place(time, positions_t0_);
    positions_t1_ = positions_t0_;
    measure();
}

void DeformingBody::predict(const Vec3&, double dt) { update_prediction(dt); }

void DeformingBody::update_prediction(double dt) { place(time_ + dt, positions_t1_); }

void DeformingBody::commit(double dt)
{
    set_time(time_ + dt);
    positions_t0_ = positions_t1_;
}

Vec3 DeformingBody::slope_at(std::size_t shape, std::size_t vertex) const
{
    if (shape == 0 || shape + 1 == shapes_.size())
        return Vec3::Zero();
    const Shape &last = shapes_[shape - 1], &now = shapes_[shape], &next = shapes_[shape + 1];
    return slope_between(last.vertices[vertex], now.vertices[vertex], next.vertices[vertex],
                         now.time - last.time, next.time - now.time);
}

//! [at]
ValueAndSlope DeformingBody::at(double time, std::size_t vertex) const
{
    const auto next = std::upper_bound(shapes_.begin(), shapes_.end(), time,
                                       [](double t, const Shape& shape) { return t < shape.time; });
    if (next == shapes_.begin() || next == shapes_.end()) {
        const Shape& end = next == shapes_.begin() ? shapes_.front() : shapes_.back();
        return {end.vertices[vertex], Vec3::Zero()};
    }
    const auto i = static_cast<std::size_t>(next - shapes_.begin());
    const Shape &from = shapes_[i - 1], &to = shapes_[i];
    const double length = to.time - from.time;
    return hermite(from.vertices[vertex], slope_at(i - 1, vertex), to.vertices[vertex], slope_at(i, vertex),
                   length, (time - from.time) / length);
}
//! [at]

/// By the time alone, so rounding does not add up, and parts of a step lead to the same place as the whole
/// one.
void DeformingBody::place(double time, std::vector<Vec3>& positions) const
{
    for (std::size_t i = 0; i < positions.size(); ++i)
        positions[i] = at(time, i).value;
}

}  // namespace enduring
