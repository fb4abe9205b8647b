#include "common/experiments/render/picture.hpp"
#include "common/experiments/report/pictures_wanted.hpp"
#include "common/experiments/report/report.hpp"
#include "common/input/input_error.hpp"

#include <memory>
#include <string>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace enduring {

void write_png(const Picture& picture, const std::filesystem::path& path)
{
    if (!pictures_wanted())
        std::filesystem::remove(path);
    if (picture.empty() || !pictures_wanted())
        return;
    std::string bytes;
    const auto append = [](void* text, void* data, int size) {
        static_cast<std::string*>(text)->append(static_cast<const char*>(data),
                                                static_cast<std::size_t>(size));
    };
    stbi_write_png_to_func(append, &bytes, picture.width, picture.height, 3, picture.rgb.data(),
                           3 * picture.width);
    write_file(path, bytes);
}

Picture read_png(const std::filesystem::path& path)
{
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> bytes(
        stbi_load(path.c_str(), &width, &height, &channels, 3), stbi_image_free);
    if (!bytes)
        throw InputError(path.string() + ": " + stbi_failure_reason());
    Picture picture(width, height);
    picture.rgb.assign(bytes.get(), bytes.get() + picture.rgb.size());
    return picture;
}

}  // namespace enduring
