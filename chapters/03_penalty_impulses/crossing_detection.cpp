#include "chapters/03_penalty_impulses/crossing_detection.hpp"

#include "chapters/03_penalty_impulses/crossing.hpp"

#include <algorithm>
#include <tuple>

namespace enduring {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// What makes two contacts the same pair.
using PairKey = std::tuple<ContactKind, int, int, int, int>;

PairKey key_of(const Contact& contact)
{
    return {contact.kind, contact.body_a, contact.body_b, contact.feature_a, contact.feature_b};
}

/// The pairs that are in the list already, for look-up in logarithmic time.
class KnownPairs {
public:
    explicit KnownPairs(const Contacts& contacts)
    {
        keys_.reserve(contacts.size());
        for (const Contact& contact : contacts)
            keys_.push_back(key_of(contact));
        std::sort(keys_.begin(), keys_.end());
    }
    bool contain(const Contact& contact) const { return std::binary_search(keys_.begin(), keys_.end(), key_of(contact)); }

private:
    std::vector<PairKey> keys_;
};

/// The mean outward direction of the faces at an edge, at the start of the step.
Vec3 outward_at_edge(const SurfaceStep& surface, int edge)
{
    Vec3 sum = Vec3::Zero();
    for (const int index : surface.topology.faces_at_edge(edge)) {
        if (index < 0)
            continue;
        const auto [f0, f1, f2] = surface.face(index);
        const Vec3& corner = surface.start(f0);
        sum += (surface.start(f1) - corner).cross(surface.start(f2) - corner).stableNormalized();
    }
    return sum.stableNormalized();
}

/// One direction of detection: the features of body A against those of body B.
struct PairDetection {
    const World& world;
    const KnownPairs& known;
    Contacts& contacts;

    SurfaceStep surface(int body) const { return surface_step(*world.bodies[at(body)]); }

    void vertex_face(int body_a, int vertex, int body_b, int face) const
    {
        Contact contact{ContactKind::vertex_face, body_a, body_b, vertex, face};
        if (known.contain(contact))
            return;
        const SurfaceStep a = surface(body_a), b = surface(body_b);
        const auto [f0, f1, f2] = b.face(face);
        contact.vertices = {vertex, f0, f1, f2};
        append(contact, find_entry(vertex_face_step(a, vertex, b, face), enters_face));
    }

    void edge_edge(int body_a, int edge_a, int body_b, int edge_b) const
    {
        Contact contact{ContactKind::edge_edge, body_a, body_b, edge_a, edge_b};
        if (known.contain(contact))
            return;
        const SurfaceStep a = surface(body_a), b = surface(body_b);
        const auto [a0, a1] = a.edge(edge_a);
        const auto [b0, b1] = b.edge(edge_b);
        contact.vertices = {a0, a1, b0, b1};
        const EdgeEdgeStep step = edge_edge_step(a, edge_a, b, edge_b);
        append(contact, find_entry(step, [&](const Crossing& crossing) {
            return enters_edge(step, crossing, outward_at_edge(b, edge_b) - outward_at_edge(a, edge_a));
        }));
    }

    void append(Contact& contact, const std::optional<Crossing>& entry) const
    {
        if (!entry)
            return;
        contact.weights = entry->weights;
        contact.orientation = contact.kind == ContactKind::edge_edge ? entry->orientation : 1;
        contact.start = entry->time;
        contacts.push_back(contact);
    }
};

}  // namespace

void CrossingDetection::build(const World& world)
{
    bodies_.clear();
    trees_.clear();
    body_pairs_.clear();
    for (const auto& body : world.bodies) {
        bodies_.push_back(body.get());
        trees_.emplace_back(body->surface(), body->positions_t0());
    }
    for (int a = 0; a < static_cast<int>(bodies_.size()); ++a)
        for (int b = a + 1; b < static_cast<int>(bodies_.size()); ++b)
            if (!bodies_[at(a)]->is_static() || !bodies_[at(b)]->is_static())
                body_pairs_.push_back({a, b, {}});
}

void CrossingDetection::find_candidates(const World& world)
{
    const auto same = [](const Body* mine, const std::unique_ptr<Body>& theirs) { return mine == theirs.get(); };
    if (!std::equal(bodies_.begin(), bodies_.end(), world.bodies.begin(), world.bodies.end(), same))
        build(world);
    for (std::size_t i = 0; i < trees_.size(); ++i)
        trees_[i].refit(surface_step(*world.bodies[i]));
    for (BodyPair& pair : body_pairs_)
        collect_pairs(trees_[at(pair.a)], trees_[at(pair.b)], pair.pairs);
}

//! [append_entries]
void CrossingDetection::append_entries(const World& world, Contacts& contacts) const
{
    const KnownPairs known(contacts);
    const PairDetection detect{world, known, contacts};
    for (const auto& [a, b, pairs] : body_pairs_) {
        for (const auto& [vertex, face] : pairs.vertex_face)
            detect.vertex_face(a, vertex, b, face);
        for (const auto& [face, vertex] : pairs.face_vertex)
            detect.vertex_face(b, vertex, a, face);
        for (const auto& [edge_a, edge_b] : pairs.edge_edge)
            detect.edge_edge(a, edge_a, b, edge_b);
    }
}
//! [append_entries]

std::size_t CrossingDetection::candidate_count() const
{
    std::size_t count = 0;
    for (const BodyPair& pair : body_pairs_)
        count += pair.pairs.size();
    return count;
}

}  // namespace enduring
