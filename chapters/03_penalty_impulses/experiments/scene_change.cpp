#include "chapters/03_penalty_impulses/experiments/scene_change.hpp"

#include "common/input/input_error.hpp"

#include <nlohmann/json.hpp>

#include <fstream>

namespace enduring::chapter03 {

nlohmann::json contact_change(PenaltyMethod method, double stiffness, double dt)
{
    return {{"dt", dt},
            {"contact",
             {{"method", method == PenaltyMethod::discrete ? "dpf" : "cpf"}, {"stiffness", stiffness}}}};
}

nlohmann::json bodies_of(const std::filesystem::path& file)
{
    std::ifstream stream(file);
    if (!stream)
        throw InputError(file.string() + ": cannot be read");
    // Mistakes in the file are load_scene's to report: it reads it again, and says where they are.
    const nlohmann::json scene = nlohmann::json::parse(stream, nullptr, false);
    return scene.is_object() && scene.contains("bodies") ? scene["bodies"] : nlohmann::json::array();
}

}  // namespace enduring::chapter03
