#include "experiments.hpp"

namespace enduring::chapter03 {

std::filesystem::path plot_script(const std::string& name)
{
    return std::filesystem::path(ENDURING_SOURCE_DIR) / "chapters/03_penalty_impulses/plots" / (name + ".gp");
}

}  // namespace enduring::chapter03
