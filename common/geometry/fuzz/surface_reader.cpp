#include "common/geometry/read_surface.hpp"
#include "common/geometry/surface_checks.hpp"
#include "common/geometry/weld.hpp"
#include "common/input/input_error.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

/// Whatever the bytes are: a sound mesh comes back, or an InputError; never a crash, a hang or a flood of
/// memory. The first byte chooses the reader.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0)
        return 0;
    const std::array readers{enduring::read_off, enduring::read_stl, enduring::read_ply};
    const std::string bytes(reinterpret_cast<const char*>(data + 1), size - 1);
    try {
        const enduring::SurfaceMesh mesh = readers[data[0] % 3](bytes, "fuzz");
        enduring::check_surface(enduring::welded(mesh, enduring::weld_distance(mesh)), "fuzz",
                                enduring::Border::allowed);
    } catch (const enduring::InputError&) {}
    return 0;
}
