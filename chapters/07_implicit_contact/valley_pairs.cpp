#include "chapters/07_implicit_contact/valley_pairs.hpp"

#include "chapters/05_categorisation/category.hpp"
#include "chapters/06_redefinition/contact_index.hpp"
#include "chapters/06_redefinition/face_choice.hpp"
#include "chapters/07_implicit_contact/normal_cone.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace enduring {
namespace {

/// Sine of an angle that is none but for rounding.
constexpr double in_plane = 1e-9;

/// Sine of a fold from which on a vertex lies in a hollow. A soft body's flat side is folded by less, and its vertices
/// have to carry it.
constexpr double least_hollow = 0.01;

bool in_front_of(const SurfaceMoment& b, int face, int other)
{
    const Vec3 normal = b.face_normal(other).normalized(), corner = b.position(b.step.face(other)[0]);
    const Face corners = b.step.face(face);
    return std::all_of(corners.begin(), corners.end(), [&](int vertex) {
        const Vec3 from = b.position(vertex) - corner;
        return normal.dot(from) >= -in_plane * from.norm();
    });
}

/// Whether two faces look at each other, or the same way.
bool look_at_each_other(const SurfaceMoment& b, int face, int other)
{
    return in_front_of(b, face, other) && in_front_of(b, other, face);
}

/// Whether two faces look at each other, and not nearly the same way.
bool are_walls_of_a_valley(const SurfaceMoment& b, int face, int other)
{
    return !is_within_45_degrees(b.face_normal(face), b.face_normal(other)) &&
           look_at_each_other(b, face, other);
}

/// Whether a face is another wall, and a vertex can be pushed by it.
bool is_other_wall(const PairSurfaces& surfaces, const Contact& own, int face)
{
    const Vec3 normal = surfaces.b.face_normal(face);
    return normal.squaredNorm() > 0 && are_walls_of_a_valley(surfaces.b, face, own.feature_b) &&
           cone_reaches(surfaces.a, surfaces.a.step.topology.faces_around_vertex(own.feature_a), -normal,
                        hook_cosine);
}

Contact pair_with(const Contact& own, const SurfaceTopology& surface_b, int face, const TriangleFoot& foot)
{
    Contact pair{ContactKind::vertex_face, own.body_a, own.body_b, own.feature_a, face};
    pair.vertices[0] = own.feature_a;
    pair.weights[0] = 1;
    pair.start = own.start;
    pair.category = ContactCategory::regular;
    put_on_face(pair, surface_b, face, foot.weights);
    return pair;
}

/// Whether a vertex is behind a pair's plane, or comes there in the step with as much way again.
bool is_within_reach(const World& world, const Contact& pair)
{
    const ContactGeometry start = contact_geometry(world, pair, 0), end = contact_geometry(world, pair, 1);
    const double way = ((end.p - end.q) - (start.p - start.q)).norm();
    return std::min(start.depth, end.depth) < way;
}

//! [other_walls]
/// Pairs with the walls of a valley that the vertex of a pair can reach, one for each wall.
Contacts pairs_with_other_walls(const World& world, const Contact& own)
{
    const PairSurfaces surfaces(world, own, 0);
    std::vector<std::pair<double, Contact>> walls;
    visit_candidates(surfaces, own, all_corners, [&](int face) {
        if (!is_other_wall(surfaces, own, face))
            return;
        const TriangleFoot foot = *foot_on_face(surfaces.a, own.feature_a, surfaces.b, face);
        const Contact pair = pair_with(own, surfaces.b.step.topology, face, foot);
        if (is_within_reach(world, pair))
            walls.emplace_back(overshoot(foot.weights), pair);
    });
    std::stable_sort(walls.begin(), walls.end(),
                     [](const auto& one, const auto& other) { return one.first < other.first; });
    Contacts one_each;
    for (const auto& [beyond, pair] : walls) {
        const Vec3 normal = surfaces.b.face_normal(pair.feature_b);
        if (std::none_of(one_each.begin(), one_each.end(), [&](const Contact& nearer) {
                return is_within_45_degrees(normal, surfaces.b.face_normal(nearer.feature_b));
            }))
            one_each.push_back(pair);
    }
    return one_each;
}
//! [other_walls]

bool can_stand_in_a_valley(const Contact& contact)
{
    return contact.kind == ContactKind::vertex_face && contact.is_spring() &&
           contact.category == ContactCategory::regular;
}

/// A pair goes on with what another one's spring holds.
void take_over(Contact& contact, const Contact& other)
{
    contact.stiffness = other.stiffness;
    contact.slack = other.slack;
    contact.load = other.load;
    contact.stretch = other.stretch;
    contact.slip = other.slip;
}

bool push_from_one_wall(const World& world, const Contact& pair, const Contact& other)
{
    const SurfaceMoment b = surface_at(*world.bodies[pair.body_b], 0);
    return is_within_45_degrees(b.face_normal(pair.feature_b), b.face_normal(other.feature_b));
}

/// Index of the pair that is the own one of another pair's vertex; -1 for a pair of another kind.
int own_pair(const VertexContacts& index, const Contact& pair)
{
    return pair.kind == ContactKind::vertex_face && !pair.resolved
               ? index.find(pair.body_a, pair.feature_a, pair.body_b)
               : -1;
}

}  // namespace

void append_pairs_with_other_walls(const World& world, Contacts& contacts)
{
    const VertexContacts index(contacts);
    const std::size_t count = contacts.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (!can_stand_in_a_valley(contacts[i]) || own_pair(index, contacts[i]) != static_cast<int>(i))
            continue;
        for (const Contact& pair : pairs_with_other_walls(world, contacts[i]))
            if (std::none_of(contacts.begin(), contacts.end(), [&](const Contact& known) {
                    return own_pair(index, known) == static_cast<int>(i) &&
                           push_from_one_wall(world, known, pair);
                }))
                contacts.push_back(pair);
    }
}

void ValleyPairs::set_aside(Contacts& contacts)
{
    const VertexContacts index(contacts);
    std::map<int, Contacts> others;  // by the index of the own pair
    Contacts own;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const int first = own_pair(index, contacts[i]);
        (first < 0 || first == static_cast<int>(i) ? own : others[first]).push_back(contacts[i]);
    }
    aside_.clear();
    for (const auto& [first, pairs] : others)
        aside_.push_back({contacts[first], pairs});
    contacts = std::move(own);
}

void ValleyPairs::put_back(Contacts& contacts)
{
    const VertexContacts index(contacts);
    for (const Valley& valley : aside_)
        if (own_pair(index, valley.own) >= 0)
            contacts.insert(contacts.end(), valley.others.begin(), valley.others.end());
    aside_.clear();
}

void ValleyPairs::follow(const World& world, Contacts& contacts)
{
    const VertexContacts index(contacts);
    for (const Valley& valley : aside_) {
        const int own = own_pair(index, valley.own);
        if (own < 0 || !can_stand_in_a_valley(contacts[own]))
            continue;
        const auto spring_at = [&](const Contact& wall) -> const Contact* {
            if (push_from_one_wall(world, wall, valley.own))
                return &valley.own;
            const auto found = std::find_if(
                valley.others.begin(), valley.others.end(),
                [&](const Contact& pair) { return push_from_one_wall(world, wall, pair); });
            return found != valley.others.end() ? &*found : nullptr;
        };
        const Contact* spring = spring_at(contacts[own]);
        if (spring != nullptr && spring != &valley.own)
            take_over(contacts[own], *spring);
        for (Contact& pair : pairs_with_other_walls(world, contacts[own]))
            if (const Contact* before = spring_at(pair)) {
                take_over(pair, *before);
                contacts.push_back(pair);
            }
    }
    aside_.clear();
}

namespace {

//! [concave]
/// Sine of the angle by which the two faces of an edge look towards each other; 0 at a border, or for a face
/// without area.
double sine_of_hollow(const Body& body, int edge)
{
    const auto [face, other] = body.surface().faces_at_edge(edge);
    if (face < 0 || other < 0)
        return 0;
    const SurfaceMoment surface = surface_at(body, 0);
    const double sine = surface.face_normal(face)
                            .stableNormalized()
                            .cross(surface.face_normal(other).stableNormalized())
                            .norm();
    return look_at_each_other(surface, face, other) ? sine : -sine;
}

/// Whether an edge cannot touch anything with this normal: it is concave, or flat and the normal is not that of its side.
bool cannot_push_along(const Body& body, int edge, const Vec3& normal)
{
    const double sine = sine_of_hollow(body, edge);
    if (std::abs(sine) > in_plane)
        return sine > 0;
    const int face = body.surface().faces_at_edge(edge)[0];
    const bool is_border = face < 0 || body.surface().faces_at_edge(edge)[1] < 0;
    return !is_border &&
           surface_at(body, 0).face_normal(face).stableNormalized().cross(normal).norm() > least_hollow;
}

bool is_in_a_hollow(const Body& body, int vertex)
{
    bool hollow = false;
    for (const int edge : body.surface().edges_around_vertex(vertex)) {
        const double sine = sine_of_hollow(body, edge);
        if (sine < 0)
            return false;
        hollow = hollow || sine > least_hollow;
    }
    return hollow;
}
//! [concave]

bool cannot_touch(const World& world, const Contact& pair)
{
    const Body& a = *world.bodies[pair.body_a];
    switch (pair.kind) {
        case ContactKind::edge_edge: {
            const Vec3 normal = contact_geometry(world, pair, pair.start).normal;
            return cannot_push_along(a, pair.feature_a, normal) ||
                   cannot_push_along(*world.bodies[pair.body_b], pair.feature_b, normal);
        }
        case ContactKind::vertex_face: return is_in_a_hollow(a, pair.feature_a);
        case ContactKind::vertex_plane: break;
    }
    return false;
}

}  // namespace

void drop_what_cannot_touch(const World& world, Contacts& contacts)
{
    contacts.erase(std::remove_if(contacts.begin(), contacts.end(),
                                  [&](const Contact& pair) { return cannot_touch(world, pair); }),
                   contacts.end());
}

}  // namespace enduring
