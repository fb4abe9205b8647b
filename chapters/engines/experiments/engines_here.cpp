#include "chapters/engines/experiments/engines_here.hpp"

#include <cstdio>
#include <utility>

namespace enduring::engines {

std::vector<Engine> engines_here()
{
    std::vector<Engine> here;
    for (Engine& engine : all_engines())
        if (engine.is_here())
            here.push_back(std::move(engine));
        else
            std::printf("   without %s: %s\n", engine.name.c_str(), engine.missing.c_str());
    return here;
}

}  // namespace enduring::engines
