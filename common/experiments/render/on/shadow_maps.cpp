#include "common/experiments/render/on/shadow_maps.hpp"

#include "common/experiments/render/on/shaders.hpp"

#include <initializer_list>
#include <string>

namespace enduring {

using namespace graphics;

namespace {

constexpr int size = 384;  ///< pixels along one map

}  // namespace

ShadowMaps::ShadowMaps()
    : maps_(make_texture()), framebuffer_(make_framebuffer()),
      program_(make_program(shaders::depth_vertex, shaders::depth_fragment))
{
    glBindTexture(GL_TEXTURE_2D_ARRAY, maps_);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT24, size, size, light_count, 0, GL_DEPTH_COMPONENT,
                 GL_UNSIGNED_INT, nullptr);
    const std::array<float, 4> unshadowed{1, 1, 1, 1};
    glTexParameterfv(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BORDER_COLOR, unshadowed.data());
    for (const GLenum direction : std::initializer_list<GLenum>{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D_ARRAY, direction, GL_CLAMP_TO_BORDER);
    for (const GLenum filter : std::initializer_list<GLenum>{GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D_ARRAY, filter, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

void ShadowMaps::fill(const std::array<DirectionalLight, light_count>& lights, double radius, GLsizei corners)
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    glViewport(0, 0, size, size);
    glUseProgram(program_);
    set(program_, "radius", radius);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    for (int i = 0; i < light_count; ++i) {
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, maps_, 0, i);
        glClear(GL_DEPTH_BUFFER_BIT);
        set(program_, "light", lights[i].rows);
        glDrawArrays(GL_TRIANGLES, 0, corners);
    }
}

void ShadowMaps::hand_over(GLuint program, const std::array<DirectionalLight, light_count>& lights,
                           double radius) const
{
    glUseProgram(program);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const std::string index = '[' + std::to_string(i) + ']';
        set(program, ("light" + index).c_str(), lights[i].rows);
        set(program, ("radiance" + index).c_str(), lights[i].radiance);
    }
    set(program, "sun_lights", sun_count);
    set(program, "radius", radius);
    set(program, "texel", 2 * radius / size);
    set(program, "shadows", 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, maps_);
}

}  // namespace enduring
