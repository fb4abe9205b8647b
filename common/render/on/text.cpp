#include "common/render/text.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb/stb_truetype.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

struct Font {
    Font()
    {
        std::ifstream in(ENDURING_FONT, std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(in), {});
        if (bytes.empty() || stbtt_InitFont(&info, bytes.data(), 0) == 0)
            throw std::runtime_error(std::string(ENDURING_FONT) + ": cannot be read as a font");
    }
    std::vector<unsigned char> bytes;
    stbtt_fontinfo info{};
};

const stbtt_fontinfo& font()
{
    static const Font loaded;
    return loaded.info;
}

std::vector<int> code_points(const std::string& utf8)
{
    std::vector<int> points;
    for (const char c : utf8) {
        const int byte = static_cast<unsigned char>(c);
        if ((byte & 0xc0) == 0x80 && !points.empty())
            points.back() = (points.back() << 6) | (byte & 0x3f);
        else
            points.push_back(byte < 0x80 ? byte : byte >= 0xf0 ? byte & 0x07 : byte >= 0xe0 ? byte & 0x0f : byte & 0x1f);
    }
    return points;
}

/// How much of each pixel text covers, in [0, 1].
struct Coverage {
    int left = 0, top = 0, width = 0, height = 0;
    std::vector<float> share;

    float at(int x, int y) const
    {
        const bool inside = x >= 0 && y >= 0 && x < width && y < height;
        return inside ? share[static_cast<std::size_t>(y * width + x)] : 0.0F;
    }
};

void cover(Coverage& line, int code_point, float scale, double pen)
{
    int width = 0, height = 0, left = 0, top = 0;
    const auto whole = static_cast<int>(std::floor(pen));
    unsigned char* bitmap = stbtt_GetCodepointBitmapSubpixel(&font(), scale, scale, static_cast<float>(pen - whole), 0, code_point,
                                                            &width, &height, &left, &top);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int column = whole + left + x - line.left, row = top + y - line.top;
            if (column >= 0 && row >= 0 && column < line.width && row < line.height) {
                float& share = line.share[static_cast<std::size_t>(row * line.width + column)];
                share = std::max(share, static_cast<float>(bitmap[y * width + x]) / 255);
            }
        }
    stbtt_FreeBitmap(bitmap, nullptr);
}

/// Moves the pen along a line and calls `visit(code point, pen)` for each glyph; returns the width.
template <class Visit>
double walk(const std::string& text, float scale, double start, Visit&& visit)
{
    double pen = start;
    const std::vector<int> points = code_points(text);
    for (std::size_t i = 0; i < points.size(); ++i) {
        visit(points[i], pen);
        int advance = 0, bearing = 0;
        stbtt_GetCodepointHMetrics(&font(), points[i], &advance, &bearing);
        const int kerning = i + 1 < points.size() ? stbtt_GetCodepointKernAdvance(&font(), points[i], points[i + 1]) : 0;
        pen += scale * static_cast<double>(advance + kerning);
    }
    return pen - start;
}

void blend(Picture& picture, int x, int y, const Vec3& color, double share)
{
    if (x < 0 || y < 0 || x >= picture.width || y >= picture.height || share <= 0)
        return;
    std::uint8_t* pixel = picture.at(x, y);
    for (int c = 0; c < 3; ++c) {
        const double screen = 255 * std::pow(color[c], 1 / 2.2);
        pixel[c] = static_cast<std::uint8_t>(std::lround((1 - share) * pixel[c] + share * screen));
    }
}

}  // namespace

double text_width(const std::string& text, double size_px)
{
    return walk(text, stbtt_ScaleForPixelHeight(&font(), static_cast<float>(size_px)), 0, [](int, double) {});
}

void draw_text(Picture& picture, const std::string& text, double x, double y, double size_px, const Vec3& color, bool halo)
{
    if (picture.empty())
        return;
    const float scale = stbtt_ScaleForPixelHeight(&font(), static_cast<float>(size_px));
    const int margin = 4, ascent = static_cast<int>(std::ceil(size_px)), base = static_cast<int>(std::lround(y));
    Coverage line{static_cast<int>(std::floor(x)) - margin, -ascent, 0, 0, {}};
    line.width = static_cast<int>(std::ceil(text_width(text, size_px))) + 2 * margin;
    line.height = 2 * ascent;
    line.share.resize(static_cast<std::size_t>(line.width * line.height));
    walk(text, scale, x, [&](int code_point, double pen) { cover(line, code_point, scale, pen); });

    constexpr int reach = 3;
    for (int row = 0; row < line.height; ++row)
        for (int column = 0; column < line.width; ++column) {
            float rim = 0;
            for (int dy = -reach; halo && dy <= reach; ++dy)
                for (int dx = -reach; dx <= reach; ++dx)
                    rim = std::max(rim, line.at(column + dx, row + dy) * (1 - std::sqrt(static_cast<float>(dx * dx + dy * dy)) / (reach + 1)));
            blend(picture, line.left + column, base + line.top + row, Vec3::Ones() * 0.96, std::min(1.0F, 1.2F * rim) * 0.8);
            blend(picture, line.left + column, base + line.top + row, color, line.at(column, row));
        }
}

}  // namespace enduring
