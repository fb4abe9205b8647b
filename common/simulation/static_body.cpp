#include "common/simulation/static_body.hpp"

#include <stdexcept>
#include <utility>

namespace enduring {

StaticBody::StaticBody(std::string name, SurfaceTopology surface, std::vector<Vec3> vertices)
    : Body(std::move(name), std::move(surface))
{
    if (static_cast<int>(vertices.size()) != this->surface().vertex_count())
        throw std::invalid_argument("static body '" + this->name() +
                                    "': one position for each vertex is needed");
    positions_t1_ = vertices;
    positions_t0_ = std::move(vertices);
    measure();
}

}  // namespace enduring
