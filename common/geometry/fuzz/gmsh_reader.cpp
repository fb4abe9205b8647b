#include "common/geometry/read_gmsh.hpp"
#include "common/geometry/solid_checks.hpp"
#include "common/input/input_error.hpp"

#include <cstddef>
#include <cstdint>
#include <sstream>

/// Whatever the bytes are: a sound mesh comes back, or an InputError;
/// never a crash, a hang or a flood of memory.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string text(reinterpret_cast<const char*>(data), size);
    try {
        std::istringstream stream(text), again(text);
        const enduring::TetrahedralMesh mesh = enduring::read_gmsh(stream, "fuzz.msh");
        enduring::read_gmsh_quadratic(again, "fuzz.msh");
        enduring::check_solid(mesh, "fuzz.msh");
    } catch (const enduring::InputError&) {}
    return 0;
}
