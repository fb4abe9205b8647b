#include "chapters/06_redefinition/resolution.hpp"

#include "chapters/02_collision_detection/edge_triangle.hpp"
#include "chapters/03_penalty_impulses/crossing.hpp"
#include "chapters/06_redefinition/contact_index.hpp"

#include <span>
#include <vector>

namespace enduring {
namespace {

const Body& body(const World& world, int index) { return *world.bodies[index]; }

/// A vertex with a pair passes through a face of the pair's body.
struct Passage {
    int contact;  ///< index into the list
    int face;
    Crossing crossing;
};

bool are_at_once(double time, double later) { return later - time <= 2 * time_of_impact_slack; }

//! [passages]
/// All passages of the step, those of a contact together and in their order.
std::vector<Passage> find_passages(const World& world, const CandidateSearch& search,
                                   const Contacts& contacts)
{
    const VertexContacts in_contact(contacts);
    std::vector<Passage> passages;
    search.visit_candidates(
        [&](int body_a, int vertex, int body_b, int face) {
            const int contact = in_contact.find(body_a, vertex, body_b);
            if (contact < 0)
                return;
            const VertexFaceStep step = vertex_face_step(surface_step(body(world, body_a)), vertex,
                                                         surface_step(body(world, body_b)), face);
            find_entry(step, [&](const Crossing& crossing) {
                if (crossing.orientation != 0)
                    passages.push_back({contact, face, crossing});
                return false;  // none is the one looked for: go through all
            });
        },
        [](int, int, int, int) {});
    std::sort(passages.begin(), passages.end(), [](const Passage& one, const Passage& other) {
        return std::tie(one.contact, one.crossing.time, one.face) <
               std::tie(other.contact, other.crossing.time, other.face);
    });
    return passages;
}
//! [passages]

/// Where a vertex is after its passages, and through which it went last.
struct PassageResult {
    bool inside;
    bool came_back = false;  ///< it was inside, left, and is inside again
    const Passage* last = nullptr;
};

//! [follow_passages]
/// @param inside  at the start of the step
PassageResult follow_passages(std::span<const Passage> passages, bool inside)
{
    PassageResult now{inside};
    bool has_left = false;
    for (std::size_t i = 0; i < passages.size();) {
        // Through an edge, a vertex passes both its faces at once. If they disagree it grazes a ridge: then
        // it counts as inside, for a pair too many is resolved later, and one too few is never found again.
        const double time = passages[i].crossing.time;
        const Passage* entry = nullptr;
        const Passage* exit = nullptr;
        for (; i < passages.size() && are_at_once(time, passages[i].crossing.time); ++i)
            (passages[i].crossing.orientation > 0 ? entry : exit) = &passages[i];
        now.inside = entry != nullptr;
        now.last = entry != nullptr ? entry : exit;
        now.came_back = now.inside && (now.came_back || has_left);
        has_left = has_left || (inside && !now.inside);
    }
    return now;
}
//! [follow_passages]

/// A pair at the place where a vertex came back in.
Contact pair_at(const World& world, const Contact& before, const Passage& entry)
{
    Contact pair{ContactKind::vertex_face, before.body_a, before.body_b, before.feature_a, entry.face};
    const auto& w = entry.crossing.weights;
    pair.vertices[0] = before.feature_a;
    pair.weights[0] = 1;
    put_on_face(pair, body(world, before.body_b).surface(), entry.face, {-w[1], -w[2], -w[3]});
    return pair;
}

}  // namespace

//! [resolve_vertices]
void resolve_vertices_that_left(const World& world, const CandidateSearch& search, Contacts& contacts,
                                Redefinitions& redefinitions)
{
    const std::vector<Passage> passages = find_passages(world, search, contacts);
    auto next = passages.begin();
    const std::size_t count = contacts.size();
    for (std::size_t i = 0; i < count; ++i) {
        const auto first = next;
        while (next != passages.end() && next->contact == static_cast<int>(i))
            ++next;
        if (contacts[i].kind != ContactKind::vertex_face || contacts[i].resolved)
            continue;
        const bool endures = contacts[i].endures();
        const std::span<const Passage> of_this_pair(passages.data() + (first - passages.begin()),
                                                    static_cast<std::size_t>(next - first));
        const PassageResult end = follow_passages(of_this_pair, endures);
        contacts[i].resolved = !end.inside || end.came_back;
        if (end.came_back)
            contacts.push_back(pair_at(world, contacts[i], *end.last));
        else if (endures && !end.inside && end.last->face != contacts[i].feature_b && !contacts[i].held()) {
            const Contact& c = contacts[i];
            const Vec3 normal = surface_at(body(world, c.body_b), 1).face_normal(c.feature_b);
            redefinitions.push_back({c.body_a, c.feature_a, c.body_b, c.feature_b, end.last->face, normal});
        }
    }
}
//! [resolve_vertices]

namespace {

//! [edge_is_outside]
/// Whether an edge lies outside a body at the end of the step.
bool is_outside(const World& world, const CandidateSearch& search, const VertexContacts& in_contact,
                int edge_body, int edge, int other)
{
    const SurfaceStep mine = surface_step(body(world, edge_body)), theirs = surface_step(body(world, other));
    const auto [e0, e1] = mine.edge(edge);
    if (in_contact.find(edge_body, e0, other) >= 0 || in_contact.find(edge_body, e1, other) >= 0)
        return false;
    const Vec3 &from = mine.end(e0), &to = mine.end(e1);
    const RestNeighbours* neighbours = rest_neighbours(world, edge_body, other);
    bool pierces = false;
    search.visit_faces_near(other, edge_box(mine, edge), [&](int face) {
        if (neighbours && neighbours->edge_and_face(edge, face))
            return;
        const auto [f0, f1, f2] = theirs.face(face);
        pierces = pierces || find_edge_triangle_hit(from, to, theirs.end(f0), theirs.end(f1), theirs.end(f2));
    });
    return !pierces;
}
//! [edge_is_outside]

}  // namespace

void resolve_edges_that_left(const World& world, const CandidateSearch& search, Contacts& contacts)
{
    const VertexContacts in_contact(contacts);
    for (Contact& c : contacts)
        if (c.kind == ContactKind::edge_edge && !c.resolved)
            c.resolved = is_outside(world, search, in_contact, c.body_a, c.feature_a, c.body_b) ||
                         is_outside(world, search, in_contact, c.body_b, c.feature_b, c.body_a);
}

void drop_resolved(Contacts& contacts)
{
    contacts.erase(std::remove_if(contacts.begin(), contacts.end(),
                                  [](const Contact& contact) { return contact.resolved; }),
                   contacts.end());
}

}  // namespace enduring
