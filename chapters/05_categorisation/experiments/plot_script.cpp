#include "experiments.hpp"

namespace enduring::chapter05 {

std::filesystem::path plot_script(const std::string& name)
{
    return std::filesystem::path(ENDURING_SOURCE_DIR) / "chapters/05_categorisation/plots" / (name + ".gp");
}

}  // namespace enduring::chapter05
