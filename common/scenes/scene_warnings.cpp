#include "common/scenes/scene_warnings.hpp"

#include "common/input/number_text.hpp"
#include "common/scenes/start_overlap.hpp"
#include "common/scenes/stiffness_check.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/natural_units.hpp"

#include <algorithm>

namespace enduring {
namespace {

std::string sentence_on_room(const StartOverlap& overlap)
{
    return "'" + overlap.inner + "' begins " + (overlap.whole ? "" : "partly ") + "behind the walls of '" +
           overlap.outer + "', " + readable(overlap.depth, 3) + " m deep: the faces of '" + overlap.outer +
           "' look inwards, so it is a room, which holds only what begins in it; turn its faces around if "
           "it is a solid, or move '" +
           overlap.inner + "' into it";
}

/// Solvers differ in what becomes of such a body: the scene does not say which of them will run it.
std::string sentence(const StartOverlap& overlap, double max_depenetration_velocity)
{
    const std::string place = "'" + overlap.inner + "' begins " + (overlap.whole ? "wholly " : "") +
                              "inside '" + overlap.outer + "', " + readable(overlap.depth, 3) + " m deep",
                      separates = ": a solver that traces intersections separates them at " +
                                  readable(max_depenetration_velocity, 3) +
                                  " m/s (/contact/max_depenetration_velocity), ";
    if (overlap.in_plane)
        return place + separates +
               "one that does not throws it out, since all weight of the scene would not press it so far";
    if (!overlap.closed)
        return place +
               ": a surface with a border has no inside to separate from, nor have points and edges, so the body falls through; move one of them";
    return place + separates + "one that waits for surfaces to cross lets it fall through";
}

/// At which the two bodies separate [m/s].
double speed_of(const StartOverlap& overlap, const Scene& scene)
{
    const auto body = [&](const std::string& name) {
        const auto found = std::find_if(scene.world.bodies.begin(), scene.world.bodies.end(),
                                        [&](const auto& one) { return one->name() == name; });
        return static_cast<int>(found - scene.world.bodies.begin());
    };
    Contact pair{overlap.in_plane ? ContactKind::vertex_plane : ContactKind::vertex_face,
                 body(overlap.inner)};
    pair.body_b = overlap.in_plane ? 0 : body(overlap.outer);
    return max_depenetration_velocity(scene.world, pair, scene.contact.max_depenetration_velocity, scene.dt);
}

std::string sentence(const StartSelfOverlap& overlap)
{
    return "'" + overlap.body + "' begins crossed with itself, " + std::to_string(overlap.faces) +
           " of its faces in another part of it: no solver can find the way out, so it stays crossed or "
           "comes free by its own elasticity; give it a shape that does not cross";
}

/// The place of a stiffness, or what stands there if the file does not have it.
std::string place_of(const StiffestContact& contact, const Scene& scene)
{
    if (contact.of_plane)
        return "/planes/" + contact.b + "/stiffness: ";
    if (scene.gives_stiffness)
        return "/contact/stiffness: ";
    return "/contact gives no \"stiffness\", and the default of " + readable(scene.contact.stiffness, 3) +
           " N/m is ";
}

std::string sentence(const StiffestContact& contact, const Scene& scene)
{
    const double dt = scene.dt;
    return place_of(contact, scene) + "too stiff for the step where '" + contact.a + "' meets '" + contact.b +
           "': even on " + std::to_string(contact.pairs) + " pairs (n k = " + readable(contact.stiffness, 3) +
           " N/m, on " + readable(contact.mass, 3) + " kg) steps are stable up to " +
           readable(contact.stable_step, 3) + " s, and dt is " + readable(dt, 3) +
           " s; make dt shorter, the stiffness smaller, or the bodies heavier";
}

/// What its own weight strains a soft body by, about: above 1 it lies flat, and its elements turn inside out.
double strain_by_weight(const DeformableBody& body, const Vec3& gravity)
{
    const ElasticMaterial& material = body.elastic().material();
    return material.density * body.gravity_on(gravity).norm() * body.size() / material.young;
}

std::string sentence_on_weight(const DeformableBody& body, const Vec3& gravity)
{
    return "'" + body.name() +
           "' is so soft that its own weight presses it flat (density * gravity * size / young = " +
           readable(strain_by_weight(body, gravity), 3) + "); is \"young\" in pascal?";
}

/// Each linear element keeps its volume from here on, nearly, and there are more elements than coordinates
/// that could.
constexpr double locking_poisson = 0.4;

bool locks(const DeformableBody& body)
{
    return body.elastic().mesh().basis() == Basis::linear &&
           body.elastic().material().poisson > locking_poisson;
}

std::string sentence_on_locking(const DeformableBody& body)
{
    return "'" + body.name() + "' has linear elements and a Poisson's ratio of " +
           readable(body.elastic().material().poisson, 4) +
           ", with which they bend several times too little; give it \"basis\": \"quadratic\"";
}

/// What to expect of the elements of a soft body.
void warn_of(const DeformableBody& body, const Scene& scene, const std::string& file,
             std::vector<std::string>& warnings)
{
    if (strain_by_weight(body, scene.world.gravity) > 1)
        warnings.push_back(file + ": " + sentence_on_weight(body, scene.world.gravity));
    if (locks(body))
        warnings.push_back(file + ": " + sentence_on_locking(body));
}

/// Beyond what the course has measured. A tenth: scenes of its own are warned of. Ten times: a run of hours
/// begins without a word.
constexpr std::size_t many_bodies = 1000;
constexpr double long_step = 1;  ///< [s]; the same: in a step of 1 s a body falls 10 m

void warn_of_size(const Scene& scene, const std::string& file, std::vector<std::string>& warnings)
{
    if (scene.world.bodies.size() > many_bodies)
        warnings.push_back(file + ": /bodies: " + std::to_string(scene.world.bodies.size()) +
                           " of them, and the course measures scenes of up to " +
                           std::to_string(many_bodies) + ": steps may take seconds");
    if (scene.dt > long_step)
        warnings.push_back(file + ": /dt: a step of " + readable(scene.dt, 4) +
                           " s is longer than any that the course measures (up to " + readable(long_step, 3) +
                           " s); in it, a body falls " +
                           readable(scene.world.gravity.norm() * scene.dt * scene.dt, 3) + " m");
}

}  // namespace

std::vector<std::string> scene_warnings(const Scene& scene, const std::string& file)
{
    std::vector<std::string> warnings;
    warn_of_size(scene, file, warnings);
    for (const StartOverlap& overlap : start_overlaps(scene.world, scene.contact))
        warnings.push_back(
            file + ": " +
            (overlap.in_wall ? sentence_on_room(overlap) : sentence(overlap, speed_of(overlap, scene))));
    for (const StartSelfOverlap& overlap : start_self_overlaps(scene.world))
        warnings.push_back(file + ": " + sentence(overlap));
    for (const auto& body : scene.world.bodies)
        if (const auto* soft = dynamic_cast<const DeformableBody*>(body.get()))
            warn_of(*soft, scene, file, warnings);
    return warnings;
}

std::optional<std::string> stiffness_warning(const Scene& scene, const std::string& file)
{
    const std::optional<StiffestContact> contact = stiffest_contact(scene.world, scene.contact);
    if (!contact || contact->stable_step >= scene.dt)
        return std::nullopt;
    return file + ": " + sentence(*contact, scene);
}

}  // namespace enduring
