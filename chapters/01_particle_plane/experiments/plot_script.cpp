#include "experiments.hpp"

namespace enduring::chapter01 {

std::filesystem::path plot_script(const std::string& name)
{
    return std::filesystem::path(ENDURING_SOURCE_DIR) / "chapters/01_particle_plane/plots" / (name + ".gp");
}

}  // namespace enduring::chapter01
