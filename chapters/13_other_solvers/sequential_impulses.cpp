#include "chapters/13_other_solvers/sequential_impulses.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace enduring {
namespace {

/// One direction of one contact: its velocity is to reach a target, by an impulse between two bounds.
struct Row {
    Vec3 direction;
    double mass = 0;     ///< 1 / response [kg]; 0 where nothing moves
    double target = 0;   ///< least velocity along it [m/s]
    double impulse = 0;  ///< in this step so far [N s]
};
struct PointRows {
    Row normal;
    std::array<Row, 2> tangents;
};

Row row_along(const MethodStep& step, const ContactPoint& point, const Vec3& direction)
{
    const double response = step.response(point, direction);
    return {direction, response > 0 ? 1 / response : 0};
}

double depth_to_take_away(const MethodStep& step, const ContactPoint& point,
                          const SequentialSettings& settings)
{
    const double size = step.b(point).moves ? std::min(step.a(point).size, step.b(point).size)
                                            : step.a(point).size;
    return std::max(0.0, -point.separation - settings.slop * size);
}

bool is_split(const ContactPoint& point, const SequentialSettings& settings)
{
    return -point.separation >= settings.split_from;
}

//! [target]
/// What is apart may close in this step; a depth goes by a part of it each step (Baumgarte); an impact
/// bounces.
double normal_target(const MethodStep& step, const ContactPoint& point, const SequentialSettings& settings)
{
    double target = -std::max(0.0, point.separation) / step.dt;
    if (!is_split(point, settings))
        target += settings.baumgarte * depth_to_take_away(step, point, settings) / step.dt;
    const double approach = -point.normal.dot(step.relative_velocity(point));
    if (approach > settings.restitution_threshold && approach * step.dt > point.separation)
        target = std::max(target, point.restitution * approach);
    return target;
}
//! [target]

//! [solve_row]
/// The impulse that makes one velocity right, within its bounds: the sum of impulses is clamped, and not each
/// of them.
void solve_row(MethodStep& step, const ContactPoint& point, Row& row, double least, double most)
{
    const double missing = row.target - row.direction.dot(step.relative_velocity(point));
    const double before = row.impulse;
    row.impulse = std::clamp(before + row.mass * missing, least, most);
    step.push(point, (row.impulse - before) * row.direction);
}
//! [solve_row]

constexpr double no_bound = 1e300;

//! [sweep]
/// Friction first, so that in the end no contact approaches.
void sweep(MethodStep& step, std::vector<PointRows>& rows)
{
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const ContactPoint& point = step.points[i];
        const double bound = point.mu_s * rows[i].normal.impulse;
        for (Row& tangent : rows[i].tangents)
            solve_row(step, point, tangent, -bound, bound);
        solve_row(step, point, rows[i].normal, 0, no_bound);
    }
}
//! [sweep]

void warm_start(MethodStep& step, std::vector<PointRows>& rows)
{
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const ContactPoint& point = step.points[i];
        for (Row* row : {&rows[i].normal, &rows[i].tangents[0], &rows[i].tangents[1]})
            row->impulse = row->direction.dot(point.impulse);
        rows[i].normal.impulse = std::max(0.0, rows[i].normal.impulse);
        step.push(point, point.impulse);
    }
}

//! [split]
/// Depths are taken away by velocities that move bodies in this step and are forgotten: they bring no kinetic
/// energy.
std::vector<MovingBody> pushed_apart(const MethodStep& step, const SequentialSettings& settings)
{
    MethodStep apart = step;
    for (MovingBody& body : apart.bodies)
        body.velocity = body.angular_velocity = Vec3::Zero();
    for (ContactPoint& point : apart.points)
        point.given.setZero();
    std::vector<Row> rows;
    for (const ContactPoint& point : apart.points) {
        rows.push_back(row_along(apart, point, point.normal));
        if (is_split(point, settings))
            rows.back().target = settings.baumgarte * depth_to_take_away(apart, point, settings) / step.dt;
    }
    for (int i = 0; i < settings.iterations; ++i)
        for (std::size_t n = 0; n < rows.size(); ++n)
            if (rows[n].target > 0)
                solve_row(apart, apart.points[n], rows[n], 0, no_bound);
    return apart.bodies;
}
//! [split]

}  // namespace

//! [sequential_impulses]
void sequential_impulses(MethodStep& step, const SequentialSettings& settings)
{
    std::vector<PointRows> rows;
    for (ContactPoint& point : step.points) {
        point.impulse *= settings.warm_start;
        rows.push_back({row_along(step, point, point.normal),
                        {row_along(step, point, point.tangent_1), row_along(step, point, point.tangent_2)}});
        rows.back().normal.target = normal_target(step, point, settings);  // of velocities before gravity
    }
    for (MovingBody& body : step.bodies)
        body.fall(step.dt);
    warm_start(step, rows);
    for (int i = 0; i < settings.iterations; ++i)
        sweep(step, rows);

    const std::vector<MovingBody> apart = pushed_apart(step, settings);
    for (std::size_t i = 0; i < step.bodies.size(); ++i) {
        MovingBody& body = step.bodies[i];
        MovingBody moved = body;
        moved.velocity += apart[i].velocity;
        moved.angular_velocity += apart[i].angular_velocity;
        moved.move(step.dt);
        body.pose = moved.pose;
    }
    for (std::size_t i = 0; i < rows.size(); ++i)
        step.points[i].impulse = rows[i].normal.impulse * rows[i].normal.direction +
                                 rows[i].tangents[0].impulse * rows[i].tangents[0].direction +
                                 rows[i].tangents[1].impulse * rows[i].tangents[1].direction;
}
//! [sequential_impulses]

Solver chapter13_sequential_solver(const ContactParameters& parameters, const SequentialSettings& settings)
{
    return method_solver("sequential impulses", parameters,
                         [settings](MethodStep& step) { sequential_impulses(step, settings); });
}

}  // namespace enduring
