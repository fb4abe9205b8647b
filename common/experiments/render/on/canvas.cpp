#include "common/experiments/render/on/canvas.hpp"

#include "common/experiments/render/on/shaders.hpp"

#include <algorithm>

namespace enduring {

using namespace graphics;

namespace {

void shape_texture(GLuint texture, GLenum format, int width, int height, GLenum layout, GLenum type)
{
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0, layout, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

}  // namespace

Canvas::Canvas(int width, int height)
    : width_(width), height_(height), samples_(make_texture()), depth_(make_texture()),
      painting_(make_framebuffer()), bytes_(make_texture()), developed_(make_framebuffer()),
      backdrop_program_(make_program(shaders::screen_vertex, shaders::backdrop_fragment)),
      develop_program_(make_program(shaders::screen_vertex, shaders::develop_fragment)),
      no_corners_(make_vertex_array())
{
    shape_texture(samples_, GL_RGBA16F, 2 * width, 2 * height, GL_RGBA, GL_FLOAT);
    shape_texture(depth_, GL_DEPTH_COMPONENT32F, 2 * width, 2 * height, GL_DEPTH_COMPONENT, GL_FLOAT);
    glBindFramebuffer(GL_FRAMEBUFFER, painting_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, samples_, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);

    shape_texture(bytes_, GL_RGBA8, width, height, GL_RGBA, GL_UNSIGNED_BYTE);
    glBindFramebuffer(GL_FRAMEBUFFER, developed_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, bytes_, 0);
}

void Canvas::begin()
{
    glBindFramebuffer(GL_FRAMEBUFFER, painting_);
    glViewport(0, 0, 2 * width_, 2 * height_);
    glDepthMask(GL_TRUE);
    glClear(GL_DEPTH_BUFFER_BIT);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glUseProgram(backdrop_program_);
    set(backdrop_program_, "picture_height", static_cast<double>(rows()));
    glBindVertexArray(no_corners_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

Picture Canvas::develop()
{
    glBindFramebuffer(GL_FRAMEBUFFER, developed_);
    glViewport(0, 0, width_, height_);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glUseProgram(develop_program_);
    set(develop_program_, "samples", 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, samples_);
    glBindVertexArray(no_corners_);
    glDrawArrays(GL_TRIANGLES, 0, 3);

    Picture picture(width_, height_);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, picture.rgb.data());
    const auto row = 3 * static_cast<std::ptrdiff_t>(width_);
    for (int y = 0; y < height_ / 2; ++y)  // the library's rows run upwards
        std::swap_ranges(picture.rgb.begin() + y * row, picture.rgb.begin() + (y + 1) * row,
                         picture.rgb.begin() + (height_ - 1 - y) * row);
    return picture;
}

}  // namespace enduring
