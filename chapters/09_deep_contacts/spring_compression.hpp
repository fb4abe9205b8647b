#pragma once

#include "common/simulation/step.hpp"

#include <tuple>
#include <vector>

namespace enduring {

/// Keeps what the springs of vertex-face pairs hold while they are handed from face to face. The depth under
/// another face is another number, and the difference would be energy out of nothing.
class SpringCompressions {
public:
    /// Before pairs are followed: how far each spring is compressed.
    void note(const World& world, const Contacts& contacts);

    /// After it: a spring that acts at another face gets the slack with which it is compressed as before. It
    /// never pushes before its vertex is inside. A vertex that is deeper under the other face than it was far from
    /// its own has not come there along the surface: its pair is resolved.
    void keep(const World& world, Contacts& contacts) const;

private:
    using Key = std::tuple<int, int, int>;  ///< body_a, vertex, body_b
    struct Spring {
        Key key;
        int face;
        double compression;  ///< [m], not positive
        double distance;     ///< of the vertex from the face [m]
    };
    std::vector<Spring> springs_;  ///< ascending
};

}  // namespace enduring
