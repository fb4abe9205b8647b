#include "chapters/04_friction/experiments/rides.hpp"
#include "chapters/04_friction/friction_contact.hpp"
#include "chapters/04_friction/solver.hpp"
#include "chapters/04_friction/surface_turn.hpp"
#include "chapters/06_redefinition/experiments/experiments.hpp"
#include "chapters/06_redefinition/solver.hpp"

namespace enduring::chapter06 {
namespace {

constexpr double micrometres = 1e6;  // in a metre

/// This chapter's solver with anchors that do not turn: what their
/// surface turns in a step is taken from them first.
Solver solver_with_world_axes(const ContactParameters& parameters)
{
    Solver solver = chapter06_solver(parameters);
    solver.insert_before(
        "move friction anchors", "turn anchors back", [](World& world, Contacts& contacts, double) {
            for (Contact& contact : contacts)
                contact.spring.stretch = surface_turn(world, contact).transpose() * contact.spring.stretch;
        });
    return solver;
}

std::string name_of(rides::Ground ground)
{
    return ground == rides::Ground::table   ? "table"
           : ground == rides::Ground::wheel ? "wheel"
                                            : "soft slab on the table";
}

double worst(const rides::RideRecord& record)
{
    return micrometres * *std::max_element(record.creep.begin(), record.creep.end());
}

}  // namespace

void turntable(const RunOptions& options, Report& report)
{
    Table table({"ground", "load", "vertex_face_pairs", "edge_edge_pairs", "world_axes_um", "chapter_4_um",
                 "chapter_6_um"});
    double most = 0, most_in_world_axes = 0;
    for (const rides::Ground ground : {rides::Ground::table, rides::Ground::wheel, rides::Ground::soft_slab})
        for (const rides::Load load : {rides::Load::block, rides::Load::grate}) {
            rides::Ride ride = rides::short_ride(ground, load);
            ride.turns = options.quick ? 1 : 2;
            const rides::RideRecord four = rides::take(ride, chapter04_solver),
                                    six = rides::take(ride, chapter06_solver);
            const double in_world_axes = worst(rides::take(ride, solver_with_world_axes));
            table.add({name_of(ground), load == rides::Load::block ? "block" : "grate",
                       static_cast<long>(six.vertex_faces), static_cast<long>(six.edge_edges), in_world_axes,
                       worst(four), worst(six)});
            most = std::max({most, worst(four), worst(six)});
            most_in_world_axes = std::max(most_in_world_axes, in_world_axes);
        }
    report.table("turntable", table);
    report.page_table("turntable", table, 2);
    report.fact("turntable", "worst_um", most, 2);
    report.fact("turntable", "worst_in_world_axes_mm", most_in_world_axes / 1000, 2);
}

}  // namespace enduring::chapter06
