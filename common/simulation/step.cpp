#include "common/simulation/step.hpp"

#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <stdexcept>

namespace enduring {
namespace {

/// How often a step answers what its own answers brought about (thesis 3.3, item 4).
constexpr int max_responses = 5;

void run_passes(const std::vector<Pass>& passes, World& world, Contacts& contacts, double dt, const PassObserver& done)
{
    for (const Pass& pass : passes) {
        pass.run(world, contacts, dt);
        done(pass.name);
    }
}

/// A contact that lives on pushes from the start of the new step and has not been answered in it.
void begin_step(Contacts& contacts)
{
    for (Contact& contact : contacts) {
        contact.start = 0;
        contact.hold(contact.held());
        contact.impulse.setZero();
        contact.friction.setZero();
    }
}

bool any_waiting(const Contacts& contacts)
{
    return std::any_of(contacts.begin(), contacts.end(), [](const Contact& contact) { return contact.waiting(); });
}

/// Stops a NaN where it first shows: every later number would only repeat it.
void require_finite(const World& world, const std::string& stage)
{
    for (const std::unique_ptr<Body>& body : world.bodies) {
        const std::span<const Vec3> positions = body->positions_t1();
        for (std::size_t vertex = 0; vertex < positions.size(); ++vertex)
            if (!positions[vertex].allFinite())
                throw std::runtime_error("step " + std::to_string(world.step + 1) + ": body '" + body->name() +
                                         "', vertex " + std::to_string(vertex) + ": the position " + stage +
                                         " is not a finite number");
    }
}

void predict(World& world, double dt)
{
    for (const std::unique_ptr<Body>& body : world.bodies)
        body->predict(world.gravity, dt);
    require_finite(world, "predicted from the body's own motion");
}

void update_predictions(World& world, double dt)
{
    for (const std::unique_ptr<Body>& body : world.bodies)
        body->update_prediction(dt);
    require_finite(world, "predicted after contact impulses");
}

void commit(World& world, double dt)
{
    for (const std::unique_ptr<Body>& body : world.bodies)
        body->commit(dt);
    world.time += dt;
    ++world.step;
}

}  // namespace

//! [apply_impulses]
void apply_impulses(World& world, Contacts& contacts)
{
    for (Contact& contact : contacts) {
        if (!contact.waiting())
            continue;
        const Vec3 impulse = contact.impulse + contact.friction;
        for (int i = 0; i < contact.vertex_count(); ++i) {
            const auto vertex = static_cast<std::size_t>(i);
            body_of_vertex(world, contact, i).apply_impulse(contact.vertices[vertex], contact.weights[vertex] * impulse);
        }
        contact.state = ContactState::answered;
    }
}
//! [apply_impulses]

//! [advance]
void advance(World& world, Contacts& contacts, const Solver& solver, double dt, const PassObserver& done)
{
    predict(world, dt);
    begin_step(contacts);
    done("predict");
    run_passes(solver.refresh, world, contacts, dt, done);

    run_passes(solver.detect, world, contacts, dt, done);
    for (int n = 0; n < max_responses && any_waiting(contacts); ++n) {
        run_passes(solver.respond, world, contacts, dt, done);
        apply_impulses(world, contacts);
        done("apply impulses");
        update_predictions(world, dt);
        done("update prediction");
        run_passes(solver.detect, world, contacts, dt, done);
    }

    run_passes(solver.finish, world, contacts, dt, done);
    commit(world, dt);
    done("commit");
}
//! [advance]

}  // namespace enduring
