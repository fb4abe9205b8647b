#pragma once

#include "chapters/09_deep_contacts/piercing.hpp"
#include "common/geometry/meshes.hpp"

namespace enduring {

/// A surface of its own that does not move, with what tracing needs: for figures, tests and exercises.
/// (Bodies of a world have their topology and their trees already.)
class OverlapShape {
public:
    explicit OverlapShape(const SurfaceMesh& mesh)
        : topology_(static_cast<int>(mesh.vertices.size()), mesh.faces), positions_(mesh.vertices),
          tree_(topology_, positions_)
    {
        tree_.refit({topology_, positions_, positions_});
    }
    StillSurface still() const { return {topology_, positions_, tree_}; }
    const SurfaceTopology& topology() const { return topology_; }
    const std::vector<Vec3>& positions() const { return positions_; }

private:
    SurfaceTopology topology_;
    std::vector<Vec3> positions_;
    FaceTree tree_;
};

}  // namespace enduring
