#include "common/experiments/render/text.hpp"

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
            points.push_back(byte < 0x80    ? byte
                             : byte >= 0xf0 ? byte & 0x07
                             : byte >= 0xe0 ? byte & 0x0f
                                            : byte & 0x1f);
    }
    return points;
}

/// How much of each pixel text covers, in [0, 1].
struct Coverage {
    int left = 0, top = 0, width = 0, height = 0;
    std::vector<float> share;
};

void cover(Coverage& line, int code_point, float scale, double pen)
{
    int width = 0, height = 0, left = 0, top = 0;
    const auto whole = static_cast<int>(std::floor(pen));
    unsigned char* bitmap = stbtt_GetCodepointBitmapSubpixel(
        &font(), scale, scale, static_cast<float>(pen - whole), 0, code_point, &width, &height, &left, &top);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int column = whole + left + x - line.left, row = top + y - line.top;
            if (column >= 0 && row >= 0 && column < line.width && row < line.height) {
                float& share = line.share[row * line.width + column];
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
        const int kerning = i + 1 < points.size()
                                ? stbtt_GetCodepointKernAdvance(&font(), points[i], points[i + 1])
                                : 0;
        pen += scale * static_cast<double>(advance + kerning);
    }
    return pen - start;
}

}  // namespace

double text_width(const std::string& text, double size_px)
{
    return walk(text, stbtt_ScaleForPixelHeight(&font(), static_cast<float>(size_px)), 0, [](int, double) {});
}

void draw_text(Picture& picture, const std::string& text, double x, double y, double size_px,
               const Vec3& color)
{
    if (picture.empty())
        return;
    const float scale = stbtt_ScaleForPixelHeight(&font(), static_cast<float>(size_px));
    const int ascent = static_cast<int>(std::ceil(size_px)), base = static_cast<int>(std::lround(y));
    Coverage line{static_cast<int>(std::floor(x)) - 2,
                  -ascent,
                  static_cast<int>(std::ceil(text_width(text, size_px))) + 4,
                  2 * ascent,
                  {}};
    line.share.resize(static_cast<std::size_t>(line.width * line.height));
    walk(text, scale, x, [&](int code_point, double pen) { cover(line, code_point, scale, pen); });
    for (int row = 0; row < line.height; ++row)
        for (int column = 0; column < line.width; ++column)
            blend(picture, line.left + column, base + line.top + row, color,
                  line.share[row * line.width + column]);
}

}  // namespace enduring
