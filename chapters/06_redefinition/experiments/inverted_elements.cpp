#include "chapters/06_redefinition/experiments/inverted_elements.hpp"

#include "common/experiments/render/scene_view.hpp"
#include "common/simulation/deformable_body.hpp"

namespace enduring::chapter06 {
namespace {

/// A tetrahedron by its corners. Inside out, its faces look inwards: they are drawn from both sides.
void add_tetrahedron(Drawable& drawable, const ElasticElement& element, const NodalVectors& positions)
{
    const int first = static_cast<int>(drawable.positions.size());
    for (int corner = 0; corner < 4; ++corner)
        drawable.positions.push_back(positions.col(element.nodes[corner]));
    for (const Face& face : {Face{0, 2, 1}, Face{0, 1, 3}, Face{1, 2, 3}, Face{0, 3, 2}}) {
        drawable.faces.push_back({first + face[0], first + face[1], first + face[2]});
        drawable.faces.push_back({first + face[0], first + face[2], first + face[1]});
    }
}

}  // namespace

int count_inverted(const World& world)
{
    int count = 0;
    for (const auto& body : world.bodies)
        count += body->inverted_elements();
    return count;
}

Stage stage_of_inverted(const Scene& scene)
{
    Stage stage = stage_of(scene.world, scene);
    Drawable inverted;
    inverted.color = palette::colliding_vertex;
    inverted.casts_shadow = false;
    for (std::size_t i = 0; i < scene.world.bodies.size(); ++i) {
        stage.bodies[i].opacity = 0.35;
        const auto* body = dynamic_cast<const DeformableBody*>(scene.world.bodies[i].get());
        if (!body)
            continue;
        const ElasticBody& elastic = body->elastic();
        for (const ElasticElement& element : elastic.mesh().elements())
            if (is_inverted(elastic.mesh().basis(), element, elastic.positions()))
                add_tetrahedron(inverted, element, elastic.positions());
    }
    if (!inverted.faces.empty())
        stage.bodies.push_back(inverted);
    return stage;
}

}  // namespace enduring::chapter06
