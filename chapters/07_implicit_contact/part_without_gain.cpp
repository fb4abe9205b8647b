#include "chapters/07_implicit_contact/part_without_gain.hpp"

#include "chapters/07_implicit_contact/restitution.hpp"
#include "common/simulation/contact_geometry.hpp"

namespace enduring {
namespace {

/// The work that bodies which move as given, and surfaces that run, do through a pair [J].
double given_work(const World& world, const Contact& contact)
{
    double work = -contact.friction.dot(running_of_surfaces(world, contact));
    for (int i = 0; i < contact.vertex_count(); ++i) {
        const auto vertex = static_cast<std::size_t>(i);
        if (const Body& body = body_of_vertex(world, contact, i); body.is_static())
            work -= contact.weights[vertex] *
                    (contact.impulse + contact.friction).dot(body.velocity(contact.vertices[vertex]));
    }
    return work;
}

}  // namespace

//! [part_without_gain]
double part_without_gain(const World& world, const StepProblem& step)
{
    const double dt = step.problem.step.dt;
    double given = 0, held_t0 = 0, held_t1 = 0;  // the latter two of springs, twice
    for (const Contact* contact : step.of_row) {
        given += given_work(world, *contact);
        held_t0 += contact->spring.load * contact->spring.load / contact->spring.stiffness +
                   contact->spring.stiffness * contact->spring.stretch.squaredNorm();
        held_t1 += (contact->impulse + contact->friction).squaredNorm() /
                   (contact->spring.stiffness * dt * dt);
    }
    const Eigen::VectorXd momentum = momentum_of(step), change = times_response(step.problem, momentum);
    const double slope = momentum.dot(velocities_of(world, step) - change) - given;
    return allowed_part(slope, momentum.dot(change) + held_t1, held_t0 / 2);
}
//! [part_without_gain]

}  // namespace enduring
