#include "chapters/13_other_solvers/rigid_avbd.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace enduring {

//! [dual]
AugmentedConstraint dual_update(const AugmentedConstraint& constraint, double error, double least,
                                double most, const AvbdSettings& settings)
{
    const double force = std::clamp(constraint.multiplier + constraint.stiffness * error, least,
                                    most);  // (11)
    const bool at_bound = force <= least || force >= most;
    const double grown = constraint.stiffness + (at_bound ? 0 : settings.beta * std::abs(error));  // (16)
    return {force, std::min(settings.most_stiffness, grown)};
}
//! [dual]

namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// From one pose to another: the way of the centre, and the rotation vector.
Vector6 way_between(const Pose& from, const Pose& to)
{
    return (Vector6() << to.position - from.position,
            rotation_vector(to.orientation * from.orientation.conjugate()))
        .finished();
}

Vector6 jacobian(const Vec3& direction, const Vec3& r)
{
    return (Vector6() << direction, r.cross(direction)).finished();
}

}  // namespace

/// A contact's three constraints: C = C_0 - alpha C_0 + J (x - x_0) to first order (18), positive where the contact has to push.
struct RigidAvbd::Row {
    int a, b;
    double mu;
    std::array<Vector6, 3> j_a, j_b;  ///< of the normal and of the tangents, with the levers of the start
    Vec3 start;                       ///< errors without any motion of the bodies [m]
    Vec3 slip;                        ///< when the step begins, along the surface [m]
    std::array<AugmentedConstraint, 3> constraints;
    bool slips = true;  ///< behind the last sweep

    double error(const RigidStep& step, int i) const
    {
        const auto n = static_cast<std::size_t>(i);
        double error = start[i];
        for (const auto& [index, j] : {std::pair(a, &j_a[n]), std::pair(b, &j_b[n])}) {
            const MovingBody& body = step.bodies[static_cast<std::size_t>(index)];
            if (body.moves)
                error -= j->dot(way_between(body.start, body.pose));
        }
        return error;
    }
    double normal_force(const RigidStep& step) const
    {
        return std::max(0.0, constraints[0].multiplier + constraints[0].stiffness * error(step, 0));
    }
    struct Push {
        Vec3 force;
        bool is_full;  ///< of friction
    };
    /// Along the normal from 0 on; along the surface within a disc of mu times the normal force.
    Push push(const RigidStep& step) const
    {
        Vec3 force(normal_force(step), 0, 0);
        for (int i = 1; i < 3; ++i) {
            const AugmentedConstraint& row = constraints[static_cast<std::size_t>(i)];
            force[i] = row.multiplier + row.stiffness * error(step, i);
        }
        const double length = force.tail<2>().norm(), bound = mu * force.x();
        const bool is_full = length >= bound;
        if (is_full && length > 0)
            force.tail<2>() *= bound / length;
        return {force, is_full};
    }
};

//! [rows_of]
std::vector<RigidAvbd::Row> RigidAvbd::rows_of(const RigidStep& step) const
{
    std::vector<Row> rows;
    for (const ContactPoint& point : step.points) {
        Row row{point.a, point.b, point.mu_s, {}, {}, {}, Vec3::Zero(), {}, true};
        const std::array directions{point.normal, point.tangent_1, point.tangent_2};
        const auto known = kept_.find(point.key);
        if (known != kept_.end())
            row.slip = step.a(point).pose.orientation * known->second.slip;
        for (std::size_t i = 0; i < 3; ++i) {
            row.j_a[i] = jacobian(directions[i], step.lever_a(point));
            row.j_b[i] = -jacobian(directions[i], step.lever_b(point));
            const double last = known == kept_.end() ? 0 : known->second.stiffness[static_cast<int>(i)];
            row.constraints[i] = {
                settings_.alpha * settings_.gamma * directions[i].dot(point.impulse) / step.dt,  // (19)
                std::clamp(settings_.gamma * last, settings_.least_stiffness, settings_.most_stiffness)};
            row.start[static_cast<int>(i)] =
                -directions[i].dot(step.dt * point.given + (1 - settings_.alpha) * row.slip);
        }
        // a gap counts in full: only what was wrong before is left as it is
        row.start.x() -= point.separation > 0 ? point.separation : (1 - settings_.alpha) * point.separation;
        rows.push_back(row);
    }
    return rows;
}
//! [rows_of]

/// Where a sweep begins: with as much of gravity as the body fell with in the last step (Chen 2024, 3.7).
void RigidAvbd::guess(RigidStep& step)
{
    const bool first = velocities_.size() != step.bodies.size();
    for (std::size_t i = 0; i < step.bodies.size(); ++i) {
        MovingBody& body = step.bodies[i];
        const Vec3 before = first ? body.velocity : velocities_[i];
        const double weight = body.gravity.squaredNorm();
        const double falls =
            weight > 0 ? std::clamp((body.velocity - before).dot(body.gravity) / (step.dt * weight), 0.0, 1.0)
                       : 0;
        MovingBody moved = body;
        moved.velocity += falls * step.dt * body.gravity;
        moved.move(step.dt);
        body.pose = moved.pose;
    }
    velocities_.clear();
    for (const MovingBody& body : step.bodies)
        velocities_.push_back(body.velocity);
}

//! [rigid_avbd]
void RigidAvbd::operator()(RigidStep& step)
{
    std::vector<Row> rows = rows_of(step);
    std::vector<std::vector<std::size_t>> rows_at(step.bodies.size());
    for (std::size_t n = 0; n < rows.size(); ++n)
        for (const int body : {rows[n].a, rows[n].b})
            rows_at[static_cast<std::size_t>(body)].push_back(n);
    std::vector<Pose> inertial;  // y of (2)
    for (const MovingBody& body : step.bodies) {
        MovingBody free = body;
        free.fall(step.dt);
        free.move(step.dt);
        inertial.push_back(free.pose);
    }
    guess(step);
    for (int sweep = 0; sweep < settings_.iterations; ++sweep) {
        for (std::size_t i = 0; i < step.bodies.size(); ++i) {
            MovingBody& body = step.bodies[i];
            if (!body.moves)
                continue;
            Matrix6 h = Matrix6::Zero();  // (5): M / dt^2 + sum of k J J^T
            h.topLeftCorner<3, 3>().diagonal().setConstant(1 / body.inverse_mass);
            h.bottomRightCorner<3, 3>() = body.inertia();
            h /= step.dt * step.dt;
            Vector6 force = h * way_between(body.pose, inertial[i]);
            for (const std::size_t n : rows_at[i]) {
                const Vec3 pushes = rows[n].push(step).force;
                const auto& j = rows[n].a == static_cast<int>(i) ? rows[n].j_a : rows[n].j_b;
                for (std::size_t k = 0; k < 3; ++k) {
                    force += pushes[static_cast<int>(k)] * j[k];
                    h += rows[n].constraints[k].stiffness * j[k] * j[k].transpose();
                }
            }
            const Vector6 way = h.ldlt().solve(force);  // (4)
            body.pose.position += way.head<3>();
            const Eigen::AngleAxisd turn(way.tail<3>().norm(), way.tail<3>().stableNormalized());
            body.pose.orientation = (turn * body.pose.orientation).normalized();
        }
        for (Row& row : rows) {
            const auto [force, is_full] = row.push(step);
            row.slips = is_full;
            constexpr double no_bound = std::numeric_limits<double>::max();
            row.constraints[0] = dual_update(row.constraints[0], row.error(step, 0), 0, no_bound, settings_);
            for (std::size_t k = 1; k < 3; ++k) {
                const double error = row.error(step, static_cast<int>(k)), now = force[static_cast<int>(k)];
                row.constraints[k] = !is_full ? dual_update(row.constraints[k], error, -no_bound, no_bound,
                                                            settings_)
                                              : AugmentedConstraint{now, row.constraints[k].stiffness};
            }
        }
    }
    keep(step, rows);
}
//! [rigid_avbd]

void RigidAvbd::keep(RigidStep& step, const std::vector<Row>& rows)
{
    kept_.clear();
    for (std::size_t n = 0; n < rows.size(); ++n) {
        ContactPoint& point = step.points[n];
        const auto& [normal, tangent_1, tangent_2] = rows[n].constraints;
        point.impulse = step.dt * (normal.multiplier * point.normal + tangent_1.multiplier * point.tangent_1 +
                                   tangent_2.multiplier * point.tangent_2);
        Vec3 slip = Vec3::Zero();  // where it slips, friction begins anew
        if (!rows[n].slips) {
            const Vec3 moved = step.difference(point, step.dt) - point.separation * point.normal;
            slip = rows[n].slip + moved - point.normal.dot(moved) * point.normal;
        }
        kept_[point.key] = {Vec3(normal.stiffness, tangent_1.stiffness, tangent_2.stiffness),
                            step.a(point).pose.orientation.conjugate() * slip};
    }
    for (MovingBody& body : step.bodies) {  // (3), BDF1
        const Vector6 way = way_between(body.start, body.pose) / step.dt;
        body.velocity = way.head<3>();
        body.angular_velocity = way.tail<3>();
    }
}

Solver chapter13_avbd_solver(const ContactParameters& parameters, const AvbdSettings& settings)
{
    return rigid_solver("AVBD", parameters, RigidAvbd(settings));
}

}  // namespace enduring
