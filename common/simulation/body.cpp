#include "common/simulation/body.hpp"

#include <utility>

namespace enduring {

Body::Body(std::string name, SurfaceTopology surface) : name_(std::move(name)), surface_(std::move(surface)) {}

}  // namespace enduring
