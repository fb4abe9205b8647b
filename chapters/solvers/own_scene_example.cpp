#include "chapters/solvers/chapter_solver.hpp"
#include "chapters/solvers/experiments.hpp"
#include "common/experiments/own_scene/own_scene.hpp"
#include "common/scenes/scene.hpp"

namespace enduring::solvers {

void own_scene_example(const RunOptions& options, Report& report)
{
    RunOptions own = options;
    own.scene = options.scene.value_or(scene_file("tumble"));
    Report below(report.folder() / own.scene->stem());
    own_scene(own, below,
              [](const ContactParameters& parameters) { return chapter_solver(chapters, parameters); });
    if (const std::filesystem::path picture = below.folder() / "scene.png"; std::filesystem::exists(picture))
        std::filesystem::copy_file(picture, report.file("own_scene.png"),
                                   std::filesystem::copy_options::overwrite_existing);
}

}  // namespace enduring::solvers
