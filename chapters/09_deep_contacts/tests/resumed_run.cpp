#include "chapters/08_contact_by_distance/tests/resumed.hpp"
#include "chapters/09_deep_contacts/experiments/inside_scenes.hpp"
#include "chapters/09_deep_contacts/solver.hpp"

using namespace enduring;
using namespace enduring::chapter09;

TEST_CASE("resumed run: a body that separates goes on with the same numbers, to the last bit")
{
    for (const std::string body : {"leaning block", "fine block", "ball"}) {
        CAPTURE(body);
        const auto make = [&] { return scene_inside(all_surroundings()[0], body, 0.2, 0.01); };
        const auto solver = [](const ContactParameters& parameters) { return chapter09_solver(parameters); };
        CHECK(chapter08::apart_when_resumed(make, solver, 7, 30) == 0);
    }
}
