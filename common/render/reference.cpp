#include "common/render/reference.hpp"

#include "common/render/difference.hpp"

#include <cstdlib>
#include <filesystem>
#include <string_view>

namespace enduring {
namespace {

const std::filesystem::path source_dir = ENDURING_SOURCE_DIR;

bool renewing()
{
    const char* wish = std::getenv("ENDURING_RENEW_RENDERS");
    return wish != nullptr && std::string_view(wish) == "1";
}

std::filesystem::path beside(const std::string& name, const std::string& ending)
{
    std::filesystem::path place = source_dir / "build/results/differences" / name;
    return place.replace_extension(ending + ".png");
}

}  // namespace

ReferenceCheck check_reference_picture(const Picture& picture, const std::string& name)
{
    if (!pictures_are_on)
        return {true, "pictures are off"};
    const std::filesystem::path reference = source_dir / "renders" / name;
    if (renewing()) {
        write_png(picture, reference);
        return {true, reference.string() + " renewed"};
    }
    if (!std::filesystem::exists(reference)) {
        write_png(picture, beside(name, ".got"));
        return {false, reference.string() + " is missing; `./course renders` writes it"};
    }
    const Picture expected = read_png(reference);
    const PictureDifference difference = compare_pictures(picture, expected);
    if (difference.same)
        return {true, difference.message};
    write_png(picture, beside(name, ".got"));
    write_png(difference_picture(picture, expected), beside(name, ".difference"));
    return {false, name + ": " + difference.message + "; see " + beside(name, ".difference").string()};
}

}  // namespace enduring
