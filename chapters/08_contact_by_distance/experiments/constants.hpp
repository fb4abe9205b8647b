#pragma once

#include "chapters/07_implicit_contact/implicit_contact.hpp"
#include "common/scenes/scene.hpp"

#include <functional>
#include <string>
#include <vector>

namespace enduring::chapter08 {

/// The solver's settings with one constant changed.
struct ChangedConstant {
    std::string name;          ///< of the constant, or of what is not changed
    std::string of_its_value;  ///< "1/10", "10", or the value itself
    std::function<void(ImplicitSettings&)> change;
};
/// First the settings as they are. Then each constant that a program may set, at a tenth and at ten times its
/// value; then three weights over the step.
std::vector<ChangedConstant> changed_constants();

/// What the solver does with a scene. Plain numbers, to be kept by sweep().
struct ConstantsOutcome {
    double deepest_m = 0, at_end_m = 0;  ///< chapter07::true_depth() after any step, and after the last one
    double speed = 0;                    ///< of the fastest body at the end [m/s]
    double gain = 0;  ///< the most that a step brings to bodies and springs, over the energy at first
    long newton_steps = 0, parts = 0, steps = 0, unsolved = 0;
    bool stopped = false;  ///< a step could not be taken

    /// The worst of two runs; counts are added.
    void add(const ConstantsOutcome& other);
};
ConstantsOutcome run_with(const ChangedConstant& constant, Scene scene, int steps);

/// A stack, a heap, 1,000 : 1, soft blocks, a harsh scene.
Scene constants_scene(int index, bool quick);
inline constexpr int constants_scenes = 5;

}  // namespace enduring::chapter08
