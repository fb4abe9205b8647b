#include "common/experiments/render/reference.hpp"

#include "common/experiments/render/difference.hpp"
#include "common/experiments/render/renderer.hpp"

#include <cstdlib>
#include <filesystem>
#include <string_view>

namespace enduring {
namespace {

bool renewing()
{
    const char* wish = std::getenv("ENDURING_RENEW_RENDERS");
    return wish != nullptr && std::string_view(wish) == "1";
}

}  // namespace

ReferenceCheck check_reference_picture(const Picture& picture, const std::string& name,
                                       const ReferencePlaces& places)
{
    if (!pictures_are_on)
        return {true, "pictures are off"};
    const std::filesystem::path reference = places.renders / name;
    if (renewing()) {
        write_png(picture, reference);
        return {true, reference.string() + " renewed"};
    }
    const std::filesystem::path place = places.differences / name;
    const auto got = std::filesystem::path(place).replace_extension(".got.png");
    const auto marked = std::filesystem::path(place).replace_extension(".difference.png");
    if (!std::filesystem::exists(reference)) {
        write_png(picture, got);
        return {false, reference.string() + " is missing; `./course renders` writes it"};
    }
    const Picture expected = read_png(reference);
    const PictureDifference difference = compare_pictures(picture, expected);
    if (difference.same)
        return {true, difference.message};
    write_png(picture, got);
    write_png(difference_picture(picture, expected), marked);
    return {false, name + ": " + difference.message + "; see " + marked.string()};
}

ReferenceCheck check_reference_view(Stage stage, const Vec3& seen_from, const std::string& name,
                                    double margin)
{
    constexpr int width = 480, height = 320;
    stage.camera = frame(points_of(stage), seen_from, static_cast<double>(width) / height, margin);
    return check_reference_picture(Renderer(width, height).draw(stage), name);
}

}  // namespace enduring
