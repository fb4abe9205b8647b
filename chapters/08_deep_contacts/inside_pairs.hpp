#pragma once

#include "chapters/02_collision_detection/face_tree.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// Finds the vertices that lie in another body without a pair, and gives them one: with the face through
/// which the way out of their overlap leads. It needs no history. Between bodies with closed surfaces only.
///
/// The trees are shaped once, so it belongs to one world.
class InsidePairs {
public:
    /// From where everything lies at the start of the step; the pairs endure.
    void append_missing(const World& world, Contacts& contacts);

private:
    void fit_trees(const World& world);

    std::vector<const Body*> bodies_;  ///< whose trees these are
    std::vector<FaceTree> trees_;
};

/// Speed at which what began inside is let out [m/s].
inline constexpr double leaving_speed = 0.25;

/// Lets the slack of each spring fade: a tenth in each step, as chapter 7 has it, but no faster than the
/// speed at which a body may be let out. So a spring that is born deep inside brings no energy, and throws
/// nothing.
void fade_slack(Contacts& contacts, double keep, double dt);

}  // namespace enduring
