#include "common/experiments/render/strip.hpp"

#include "common/experiments/render/palette.hpp"
#include "common/experiments/render/text.hpp"
#include "common/input/input_error.hpp"

#include <algorithm>

namespace enduring {
namespace {

constexpr int gap = 6;               ///< between pictures [px]
constexpr std::uint8_t paper = 250;  ///< grey of what is not picture

void paste(Picture& page, const Picture& picture, int left, int top)
{
    for (int y = 0; y < picture.height; ++y)
        std::copy_n(picture.at(0, y), 3 * static_cast<std::size_t>(picture.width), page.at(left, top + y));
}

/// A page shows a strip about this many heights of its smallest text wide, however many pictures it has.
constexpr double text_heights_across = 62;

/// Of the captions [px]: legible on a page, as long as each fits under its picture.
double caption_size(const std::vector<StripPicture>& pictures, int width, int height, int page_width)
{
    const double usual = std::clamp(height / 20.0, 14.0, 26.0);
    double size = std::max(usual, page_width / text_heights_across);
    for (const auto& [picture, caption] : pictures)
        if (const double wide = text_width(caption, size); wide > width)
            size = std::max(usual, size * width / wide);
    return size;
}

}  // namespace

Picture strip(const std::vector<StripPicture>& pictures, int columns)
{
    if (pictures.empty() || pictures.front().picture.empty())
        return {};
    const int width = pictures.front().picture.width, height = pictures.front().picture.height;
    const int count = static_cast<int>(pictures.size());
    const int across = columns > 0 ? std::min(columns, count) : count, rows = (count + across - 1) / across;
    const bool captions = std::any_of(pictures.begin(), pictures.end(),
                                      [](const auto& one) { return !one.caption.empty(); });
    const int page_width = across * (width + gap) - gap;
    const double size = caption_size(pictures, width, height, page_width);
    const int line = captions ? static_cast<int>(1.7 * size) : 0;

    Picture page(page_width, rows * (height + line + gap) - gap, paper);
    for (int i = 0; i < count; ++i) {
        const auto& [picture, caption] = pictures[i];
        if (picture.width != width || picture.height != height)
            throw InputError("the pictures of a strip must have one size");
        const int left = i % across * (width + gap), top = i / across * (height + line + gap);
        paste(page, picture, left, top);
        draw_text(page, caption, left + 0.5 * (width - text_width(caption, size)), top + height + 1.15 * size,
                  size, palette::ink);
    }
    return page;
}

}  // namespace enduring
