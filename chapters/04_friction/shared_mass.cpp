#include "chapters/04_friction/shared_mass.hpp"

#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

std::span<const int> parts(const World& world, const Contact& contact, int i)
{
    return body_of_vertex(world, contact, i).mass_parts().moved_by(contact.vertices[i]);
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
        if (body_index(contact, j) == body_index(contact, i) &&
            std::find(others.begin(), others.end(), part) != others.end())
            return true;
    }
    return false;
}

/// Sums the weights of all pairs at each vertex of a body.
class PushList {
public:
    explicit PushList(const Body& body) : place_(static_cast<std::size_t>(body.surface().vertex_count()), -1)
    {}
    void add(int vertex, double weight, std::vector<Push>& pushes)
    {
        int& place = place_[vertex];
        if (place < 0) {
            place = static_cast<int>(pushes.size());
            pushes.push_back({vertex, 0});
        }
        pushes[place].weight += weight;
    }

private:
    std::vector<int> place_;
};

}  // namespace

//! [count]
MassShares::MassShares(const World& world, const Contacts& contacts)
{
    std::vector<PushList> lists;
    for (const std::unique_ptr<Body>& body : world.bodies) {
        lists.emplace_back(*body);
        bodies_.push_back(
            {std::vector<int>(static_cast<std::size_t>(body->mass_parts().count()), 0),
             {},
             std::vector<double>(static_cast<std::size_t>(body->surface().vertex_count()), -1)});
    }
    for (const Contact& contact : contacts) {
        if (!pushes_now(contact))
            continue;
        for (int i = 0; i < contact.vertex_count(); ++i) {
            const auto v = static_cast<std::size_t>(i);
            OfBody& of_body = bodies_[body_index(contact, i)];
            lists[body_index(contact, i)].add(contact.vertices[v], std::abs(contact.weights[v]),
                                              of_body.pushes);
            for (const int part : parts(world, contact, i))
                if (!moved_before(world, contact, i, part))
                    ++of_body.pairs_of_part[part];
        }
    }
}
//! [count]

int MassShares::pairs_sharing(const World& world, const Contact& contact, int i) const
{
    int most = 1;
    for (const int part : parts(world, contact, i))
        most = std::max(most, bodies_[body_index(contact, i)].pairs_of_part[part]);
    return most;
}

double MassShares::response_bound(const Body& body, OfBody& of_body, int vertex) const
{
    double& known = of_body.together[vertex];
    if (known < 0)
        known = body.mass_parts().response_bound(vertex, of_body.pushes);
    return known;
}

//! [inverse_mass]
double MassShares::inverse_mass(const World& world, const Contact& contact, const TangentPlane& plane)
{
    Mat3 sum = Mat3::Zero();
    for (int i = 0; i < contact.vertex_count(); ++i) {
        const Body& body = body_of_vertex(world, contact, i);
        if (body.is_static())
            continue;
        const auto v = static_cast<std::size_t>(i);
        const Mat3 share = pairs_sharing(world, contact, i) * body.inverse_mass(contact.vertices[v]);
        const double bound = response_bound(body, bodies_[body_index(contact, i)], contact.vertices[v]);
        sum += std::abs(contact.weights[v]) * (bound < share.norm() ? Mat3(bound * Mat3::Identity()) : share);
    }
    return largest_eigenvalue(plane.of(sum));
}
//! [inverse_mass]

}  // namespace enduring
