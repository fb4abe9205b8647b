#include "chapters/13_other_solvers/soft_step.hpp"

#include <algorithm>
#include <numbers>
#include <vector>

namespace enduring {

//! [make_soft]
Softness softness(double hertz, double damping_ratio, double h)
{
    if (hertz == 0)
        return {};
    const double omega = 2 * std::numbers::pi * hertz;
    const double a1 = 2 * damping_ratio + h * omega, a2 = h * omega * a1, a3 = 1 / (1 + a2);
    return {omega / a1, a2 * a3, a3};
}
//! [make_soft]

namespace {

/// What a contact keeps through the substeps.
struct SoftPoint {
    double normal_mass = 0;  ///< [kg]
    double tangent_mass_1 = 0, tangent_mass_2 = 0;
    double normal_impulse = 0;  ///< of this substep [N s]
    Vec3 friction = Vec3::Zero();
    double most_impulse = 0;  ///< of any substep
    double approach = 0;      ///< when the step begins [m/s]
    double slop = 0;          ///< [m]
    Vec3 sum = Vec3::Zero();  ///< of the whole step [N s]
};

double inverse(double response) { return response > 0 ? 1 / response : 0; }

class SoftStep {
public:
    SoftStep(MethodStep& step, const SoftStepSettings& settings)
        : step_(step), settings_(settings), h_(step.dt / settings.substeps)
    {
        for (const ContactPoint& point : step.points) {
            SoftPoint soft;
            soft.normal_mass = inverse(step.response(point, point.normal));
            soft.tangent_mass_1 = inverse(step.response(point, point.tangent_1));
            soft.tangent_mass_2 = inverse(step.response(point, point.tangent_2));
            const Vec3 last = point.impulse / settings.substeps;  // a substep takes its part of the load
            soft.normal_impulse = std::max(0.0, point.normal.dot(last));
            soft.friction = last - point.normal.dot(last) * point.normal;
            soft.approach = -point.normal.dot(step.relative_velocity(point));
            soft.slop = settings.slop * (step.b(point).moves
                                             ? std::min(step.a(point).size, step.b(point).size)
                                             : step.a(point).size);
            points_.push_back(soft);
        }
    }

    //! [soft_step]
    void run()
    {
        for (int substep = 0; substep < settings_.substeps; ++substep) {
            for (MovingBody& body : step_.bodies)
                body.fall(h_);
            warm_start();
            sweep(true);
            for (MovingBody& body : step_.bodies)
                body.move(h_);
            elapsed_ += h_;
            sweep(false);  // relax: what the springs have pushed beyond rest goes
            for (SoftPoint& soft : points_)
                soft.sum += soft.friction;
            for (std::size_t i = 0; i < points_.size(); ++i)
                points_[i].sum += points_[i].normal_impulse * step_.points[i].normal;
        }
        bounce();
        for (std::size_t i = 0; i < points_.size(); ++i)
            step_.points[i].impulse = points_[i].sum;
    }
    //! [soft_step]

private:
    void warm_start()
    {
        for (std::size_t i = 0; i < points_.size(); ++i)
            step_.push(step_.points[i],
                       points_[i].normal_impulse * step_.points[i].normal + points_[i].friction);
    }

    void sweep(bool with_springs)
    {
        for (std::size_t i = 0; i < points_.size(); ++i) {
            solve_normal(step_.points[i], points_[i], with_springs);
            solve_friction(step_.points[i], points_[i]);
        }
    }

    //! [solve_normal]
    void solve_normal(const ContactPoint& point, SoftPoint& soft, bool with_springs)
    {
        const double separation = point.normal.dot(step_.difference(point, elapsed_));
        double bias = 0;
        Softness spring;  // rigid
        if (separation > 0) {
            bias = separation / h_;  // it may close in this substep
        } else if (with_springs) {
            const double hertz = std::min(settings_.hertz, settings_.hertz_of_rate / h_);
            spring = softness(step_.b(point).moves ? hertz : 2 * hertz, settings_.damping_ratio, h_);
            bias = std::max(spring.bias_rate * std::min(0.0, separation + soft.slop), -settings_.push_speed);
        }
        const double speed = point.normal.dot(step_.relative_velocity(point));
        const double change = -soft.normal_mass * spring.mass_scale * (speed + bias) -
                              spring.impulse_scale * soft.normal_impulse;
        const double before = soft.normal_impulse;
        soft.normal_impulse = std::max(0.0, before + change);
        soft.most_impulse = std::max(soft.most_impulse, soft.normal_impulse);
        step_.push(point, (soft.normal_impulse - before) * point.normal);
    }
    //! [solve_normal]

    /// Both directions together, in a disc of the present normal impulse.
    void solve_friction(const ContactPoint& point, SoftPoint& soft)
    {
        const Vec3 slip = step_.relative_velocity(point);
        Vec3 sum = soft.friction - soft.tangent_mass_1 * point.tangent_1.dot(slip) * point.tangent_1 -
                   soft.tangent_mass_2 * point.tangent_2.dot(slip) * point.tangent_2;
        sum -= point.normal.dot(sum) * point.normal;
        const double bound = point.mu_s * soft.normal_impulse;
        if (sum.norm() > bound)
            sum *= bound / sum.norm();
        step_.push(point, sum - soft.friction);
        soft.friction = sum;
    }

    /// Once, when all substeps are over: contacts that have pushed and had come in fast.
    void bounce()
    {
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const ContactPoint& point = step_.points[i];
            SoftPoint& soft = points_[i];
            if (soft.approach <= settings_.restitution_threshold || soft.most_impulse == 0 ||
                point.restitution == 0)
                continue;
            const double speed = point.normal.dot(step_.relative_velocity(point));
            const double push = std::max(0.0, soft.normal_mass * (point.restitution * soft.approach - speed));
            step_.push(point, push * point.normal);
            soft.sum += push * point.normal;
        }
    }

    MethodStep& step_;
    const SoftStepSettings& settings_;
    double h_, elapsed_ = 0;
    std::vector<SoftPoint> points_;
};

}  // namespace

void soft_step(MethodStep& step, const SoftStepSettings& settings) { SoftStep(step, settings).run(); }

Solver chapter13_soft_step_solver(const ContactParameters& parameters, const SoftStepSettings& settings)
{
    return method_solver("soft step", parameters,
                         [settings](MethodStep& step) { soft_step(step, settings); });
}

}  // namespace enduring
