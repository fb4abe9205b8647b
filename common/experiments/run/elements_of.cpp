#include "common/experiments/run/elements_of.hpp"

#include "common/experiments/run/probes.hpp"
#include "common/simulation/deformable_body.hpp"

namespace enduring {

std::string elements_of(const World& world, const std::string& body)
{
    const auto* const deformable = dynamic_cast<const DeformableBody*>(&body_named(world, body));
    if (deformable == nullptr)
        return "no elements";
    const ElasticMesh& mesh = deformable->elastic().mesh();
    return std::to_string(mesh.elements().size()) +
           (mesh.basis() == Basis::quadratic ? " quadratic elements" : " linear elements");
}

}  // namespace enduring
