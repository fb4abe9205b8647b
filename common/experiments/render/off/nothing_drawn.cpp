// The interface of common/render without OSMesa or EGL: whatever draws gives a picture without pixels.

#include "common/experiments/render/renderer.hpp"
#include "common/experiments/render/text.hpp"
#include "common/experiments/report/warn_once.hpp"

namespace enduring {

struct Renderer::Machine {};

Renderer::Renderer(int width, int height) : width_(width), height_(height)
{
    warn_once("pictures are left out: this was built without what draws them (./course doctor names it)");
}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Picture Renderer::draw(const Stage&) { return {}; }

void write_png(const Picture&, const std::filesystem::path&) {}

Picture read_png(const std::filesystem::path&) { return {}; }

void draw_text(Picture&, const std::string&, double, double, double, const Vec3&) {}

double text_width(const std::string&, double) { return 0; }

}  // namespace enduring
