#include "common/scenes/scene_warnings.hpp"

#include "common/input/number_text.hpp"
#include "common/scenes/start_overlap.hpp"
#include "common/scenes/stiffness_check.hpp"

namespace enduring {
namespace {

std::string sentence(const StartOverlap& overlap)
{
    const std::string place = "'" + overlap.inner + "' begins " + (overlap.whole ? "wholly " : "") +
                              "inside '" + overlap.outer + "', " + readable(overlap.depth, 3) + " m deep";
    if (overlap.in_plane)
        return place + ": all weight of the scene would not press it so far, so the plane throws it out";
    return place +
           ": pairs are found where surfaces cross, so nothing holds what never crossed; move one of them";
}

std::string sentence(const StiffestContact& contact, double dt)
{
    return "/contact/stiffness: too stiff for the step where '" + contact.a + "' meets '" + contact.b +
           "': even on " + std::to_string(contact.pairs) + " pairs (n k = " + readable(contact.stiffness, 3) +
           " N/m, on " + readable(contact.mass, 3) + " kg) steps are stable up to " +
           readable(contact.stable_step, 3) + " s, and dt is " + readable(dt, 3) +
           " s; make dt shorter, the stiffness smaller, or the bodies heavier";
}

}  // namespace

std::vector<std::string> scene_warnings(const Scene& scene, const std::string& file)
{
    std::vector<std::string> warnings;
    for (const StartOverlap& overlap : start_overlaps(scene.world, scene.contact))
        warnings.push_back(file + ": " + sentence(overlap));
    const std::optional<StiffestContact> contact = stiffest_contact(scene.world, scene.contact);
    if (contact && contact->stable_step < scene.dt)
        warnings.push_back(file + ": " + sentence(*contact, scene.dt));
    return warnings;
}

}  // namespace enduring
