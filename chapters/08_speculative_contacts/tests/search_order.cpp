#include "chapters/08_speculative_contacts/contact_search.hpp"
#include "chapters/08_speculative_contacts/experiments/shapes.hpp"
#include "chapters/08_speculative_contacts/solver.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <set>

using namespace enduring;
using namespace enduring::chapter08;

namespace {

/// Numbers from 0 on, in any order.
std::vector<int> shuffled(int count, Numbers& numbers)
{
    std::vector<int> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    for (int i = count - 1; i > 0; --i)
        std::swap(order[static_cast<std::size_t>(i)], order[static_cast<std::size_t>(numbers.below(i + 1))]);
    return order;
}

/// A pair by the vertices of its features, as those of one body and of the other.
using Side = std::pair<int, std::set<int>>;  // body, vertices
using NamedPair = std::pair<ContactKind, std::set<Side>>;

/// Other numbers for bodies, vertices and faces.
class Shuffle {
public:
    Shuffle(const World& world, unsigned seed) : numbers_(seed)
    {
        bodies_ = shuffled(static_cast<int>(world.bodies.size()), numbers_);
        for (const int body : bodies_)
            vertices_.push_back(
                shuffled(world.bodies[static_cast<std::size_t>(body)]->surface().vertex_count(), numbers_));
    }

    /// A copy of the world under the other numbers, with the next step foreseen.
    World copy(const World& world, double dt)
    {
        World other;
        other.planes = world.planes;
        other.gravity = world.gravity;
        for (std::size_t i = 0; i < bodies_.size(); ++i)
            other.bodies.push_back(
                copy(dynamic_cast<const RigidBody&>(*world.bodies[static_cast<std::size_t>(bodies_[i])]),
                     vertices_[i]));
        for (const auto& body : other.bodies)
            body->predict(other.gravity, dt);
        return other;
    }

    /// A copy's bodies that are the world's own, under their own numbers.
    static Shuffle none(const World& world)
    {
        Shuffle same(world, 1);
        std::iota(same.bodies_.begin(), same.bodies_.end(), 0);
        for (std::size_t i = 0; i < same.vertices_.size(); ++i) {
            same.vertices_[i].resize(static_cast<std::size_t>(world.bodies[i]->surface().vertex_count()));
            std::iota(same.vertices_[i].begin(), same.vertices_[i].end(), 0);
        }
        return same;
    }

    /// A pair of the copy, as the world numbers its features.
    NamedPair name(const Contact& contact) const
    {
        const auto side = [&](int body, std::span<const int> vertices) {
            Side named{bodies_[static_cast<std::size_t>(body)], {}};
            for (const int vertex : vertices)
                named.second.insert(
                    vertices_[static_cast<std::size_t>(body)][static_cast<std::size_t>(vertex)]);
            return named;
        };
        const auto& [v0, v1, v2, v3] = contact.vertices;
        switch (contact.kind) {
            case ContactKind::vertex_plane:
                return {contact.kind, {side(contact.body_a, std::array{v0}), Side{-1 - contact.body_b, {}}}};
            case ContactKind::vertex_face:
                return {contact.kind,
                        {side(contact.body_a, std::array{v0}), side(contact.body_b, std::array{v1, v2, v3})}};
            default:
                return {contact.kind,
                        {side(contact.body_a, std::array{v0, v1}), side(contact.body_b, std::array{v2, v3})}};
        }
    }

private:
    std::unique_ptr<Body> copy(const RigidBody& body, const std::vector<int>& order)
    {
        const int count = body.surface().vertex_count();
        std::vector<int> place(order.size());
        SurfaceMesh mesh;
        for (int i = 0; i < count; ++i) {
            const int from = order[static_cast<std::size_t>(i)];
            mesh.vertices.push_back(body.positions_t0()[static_cast<std::size_t>(from)]);
            place[static_cast<std::size_t>(from)] = i;
        }
        const auto faces = body.surface().faces();
        for (const int face : shuffled(static_cast<int>(faces.size()), numbers_)) {  // faces without names
            Face moved = faces[static_cast<std::size_t>(face)];
            for (int& vertex : moved)
                vertex = place[static_cast<std::size_t>(vertex)];
            std::rotate(moved.begin(), moved.begin() + numbers_.below(3), moved.end());
            mesh.faces.push_back(moved);
        }
        return std::make_unique<RigidBody>(body.name(), mesh,
                                           with_mass(mass_properties(mesh, 1000), body.mass()),
                                           body.motion().velocity(), body.motion().angular_velocity());
    }

    Numbers numbers_;
    std::vector<int> bodies_;                 ///< of the world, for each body of the copy
    std::vector<std::vector<int>> vertices_;  ///< of the world's body, for each vertex of the copy's
};

}  // namespace

TEST_CASE("search: the same pairs are found whatever the numbers of bodies, vertices and faces")
{
    constexpr int tetrahedra = 0, boxes = 2, l_shapes = 4, u_shapes = 5, lumps = 6;
    for (const int family : {mixed_family, tetrahedra, boxes, l_shapes, u_shapes, lumps}) {
        const double dt = family == lumps ? 0.02 : 0.01, spin = family == boxes ? 0 : 30;
        Scene scene = random_heap({family, 8, dt, 0.5, 3, spin});
        World& world = scene.world;
        ImplicitSettings settings;
        settings.record = [](const SolveRecord&) {};
        const Solver solver = chapter08_solver(scene.contact, settings);
        Contacts contacts;
        std::size_t pairs = 0;
        for (int i = 0; i < 0.6 / dt; ++i)
            advance(world, contacts, solver, dt);
        for (unsigned step = 0; step < 50; ++step) {
            CAPTURE(family);
            CAPTURE(step);
            const auto found_in = [&](Shuffle shuffle) {
                const World copy = shuffle.copy(world, dt);
                std::set<NamedPair> named;
                for (const Contact& contact : ContactSearch().find(copy, {}, dt))
                    named.insert(shuffle.name(contact));
                return named;
            };
            const std::set<NamedPair> found = found_in(Shuffle::none(world));
            CHECK(found_in(Shuffle(world, 1 + step)) == found);
            pairs = std::max(pairs, found.size());
            advance(world, contacts, solver, dt);
        }
        CHECK(pairs > 20);
    }
}
