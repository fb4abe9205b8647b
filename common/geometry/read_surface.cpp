#include "common/geometry/read_surface.hpp"

#include "common/geometry/read_obj.hpp"
#include "common/input/input_error.hpp"
#include "common/input/input_file.hpp"

#include <algorithm>
#include <iterator>

namespace enduring {

SurfaceMesh read_surface(const std::filesystem::path& file)
{
    const std::string kind = ending_of(file), name = file.string();
    if (kind == ".obj")
        return read_obj(file);
    if (kind != ".off" && kind != ".stl" && kind != ".ply")
        throw InputError(name + ": a surface is read from a file ending in .obj, .off, .stl or .ply");
    std::ifstream stream = open_file(file);
    const std::string bytes(std::istreambuf_iterator<char>(stream), {});
    return kind == ".off"   ? read_off(bytes, name)
           : kind == ".stl" ? read_stl(bytes, name)
                            : read_ply(bytes, name);
}

std::string ending_of(const std::filesystem::path& file)
{
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return ending;
}

}  // namespace enduring
