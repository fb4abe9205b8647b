#include "experiments.hpp"

namespace enduring::chapter04 {

std::filesystem::path plot_script(const std::string& name)
{
    return std::filesystem::path(ENDURING_SOURCE_DIR) / "chapters/04_friction/plots" / (name + ".gp");
}

}  // namespace enduring::chapter04
