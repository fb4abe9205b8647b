#include "experiments.hpp"

namespace enduring::chapter06 {

std::filesystem::path plot_script(const std::string& name)
{
    return std::filesystem::path(ENDURING_SOURCE_DIR) / "chapters/06_redefinition/plots" / (name + ".gp");
}

}  // namespace enduring::chapter06
