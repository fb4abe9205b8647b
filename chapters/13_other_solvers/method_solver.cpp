#include "chapters/13_other_solvers/method_solver.hpp"

#include "chapters/13_other_solvers/near_features.hpp"
#include "chapters/13_other_solvers/step_bodies.hpp"
#include "common/simulation/deformable_body.hpp"

#include <map>
#include <memory>
#include <utility>

namespace enduring {
namespace {

/// What lasts beyond a step: the search's trees, and of each pair its impulse, which turns with body A.
class MethodRun {
public:
    MethodRun(const ContactParameters& parameters, StepMethod method, SoftBodies soft, PairSearch search)
        : friction_(coefficients_of(parameters.friction)), method_(std::move(method)), soft_(soft),
          search_(std::move(search))
    {}

    void find(World& world, Contacts& contacts, double dt)
    {
        step_ = step_bodies(world, dt, soft_);
        contacts = search_(world);
        for (const Contact& contact : contacts) {
            step_.points.push_back(contact_point(world, step_, contact, friction_));
            ContactPoint& point = step_.points.back();
            if (const auto old = impulses_.find(point.key); old != impulses_.end())
                point.impulse = step_.a(point).pose.orientation * old->second;
        }
    }

    void solve(World& world, Contacts& contacts)
    {
        method_(step_);
        if (!step_.is_solved)
            world.attempt.trouble = StepTrouble::unsolved;
        world.attempt.added_energy += step_.given;
        impulses_.clear();
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const ContactPoint& point = step_.points[i];
            contacts[i].impulse = point.normal.dot(point.impulse) * point.normal;
            contacts[i].friction = point.impulse - contacts[i].impulse;
            contacts[i].state = ContactState::answered;
            if (!point.impulse.isZero(0))
                impulses_[point.key] = step_.a(point).pose.orientation.conjugate() * point.impulse;
        }
        move_bodies(world);
        move_soft_bodies(world,
                         [&](const SoftNode& node) { return Vec3((node.place - node.start) / step_.dt); });
    }

    //! [leave]
    /// Behind the commit: velocities are those that the method ends with, whatever the way of the step was.
    void leave(World& world)
    {
        for (std::size_t i = 0; i < world.bodies.size(); ++i)
            if (!kicks_[i].isZero(0))
                world.bodies[i]->kick({}, kicks_[i], step_.dt);
        move_soft_bodies(world, [](const SoftNode& node) { return node.velocity; });
        for (const SoftBody& soft : step_.soft)
            world.bodies[soft.body]->stand_still();
    }
    //! [leave]

private:
    //! [move_bodies]
    /// Momenta with which the commit brings each body to the pose that the method has found; what the
    /// velocity at the end lacks comes behind it.
    void move_bodies(World& world)
    {
        kicks_.assign(world.bodies.size(), Eigen::VectorXd::Zero(6));
        for (std::size_t i = 0; i < world.bodies.size(); ++i) {
            const MovingBody& moving = step_.bodies[i];
            if (!moving.moves)
                continue;
            const Vec3 way = (moving.pose.position - moving.start.position) / step_.dt;
            const Vec3 turn =
                rotation_vector(moving.pose.orientation * moving.start.orientation.conjugate()) / step_.dt;
            Body& body = *world.bodies[i];
            const Eigen::VectorXd predicted = body.contact_coordinates().contact_velocity({});
            const Mat3 axes = moving.start.orientation.toRotationMatrix();
            const Mat3 inertia_t0 = axes * moving.inertia_in_body * axes.transpose();
            Eigen::VectorXd impulse(6);
            impulse << (way - predicted.head<3>()) / moving.inverse_mass,
                inertia_t0 * (turn - predicted.tail<3>());
            body.contact_coordinates().apply_contact_impulse({}, impulse);
            body.update_prediction(step_.dt);
            kicks_[i] << (moving.velocity - way) / moving.inverse_mass,
                moving.inertia() * (moving.angular_velocity - turn);
        }
    }
    //! [move_bodies]

    /// The nodes of each soft body get these velocities.
    template <class Velocity>
    void move_soft_bodies(World& world, const Velocity& velocity_of)
    {
        for (const SoftBody& soft : step_.soft) {
            auto& body = dynamic_cast<DeformableBody&>(*world.bodies[soft.body]);
            NodalVectors velocities(3, body.elastic().node_count());
            for (int n = 0; n < velocities.cols(); ++n)
                velocities.col(n) = velocity_of(step_.nodes[soft.first + static_cast<std::size_t>(n)]);
            body.take_velocities(velocities, step_.dt);
        }
    }

    FrictionCoefficients friction_;
    StepMethod method_;
    SoftBodies soft_;
    PairSearch search_;
    MethodStep step_;
    std::map<PairKey, Vec3> impulses_;  ///< in the axes of A
    std::vector<Eigen::VectorXd> kicks_;
};

}  // namespace

Solver method_solver(const std::string& name, const ContactParameters& parameters, StepMethod method,
                     SoftBodies soft, PairSearch search)
{
    const auto run = std::make_shared<MethodRun>(parameters, std::move(method), soft, std::move(search));
    Solver solver;
    solver.name = name;
    solver.append(StepStage::refresh, "find near features",
                  [run](World& world, Contacts& contacts, double dt) { run->find(world, contacts, dt); });
    solver.append(StepStage::refresh, name,
                  [run](World& world, Contacts& contacts, double) { run->solve(world, contacts); });
    solver.append(StepStage::after_commit, "leave velocities",
                  [run](World& world, Contacts&, double) { run->leave(world); });
    return solver;
}

Solver method_solver(const std::string& name, const ContactParameters& parameters, StepMethod method,
                     SoftBodies soft, const SearchSettings& search)
{
    const auto near = std::make_shared<NearFeatures>(search);
    return method_solver(name, parameters, std::move(method), soft,
                         PairSearch([near](World& world) { return near->find(world); }));
}

}  // namespace enduring
