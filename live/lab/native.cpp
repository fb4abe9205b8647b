// The laboratory without a browser: where bodies are after some steps, as lines of JSON, to compare with the
// page's numbers.
#include "common/input/input_error.hpp"
#include "common/input/json_document.hpp"
#include "common/input/source_directory.hpp"
#include "live/laboratory.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>

namespace {

using namespace enduring;

/// {"energy": ..., "depth": ..., "positions": [...]}, every number with all of its digits.
void print(const laboratory::Laboratory& lab)
{
    const StepNumbers numbers = lab.numbers();
    std::printf(R"({"energy": %.17g, "depth": %.17g, "positions": [)",
                numbers.kinetic + numbers.gravitational + numbers.elastic, numbers.depth);
    const char* comma = "";
    for (const auto& body : lab.scene().world.bodies)
        for (const Vec3& x : body->positions_t0()) {
            std::printf("%s%.17g, %.17g, %.17g", comma, x.x(), x.y(), x.z());
            comma = ", ";
        }
    std::puts("]}");
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App app("Steps scenes under a solver, and prints where their bodies are");
    std::vector<std::string> files;
    std::string solver = "10";
    int steps = 100;
    app.add_option("scene", files, "scene files; one line of JSON each")->required();
    app.add_option("--solver", solver, "a chapter, or a method of chapter 13 by its name")
        ->capture_default_str();
    app.add_option("--steps", steps, "how many")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        for (const std::string& file : files) {
            laboratory::Laboratory lab(read_text_file(file), file, {source_directory() / "common" / "meshes"},
                                       solver);
            for (int i = 0; i < steps; ++i)
                lab.step();
            print(lab);
        }
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
