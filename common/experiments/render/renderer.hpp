#pragma once

#include "common/experiments/render/picture.hpp"
#include "common/experiments/render/stage.hpp"

#include <memory>

namespace enduring {

/// Draws stages off-screen, by the CPU. Light comes from many directions, each with its own shadow map: some
/// of them make a soft sun, the others the sky, whose shadows darken the places where bodies touch.
///
/// The same stage gives the same bytes on one machine; another CPU may differ by a grey level.
class Renderer {
public:
    /// @param width, height  of the pictures [px], 16 to 4096
    /// @throws InputError          size out of range
    /// @throws std::runtime_error  the OpenGL library refuses
    explicit Renderer(int width = 960, int height = 540);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    Picture draw(const Stage& stage);

    int width() const { return width_; }
    int height() const { return height_; }

private:
    struct Machine;
    int width_, height_;
    std::unique_ptr<Machine> machine_;
};

}  // namespace enduring
