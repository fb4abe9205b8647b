#include "chapters/13_other_solvers/avbd.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace enduring {

//! [rows_of]
std::vector<AvbdRow> Avbd::rows_of(const MethodStep& step) const
{
    std::vector<AvbdRow> rows;
    for (const ContactPoint& point : step.points) {
        AvbdRow row(step, point);
        const auto known = kept_.find(point.key);
        if (known != kept_.end())
            row.slip = step.a(point).pose.orientation * known->second.slip;
        for (std::size_t i = 0; i < 3; ++i) {
            const double last = known == kept_.end() ? 0 : known->second.stiffness[static_cast<int>(i)];
            row.constraints[i] = {
                settings_.alpha * settings_.gamma * row.directions[i].dot(point.impulse) / step.dt,  // (19)
                std::clamp(settings_.gamma * last, settings_.least_stiffness, settings_.most_stiffness)};
            row.start[static_cast<int>(i)] =
                -row.directions[i].dot(step.dt * point.given + (1 - settings_.alpha) * row.slip);
        }
        // a gap counts in full: only what was wrong before is left as it is
        row.start.x() -= point.separation > 0 ? point.separation : (1 - settings_.alpha) * point.separation;
        rows.push_back(row);
    }
    return rows;
}
//! [rows_of]

namespace {

/// The part of gravity with which something fell in the last step.
double falling_part(const Vec3& velocity, const Vec3& before, const Vec3& gravity, double dt)
{
    const double weight = gravity.squaredNorm();
    return weight > 0 ? std::clamp((velocity - before).dot(gravity) / (dt * weight), 0.0, 1.0) : 0;
}

}  // namespace

/// Where a sweep begins: with as much of gravity as the body fell with in the last step (Chen 2024, 3.7).
void Avbd::guess(MethodStep& step)
{
    const bool first = velocities_.size() != step.bodies.size();
    for (std::size_t i = 0; i < step.bodies.size(); ++i) {
        MovingBody& body = step.bodies[i];
        const Vec3 before = first ? body.velocity : velocities_[i];
        MovingBody moved = body;
        moved.velocity += falling_part(body.velocity, before, body.gravity, step.dt) * step.dt * body.gravity;
        moved.move(step.dt);
        body.pose = moved.pose;
    }
    for (std::size_t n = 0; n < step.nodes.size(); ++n) {
        SoftNode& node = step.nodes[n];
        const Vec3 before = first ? node.velocity : node_velocities_[n];
        const double falls = falling_part(node.velocity, before, node.gravity, step.dt);
        node.place = node.start + step.dt * (node.velocity + falls * step.dt * node.gravity);
    }
    velocities_.clear();
    for (const MovingBody& body : step.bodies)
        velocities_.push_back(body.velocity);
    node_velocities_.clear();
    for (const SoftNode& node : step.nodes)
        node_velocities_.push_back(node.velocity);
}

//! [solve_body]
void Avbd::solve_body(MethodStep& step, std::size_t i, const Pose& inertial,
                      const std::vector<const AvbdRow*>& rows)
{
    MovingBody& body = step.bodies[i];
    Matrix6 h = Matrix6::Zero();  // (5): M / dt^2 + sum of k J J^T
    h.topLeftCorner<3, 3>().diagonal().setConstant(1 / body.inverse_mass);
    h.bottomRightCorner<3, 3>() = body.inertia();
    h /= step.dt * step.dt;
    Vector6 force = h * way_between(body.pose, inertial);
    for (const AvbdRow* row : rows) {
        const Vec3 pushes = row->push(step).force;
        const auto& j = row->point->a == static_cast<int>(i) ? row->j_a : row->j_b;
        for (std::size_t k = 0; k < 3; ++k) {
            force += pushes[static_cast<int>(k)] * j[k];
            h += row->constraints[k].stiffness * j[k] * j[k].transpose();
        }
    }
    const Vector6 way = h.ldlt().solve(force);  // (4)
    body.pose.position += way.head<3>();
    const Eigen::AngleAxisd turn(way.tail<3>().norm(), way.tail<3>().stableNormalized());
    body.pose.orientation = (turn * body.pose.orientation).normalized();
}
//! [solve_body]

/// What pulls at each node.
struct Avbd::Around {
    struct Row {
        const AvbdRow* row;
        double weight;
    };
    struct Element {
        const SoftElements* body;
        std::size_t index;
        int corner;
    };
    std::vector<Row> rows;
    std::vector<Element> elements;
};

//! [solve_node]
/// The local system of a node (Chen et al. 2024): m / dt^2, elements and contacts.
void Avbd::solve_node(MethodStep& step, std::size_t n, const Vec3& inertial, const Around& around)
{
    SoftNode& node = step.nodes[n];
    const double rate = 1 / (node.inverse_mass * step.dt * step.dt);
    Mat3 h = rate * Mat3::Identity();
    Vec3 force = rate * (inertial - node.place);
    for (const auto& [body, index, corner] : around.elements) {
        const auto [slope, stiffness] = body->at_corner(index, corner, corners_now(step, body->nodes(index)));
        force -= slope;
        h += stiffness;
    }
    for (const auto& [row, weight] : around.rows) {
        const Vec3 pushes = row->push(step).force;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& d = row->directions[k];
            force += weight * pushes[static_cast<int>(k)] * d;
            h += weight * weight * row->constraints[k].stiffness * d * d.transpose();
        }
    }
    node.place += h.ldlt().solve(force);
}
//! [solve_node]

//! [avbd]
void Avbd::operator()(MethodStep& step)
{
    std::vector<AvbdRow> rows = rows_of(step);
    std::vector<std::vector<const AvbdRow*>> at_body(step.bodies.size());
    std::vector<Around> at_node(step.nodes.size());
    for (const AvbdRow& row : rows) {
        for (const int body : {row.point->a, row.point->b})
            at_body[static_cast<std::size_t>(body)].push_back(&row);
        for (std::size_t i = 0; i < 4; ++i)
            if (row.point->nodes[i] >= 0)
                at_node[static_cast<std::size_t>(row.point->nodes[i])].rows.push_back(
                    {&row, row.point->weights[i]});
    }
    const std::vector<SoftElements> elements(step.soft.begin(), step.soft.end());
    for (const SoftElements& body : elements)
        for (std::size_t e = 0; e < body.count(); ++e)
            for (int corner = 0; corner < 4; ++corner)
                at_node[body.nodes(e)[static_cast<std::size_t>(corner)]].elements.push_back(
                    {&body, e, corner});
    std::vector<Pose> inertial;  // y of (2)
    for (const MovingBody& body : step.bodies) {
        MovingBody free = body;
        free.fall(step.dt);
        free.move(step.dt);
        inertial.push_back(free.pose);
    }
    guess(step);
    for (int sweep = 0; sweep < settings_.iterations; ++sweep) {
        for (std::size_t i = 0; i < step.bodies.size(); ++i)
            if (step.bodies[i].moves)
                solve_body(step, i, inertial[i], at_body[i]);
        for (std::size_t n = 0; n < step.nodes.size(); ++n) {
            const SoftNode& node = step.nodes[n];
            const Vec3 free = node.start + step.dt * (node.velocity + step.dt * node.gravity);
            if (node.inverse_mass > 0)
                solve_node(step, n, free, at_node[n]);
        }
        for (AvbdRow& row : rows)
            row.update(step, settings_);
    }
    keep(step, rows);
}
//! [avbd]

void Avbd::keep(MethodStep& step, const std::vector<AvbdRow>& rows)
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
    for (SoftNode& node : step.nodes)
        node.velocity = (node.place - node.start) / step.dt;
}

Solver chapter13_avbd_solver(const ContactParameters& parameters, const AvbdSettings& settings)
{
    return method_solver("AVBD", parameters, Avbd(settings), SoftBodies::any_law);
}

}  // namespace enduring
