#include "chapters/13_other_solvers/xpbd.hpp"

#include "chapters/13_other_solvers/xpbd_elements.hpp"

#include <algorithm>
#include <vector>

namespace enduring {
namespace {

/// A contact in one substep.
struct Multipliers {
    double normal = 0;         ///< lambda_n [kg m]: a force is lambda / h^2
    double tangent = 0;        ///< lambda_t
    double approach = 0;       ///< before the positions move [m/s]
    Vec3 push = Vec3::Zero();  ///< sum of position impulses [kg m]
};

class Substeps {
public:
    Substeps(MethodStep& step, const XpbdSettings& settings)
        : step_(step), settings_(settings), h_(step.dt / settings.substeps), elements_(step)
    {}

    //! [xpbd]
    void run()
    {
        for (ContactPoint& point : step_.points)
            point.impulse.setZero();  // nothing is kept from the last step
        for (int substep = 0; substep < settings_.substeps; ++substep) {
            begin();
            for (int i = 0; i < settings_.iterations; ++i) {
                elements_.sweep((substep + i) % 2 == 1);
                sweep((substep + i) % 2 == 1);
            }
            update_velocities();
            for (std::size_t n = 0; n < step_.points.size(); ++n)
                solve_velocity(step_.points[n], multipliers_[n]);
        }
    }
    //! [xpbd]

private:
    /// Forwards and backwards by turns: with one order alone, friction pumps a stack of ten until it is
    /// thrown apart.
    void sweep(bool backwards)
    {
        const std::size_t count = step_.points.size();
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t n = backwards ? count - 1 - k : k;
            solve_position(step_.points[n], multipliers_[n]);
        }
    }

    void begin()
    {
        multipliers_.assign(step_.points.size(), {});
        for (std::size_t n = 0; n < step_.points.size(); ++n)
            multipliers_[n].approach = -step_.points[n].normal.dot(step_.relative_velocity(step_.points[n]));
        before_.clear();
        for (MovingBody& body : step_.bodies) {
            before_.push_back(body.pose);
            body.fall(h_);
            body.move(h_);
        }
        places_before_.clear();
        for (SoftNode& node : step_.nodes) {
            places_before_.push_back(node.place);
            node.velocity += h_ * node.gravity;
            node.place += h_ * node.velocity;
        }
        elements_.begin(h_);
        elapsed_ += h_;
    }

    //! [correct]
    /// Moves the bodies so that an error c along a direction goes, but for its compliance (Mueller 2020, (2)
    /// to (9)).
    /// @return  the change of the multiplier [kg m]
    double correct(const ContactPoint& point, const Vec3& direction, double c, double lambda)
    {
        const double w = step_.response(point, direction);
        if (w == 0)
            return 0;
        const double compliance = settings_.compliance / (h_ * h_);
        const double change = (-c - compliance * lambda) / (w + compliance);
        const Vec3 push = change * direction;
        move(step_.a(point), push, step_.lever_a(point));
        move(step_.b(point), -push, step_.lever_b(point));
        step_.each_node(
            point, [&](SoftNode& node, double weight) { node.place += weight * node.inverse_mass * push; });
        return change;
    }

    static void move(MovingBody& body, const Vec3& push, const Vec3& r)
    {
        if (!body.moves)
            return;
        const Vec3 turn = body.inverse_inertia() * r.cross(push);
        body.pose.position += body.inverse_mass * push;
        const Quaternion by(0, 0.5 * turn.x(), 0.5 * turn.y(), 0.5 * turn.z());
        body.pose.orientation.coeffs() += (by * body.pose.orientation).coeffs();
        body.pose.orientation.normalize();
    }
    //! [correct]

    //! [solve_position]
    /// A depth goes; then a point that friction can hold goes back to where it was (Mueller 2020, 3.5), and a
    /// node that slips is moved back by what friction can (Macklin 2014, (24)).
    void solve_position(const ContactPoint& point, Multipliers& lambda)
    {
        const double depth = point.normal.dot(step_.difference(point, elapsed_));
        if (depth >= 0)
            return;
        const double push = correct(point, point.normal, depth, lambda.normal);
        lambda.normal += push;
        lambda.push += push * point.normal;

        Vec3 slip = step_.difference(point, elapsed_) - difference_before(point);
        slip -= point.normal.dot(slip) * point.normal;
        if (slip.isZero(0))
            return;
        const Vec3 along = slip.normalized();
        const double w = step_.response(point, along);
        if (w == 0)
            return;
        double length = slip.norm();
        if (lambda.tangent + length / w >= point.mu_s * lambda.normal) {
            if (!is_soft(point))
                return;  // it slips, and velocities are braked
            length = std::max(0.0, point.mu_d * lambda.normal - lambda.tangent) * w;
        }
        const double back = correct(point, along, length, 0);
        lambda.tangent -= back;
        lambda.push += back * along;
    }
    //! [solve_position]

    static bool is_soft(const ContactPoint& point)
    {
        return std::any_of(point.nodes.begin(), point.nodes.end(), [](int node) { return node >= 0; });
    }

    Vec3 difference_before(const ContactPoint& point) const
    {
        Vec3 sum = before_[static_cast<std::size_t>(point.a)].to_world(point.on_a) -
                   before_[static_cast<std::size_t>(point.b)].to_world(point.on_b) +
                   (elapsed_ - h_) * point.given;
        for (std::size_t i = 0; i < 4; ++i)
            if (point.nodes[i] >= 0)
                sum += point.weights[i] * places_before_[static_cast<std::size_t>(point.nodes[i])];
        return sum;
    }

    /// Mueller 2020, algorithm 2: v = (x - x_prev) / h, omega = 2 (q q_prev^-1)_xyz / h.
    void update_velocities()
    {
        for (std::size_t i = 0; i < step_.bodies.size(); ++i) {
            MovingBody& body = step_.bodies[i];
            if (!body.moves)
                continue;
            body.velocity = (body.pose.position - before_[i].position) / h_;
            const Quaternion turn = body.pose.orientation * before_[i].orientation.conjugate();
            body.angular_velocity = (turn.w() < 0 ? -2 : 2) * turn.vec() / h_;
        }
        for (std::size_t n = 0; n < step_.nodes.size(); ++n)
            step_.nodes[n].velocity = (step_.nodes[n].place - places_before_[n]) / h_;
    }

    //! [solve_velocity]
    /// Dynamic friction (30), by the normal force lambda / h^2, and restitution (34), without which no
    /// contact leaves. Nodes leave by their elements.
    void solve_velocity(ContactPoint& point, Multipliers& lambda)
    {
        if (lambda.normal > 0 && !is_soft(point)) {
            const Vec3 velocity = step_.relative_velocity(point);
            const double speed = point.normal.dot(velocity);
            const Vec3 slip = velocity - speed * point.normal;
            if (slip.norm() > 0)
                push(point, -slip / slip.norm(),
                     std::min(point.mu_d * lambda.normal / h_, mass(point, slip) * slip.norm()));
            // below two substeps of gravity nothing bounces
            const double slow = 2 * h_ * step_.a(point).gravity.norm();
            const double bounce = lambda.approach > slow ? point.restitution * lambda.approach : 0;
            const double missing = bounce - point.normal.dot(step_.relative_velocity(point));
            push(point, point.normal, mass(point, point.normal) * missing);
        }
        point.impulse += lambda.push / h_;
    }
    //! [solve_velocity]

    double mass(const ContactPoint& point, const Vec3& along) const
    {
        const double w = step_.response(point, along.normalized());
        return w > 0 ? 1 / w : 0;
    }
    void push(ContactPoint& point, const Vec3& direction, double impulse)
    {
        step_.push(point, impulse * direction);
        point.impulse += impulse * direction;
    }

    MethodStep& step_;
    const XpbdSettings& settings_;
    double h_, elapsed_ = 0;
    XpbdElements elements_;
    std::vector<Pose> before_;  ///< when the substep begins
    std::vector<Vec3> places_before_;
    std::vector<Multipliers> multipliers_;
};

}  // namespace

void xpbd(MethodStep& step, const XpbdSettings& settings) { Substeps(step, settings).run(); }

Solver chapter13_xpbd_solver(const ContactParameters& parameters, const XpbdSettings& settings)
{
    return method_solver(
        "XPBD", parameters, [settings](MethodStep& step) { xpbd(step, settings); }, SoftBodies::corotated);
}

}  // namespace enduring
