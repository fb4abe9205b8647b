#include "shared_mass.hpp"

#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

std::size_t body_index(const Contact& contact, int i)
{
    return static_cast<std::size_t>(i < contact.vertices_of_a() ? contact.body_a : contact.body_b);
}

std::span<const int> parts(const World& world, const Contact& contact, int i)
{
    return body_of_vertex(world, contact, i).moved_parts(contact.vertices[static_cast<std::size_t>(i)]);
}

double largest_eigenvalue(const Mat2& m)
{
    return 0.5 * (m(0, 0) + m(1, 1)) + std::hypot(0.5 * (m(0, 0) - m(1, 1)), m(0, 1));
}

/// A part that several of the pair's vertices move still counts it once.
bool moved_before(const World& world, const Contact& contact, int i, int part)
{
    for (int j = 0; j < i; ++j) {
        const std::span<const int> others = parts(world, contact, j);
        if (body_index(contact, j) == body_index(contact, i) && std::find(others.begin(), others.end(), part) != others.end())
            return true;
    }
    return false;
}

}  // namespace

//! [count]
MassShares::MassShares(const World& world, const Contacts& contacts)
{
    for (const std::unique_ptr<Body>& body : world.bodies)
        pairs_of_part_.emplace_back(static_cast<std::size_t>(body->is_static() ? 1 : body->part_count()), 0);
    for (const Contact& contact : contacts) {
        if (!pushes_now(contact))
            continue;
        for (int i = 0; i < contact.vertex_count(); ++i)
            for (const int part : parts(world, contact, i))
                if (!moved_before(world, contact, i, part))
                    ++pairs_of_part_[body_index(contact, i)][static_cast<std::size_t>(part)];
    }
}
//! [count]

int MassShares::pairs_sharing(const World& world, const Contact& contact, int i) const
{
    int most = 1;
    for (const int part : parts(world, contact, i))
        most = std::max(most, pairs_of_part_[body_index(contact, i)][static_cast<std::size_t>(part)]);
    return most;
}

//! [inverse_mass]
double MassShares::inverse_mass(const World& world, const Contact& contact, const TangentPlane& plane) const
{
    Mat3 sum = Mat3::Zero();
    for (int i = 0; i < contact.vertex_count(); ++i) {
        const Body& body = body_of_vertex(world, contact, i);
        const auto v = static_cast<std::size_t>(i);
        if (!body.is_static())
            sum += std::abs(contact.weights[v]) * pairs_sharing(world, contact, i) * body.inverse_mass(contact.vertices[v]);
    }
    return largest_eigenvalue(plane.of(sum));
}
//! [inverse_mass]

}  // namespace enduring
