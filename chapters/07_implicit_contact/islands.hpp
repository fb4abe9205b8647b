#pragma once

#include "chapters/07_implicit_contact/force_element.hpp"
#include "chapters/07_implicit_contact/joined_sets.hpp"
#include "chapters/07_implicit_contact/newton_matrix.hpp"
#include "common/simulation/step.hpp"

#include <memory>
#include <span>
#include <vector>

namespace enduring {

/// Bodies that press each other, directly or through others that move, and all their pairs. What does not
/// move joins nothing: two stacks on the same ground are two islands, and no impulse of one changes anything
/// in the other.
struct Island {
    std::vector<int> bodies;                      ///< that move, by their places in World::bodies, ascending
    std::vector<Contact*> contacts;               ///< in the order of the list
    std::vector<int> elements{};                  ///< what else joins them, by number, ascending
    double element_force = 0;                     ///< sum of what these bring upon them by themselves [N]
    std::vector<VertexShare> element_vertices{};  ///< of soft bodies, what these read and push
};

/// The islands of all pairs that take part in the step, in the order of their first bodies. A pair that is
/// held or resolved joins nothing; a pair of two bodies that do not move belongs to no island. The same goes
/// for elements.
std::vector<Island> find_islands(const World& world, Contacts& contacts,
                                 std::span<const ElementBodies> elements = {});

/// A matrix for each island. It belongs to the island's first body, so that its memory and its order are kept
/// as long as the same bodies touch.
class IslandMatrices {
public:
    /// Makes the matrices of these islands ready.
    /// @param bodies    how many the world has
    /// @param new_step  another step has begun, not only another response in the same. An island that comes
    ///                  of several goes on with the count of the one that was solved most often
    void begin_response(const std::vector<Island>& islands, std::size_t bodies, bool new_step);

    NewtonMatrix& of(const Island& island)
    {
        return *of_body_[static_cast<std::size_t>(island.bodies.front())];
    }

private:
    std::vector<std::unique_ptr<NewtonMatrix>> of_body_;  ///< null where it is no island's first
};

}  // namespace enduring
