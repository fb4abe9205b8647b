#include "common/worked_step/step_record.hpp"

namespace enduring {
namespace {

BodyRecord record_of(const Body& body)
{
    BodyRecord record;
    record.positions_t0.assign(body.positions_t0().begin(), body.positions_t0().end());
    record.positions_t1.assign(body.positions_t1().begin(), body.positions_t1().end());
    for (int vertex = 0; vertex < body.surface().vertex_count(); ++vertex)
        record.velocities.push_back(body.velocity(vertex));
    return record;
}

StageRecord record_of(const std::string& stage, const World& world, const Contacts& contacts)
{
    StageRecord record{stage, {}, contacts};
    for (const std::unique_ptr<Body>& body : world.bodies)
        record.bodies.push_back(record_of(*body));
    return record;
}

}  // namespace

std::vector<StageRecord> record_step(World& world, Contacts& contacts, const Solver& solver, double dt)
{
    std::vector<StageRecord> records{record_of("start", world, contacts)};
    advance(world, contacts, solver, dt,
            [&](const std::string& stage) { records.push_back(record_of(stage, world, contacts)); });
    return records;
}

}  // namespace enduring
