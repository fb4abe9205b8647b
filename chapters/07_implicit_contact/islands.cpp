#include "chapters/07_implicit_contact/islands.hpp"

#include <algorithm>

namespace enduring {

namespace {

/// Those of a pair's bodies that move, -1 for one that does not.
struct MovingBodies {
    int a = -1, b = -1;

    MovingBodies(const World& world, const Contact& contact)
    {
        const auto moves = [&](int body) {
            return !world.bodies[static_cast<std::size_t>(body)]->is_static();
        };
        if (contact.held() || contact.resolved)
            return;
        if (moves(contact.body_a))
            a = contact.body_a;
        if (!contact.on_plane() && moves(contact.body_b))
            b = contact.body_b;
    }
    int any() const { return std::max(a, b); }
};

}  // namespace

//! [find_islands]
std::vector<Island> find_islands(const World& world, Contacts& contacts,
                                 std::span<const ElementBodies> elements)
{
    JoinedSets joined(world.bodies.size());
    std::vector<char> touches(world.bodies.size(), 0);
    const auto join = [&](int a, int b) {
        for (const int body : {a, b})
            if (body >= 0)
                touches[static_cast<std::size_t>(body)] = 1;
        if (a >= 0 && b >= 0)
            joined.join(a, b);
    };
    for (const Contact& contact : contacts) {
        const MovingBodies pair(world, contact);
        join(pair.a, pair.b);
    }
    for (const ElementBodies& element : elements)
        join(element.a, element.b);
    std::vector<Island> islands;
    std::vector<std::size_t> place(world.bodies.size());  // of a body's island
    for (std::size_t body = 0; body < world.bodies.size(); ++body) {
        if (!touches[body])
            continue;
        const auto least = static_cast<std::size_t>(joined.least_of(static_cast<int>(body)));
        if (least == body)
            islands.emplace_back();
        place[body] = least == body ? islands.size() - 1 : place[least];
        islands[place[body]].bodies.push_back(static_cast<int>(body));
    }
    for (Contact& contact : contacts)
        if (const int body = MovingBodies(world, contact).any(); body >= 0)
            islands[place[static_cast<std::size_t>(body)]].contacts.push_back(&contact);
    for (std::size_t i = 0; i < elements.size(); ++i)
        if (const int body = std::max(elements[i].a, elements[i].b); body >= 0) {
            Island& island = islands[place[static_cast<std::size_t>(body)]];
            island.elements.push_back(static_cast<int>(i));
            island.element_force += elements[i].force;
            island.element_vertices.insert(island.element_vertices.end(), elements[i].vertices.begin(),
                                           elements[i].vertices.end());
        }
    return islands;
}
//! [find_islands]

void IslandMatrices::begin_response(const std::vector<Island>& islands, std::size_t bodies, bool new_step)
{
    of_body_.resize(bodies);
    if (new_step)  // also for bodies that nothing touches yet: they may join an island in this step
        for (const std::unique_ptr<NewtonMatrix>& matrix : of_body_)
            if (matrix)
                matrix->begin_response(0);
    for (const Island& island : islands) {
        int solves = 0;
        for (const int body : island.bodies) {
            std::unique_ptr<NewtonMatrix>& matrix = of_body_[static_cast<std::size_t>(body)];
            if (matrix)
                solves = std::max(solves, matrix->solves());
            if (body != island.bodies.front())
                matrix.reset();
            else if (!matrix)
                matrix = std::make_unique<NewtonMatrix>();
        }
        of(island).begin_response(solves);
    }
}

}  // namespace enduring
