#include "common/geometry/read_obj.hpp"
#include "common/geometry/surface_checks.hpp"
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
        std::istringstream stream(text);
        enduring::check_surface(enduring::read_obj(stream, "fuzz.obj"), "fuzz.obj",
                                enduring::Border::allowed);
    } catch (const enduring::InputError&) {}
    return 0;
}
