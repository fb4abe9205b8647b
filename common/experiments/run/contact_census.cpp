#include "common/experiments/run/contact_census.hpp"

#include "common/simulation/contact_forces.hpp"

#include <algorithm>
#include <array>

namespace enduring {

ContactCensus::ContactCensus()
    : TableProbe({"time_s", "plane", "vf_regular", "vf_hooked", "vf_other", "ee_regular", "ee_hooked",
                  "ee_other", "held", "normal_n", "friction_n"})
{}

void ContactCensus::observe(const World& world, const Contacts& contacts, double dt)
{
    constexpr std::array categories{ContactCategory::regular, ContactCategory::hooked,
                                    ContactCategory::unknown};
    long planes = 0, held = 0;
    std::array<long, 3> vertex_face{}, edge_edge{};
    double normal = 0, friction = 0;
    const double part = last_part(world, dt);
    for (const Contact& contact : contacts) {
        const auto place = static_cast<std::size_t>(
            std::find(categories.begin(), categories.end(), contact.category) - categories.begin());
        switch (contact.kind) {
            case ContactKind::vertex_plane: ++planes; break;
            case ContactKind::vertex_face: ++vertex_face[place]; break;
            case ContactKind::edge_edge: ++edge_edge[place]; break;
        }
        held += contact.held();
        const PairForce force = pair_force(contact, part);
        normal += force.normal.norm();
        friction += force.friction.norm();
    }
    table_.add({world.time, planes, vertex_face[0], vertex_face[1], vertex_face[2], edge_edge[0],
                edge_edge[1], edge_edge[2], held, normal, friction});
}

}  // namespace enduring
