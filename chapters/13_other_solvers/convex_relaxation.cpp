#include "chapters/13_other_solvers/convex_relaxation.hpp"

#include "chapters/13_other_solvers/impedance.hpp"

#include <Eigen/SparseCholesky>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace enduring {

//! [relaxed_answer]
RelaxedAnswer relaxed_answer(const RegularisedContact& contact, const Vec3& velocity)
{
    const double mu = contact.mu, ratio = mu * contact.r_tangent / contact.r_normal;  // mu^ of the paper
    const double y_n = (contact.free_speed - velocity.x()) / contact.r_normal;
    const Eigen::Vector2d y_t = (contact.free_slip - velocity.tail<2>()) / contact.r_tangent;
    const double y_r = y_t.norm();
    RelaxedAnswer answer;
    if (y_r <= mu * y_n) {  // holds
        answer.impulse << y_n, y_t;
        answer.hessian.diagonal() << 1 / contact.r_normal, 1 / contact.r_tangent, 1 / contact.r_tangent;
    } else if (y_n > -ratio * y_r) {  // slides
        const Eigen::Vector2d t = y_t / y_r;
        const double scale = 1 / (1 + mu * ratio), normal = scale * (y_n + ratio * y_r);
        answer.impulse << normal, mu * normal * t;
        Mat3 slope = Mat3::Zero();  // d gamma / d y
        slope(0, 0) = scale;
        slope.block<1, 2>(0, 1) = scale * ratio * t.transpose();
        slope.block<2, 1>(1, 0) = mu * scale * t;
        slope.block<2, 2>(1, 1) = mu * scale * ratio * t * t.transpose() +
                                  mu * normal / y_r * (Eigen::Matrix2d::Identity() - t * t.transpose());
        answer.hessian =
            slope * Vec3(1 / contact.r_normal, 1 / contact.r_tangent, 1 / contact.r_tangent).asDiagonal();
    }
    const Vec3 r(contact.r_normal, contact.r_tangent, contact.r_tangent);
    answer.potential = 0.5 * answer.impulse.dot(r.cwiseProduct(answer.impulse));
    return answer;
}
//! [relaxed_answer]

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Jacobian = Eigen::Matrix<double, 3, 6>;

/// A contact as rows: velocity in its frame is J_a v_a + J_b v_b + given.
struct RelaxedRow {
    RegularisedContact contact;
    int a = -1, b = -1;  ///< first coordinates of the bodies; -1 for what does not answer
    Jacobian j_a, j_b;
    Vec3 given;
};

class RelaxedProblem {
public:
    RelaxedProblem(const MethodStep& step, const RelaxedSettings& settings) : step_(step), settings_(settings)
    {
        int size = 0;
        for (const MovingBody& body : step.bodies)
            first_.push_back(body.moves ? std::exchange(size, size + 6) : -1);
        free_.resize(size);
        for (std::size_t i = 0; i < step.bodies.size(); ++i)
            if (first_[i] >= 0)
                free_.segment<6>(first_[i]) << step.bodies[i].velocity + step.dt * step.bodies[i].gravity,
                    step.bodies[i].angular_velocity;
        for (const ContactPoint& point : step.points)
            rows_.push_back(row_of(point));
    }

    /// A v, with the mass matrix A.
    VectorXd times_mass(const VectorXd& v) const
    {
        VectorXd product(v.size());
        for (std::size_t i = 0; i < step_.bodies.size(); ++i)
            if (const int at = first_[i]; at >= 0)
                product.segment<6>(at) << v.segment<3>(at) / step_.bodies[i].inverse_mass,
                    step_.bodies[i].inertia() * v.segment<3>(at + 3);
        return product;
    }

    //! [cost]
    /// l(v) = 1/2 |v - v*|_A^2 + sum of potentials (Castro 2022, (20)).
    double cost(const VectorXd& v) const
    {
        double cost = 0.5 * (v - free_).dot(times_mass(v - free_));
        for (const RelaxedRow& row : rows_)
            cost += relaxed_answer(row.contact, velocity(row, v)).potential;
        return cost;
    }
    VectorXd gradient(const VectorXd& v) const
    {
        VectorXd gradient = times_mass(v - free_);
        for (const RelaxedRow& row : rows_) {
            const Vec3 impulse = relaxed_answer(row.contact, velocity(row, v)).impulse;
            if (row.a >= 0)
                gradient.segment<6>(row.a) -= row.j_a.transpose() * impulse;
            if (row.b >= 0)
                gradient.segment<6>(row.b) -= row.j_b.transpose() * impulse;
        }
        return gradient;
    }
    //! [cost]

    Eigen::SparseMatrix<double> hessian(const VectorXd& v) const
    {
        std::vector<Eigen::Triplet<double>> entries;
        const auto add = [&](int row, int column, const Eigen::Matrix<double, 6, 6>& block) {
            for (int i = 0; i < 6; ++i)
                for (int j = 0; j < 6; ++j)
                    entries.emplace_back(row + i, column + j, block(i, j));
        };
        for (std::size_t i = 0; i < step_.bodies.size(); ++i)
            if (first_[i] >= 0) {
                Eigen::Matrix<double, 6, 6> mass = Eigen::Matrix<double, 6, 6>::Zero();
                mass.topLeftCorner<3, 3>().diagonal().setConstant(1 / step_.bodies[i].inverse_mass);
                mass.bottomRightCorner<3, 3>() = step_.bodies[i].inertia();
                add(first_[i], first_[i], mass);
            }
        for (const RelaxedRow& row : rows_) {
            const Mat3 g = relaxed_answer(row.contact, velocity(row, v)).hessian;
            for (const auto& [one, j_one] : {std::pair(row.a, &row.j_a), std::pair(row.b, &row.j_b)})
                for (const auto& [other, j_other] : {std::pair(row.a, &row.j_a), std::pair(row.b, &row.j_b)})
                    if (one >= 0 && other >= 0)
                        add(one, other, j_one->transpose() * g * *j_other);
        }
        Eigen::SparseMatrix<double> matrix(free_.size(), free_.size());
        matrix.setFromTriplets(entries.begin(), entries.end());
        return matrix;
    }

    const VectorXd& free() const { return free_; }
    int first(std::size_t body) const { return first_[body]; }
    Vec3 impulse(std::size_t point, const VectorXd& v) const
    {
        return relaxed_answer(rows_[point].contact, velocity(rows_[point], v)).impulse;
    }

private:
    static Vec3 velocity(const RelaxedRow& row, const VectorXd& v)
    {
        Vec3 velocity = row.given;
        if (row.a >= 0)
            velocity += row.j_a * v.segment<6>(row.a);
        if (row.b >= 0)
            velocity += row.j_b * v.segment<6>(row.b);
        return velocity;
    }

    //! [row_of]
    /// The near-rigid limit: R_n = beta^2 / (4 pi^2) w, so that no contact is faster than the step, and R_t =
    /// sigma w (Castro 2022, V.B).
    RelaxedRow row_of(const ContactPoint& point) const
    {
        RelaxedRow row;
        Mat3 frame;
        frame << point.normal.transpose(), point.tangent_1.transpose(), point.tangent_2.transpose();
        const auto jacobian = [&](const Vec3& r) {
            Jacobian j;
            j.leftCols<3>() = frame;
            for (int i = 0; i < 3; ++i)
                j.block<1, 3>(i, 3) = r.cross(Vec3(frame.row(i))).transpose();
            return j;
        };
        row.a = first_[static_cast<std::size_t>(point.a)];
        row.b = first_[static_cast<std::size_t>(point.b)];
        row.j_a = jacobian(step_.lever_a(point));
        row.j_b = -jacobian(step_.lever_b(point));
        row.given = frame * point.given;
        if (settings_.impedance) {
            const double w = step_.a(point).inverse_mass + step_.b(point).inverse_mass;
            row.contact = impedance_contact(*settings_.impedance, point.separation,
                                            frame * step_.relative_velocity(point), w, point.mu_s, step_.dt);
            return row;
        }
        const double w = (step_.response(point, point.normal) + step_.response(point, point.tangent_1) +
                          step_.response(point, point.tangent_2)) /
                         3;
        const double period = settings_.beta / (2 * std::numbers::pi);
        row.contact = {period * period * w, settings_.sigma * w, 0, point.mu_s};
        const double relaxes = point.separation > 0 ? 0 : settings_.dissipation * step_.dt;
        row.contact.free_speed = -point.separation / (step_.dt + relaxes);
        return row;
    }
    //! [row_of]

    const MethodStep& step_;
    const RelaxedSettings& settings_;
    std::vector<int> first_;  ///< coordinate of each body
    VectorXd free_;           ///< v*
    std::vector<RelaxedRow> rows_;
};

}  // namespace

//! [newton]
RelaxedRecord convex_relaxation(MethodStep& step, const RelaxedSettings& settings)
{
    const RelaxedProblem problem(step, settings);
    VectorXd v = problem.free();
    double momentum = problem.times_mass(v).norm();
    RelaxedRecord record;
    for (; record.newton_steps < settings.max_steps; ++record.newton_steps) {
        const VectorXd gradient = problem.gradient(v);
        momentum = std::max(momentum, problem.times_mass(v).norm());
        record.gradient = momentum > 0 ? gradient.norm() / momentum : 0;
        if (record.gradient <= settings.tolerance)
            break;
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(problem.hessian(v));
        const VectorXd direction = -factor.solve(gradient);
        const double cost = problem.cost(v), slope = gradient.dot(direction);
        double part = 1;
        for (int i = 0;
             i < settings.line_search_steps &&
             problem.cost(v + part * direction) > cost + 1e-4 * part * slope + 1e-15 * std::abs(cost);
             ++i)
            part /= 2;
        v += part * direction;
    }
    for (std::size_t i = 0; i < step.points.size(); ++i) {
        ContactPoint& point = step.points[i];
        const Vec3 impulse = problem.impulse(i, v);
        point.impulse = impulse.x() * point.normal + impulse.y() * point.tangent_1 +
                        impulse.z() * point.tangent_2;
    }
    for (std::size_t i = 0; i < step.bodies.size(); ++i)
        if (const int at = problem.first(i); at >= 0) {
            step.bodies[i].velocity = v.segment<3>(at);
            step.bodies[i].angular_velocity = v.segment<3>(at + 3);
            step.bodies[i].move(step.dt);
        }
    return record;
}
//! [newton]

Solver chapter13_relaxation_solver(const ContactParameters& parameters, const RelaxedSettings& settings)
{
    return method_solver("convex relaxation", parameters,
                         [settings](MethodStep& step) { convex_relaxation(step, settings); });
}

}  // namespace enduring
