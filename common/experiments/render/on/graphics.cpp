#include "common/experiments/render/on/graphics.hpp"

#include <array>
#include <stdexcept>

namespace enduring::graphics {
namespace {

GLuint compile(GLenum kind, const std::string& source)
{
    const GLuint shader = glCreateShader(kind);
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == 0) {
        std::array<char, 2000> words{};
        glGetShaderInfoLog(shader, static_cast<GLsizei>(words.size()), nullptr, words.data());
        throw std::runtime_error(std::string("shader: ") + words.data());
    }
    return shader;
}

}  // namespace

Handle make_texture()
{
    GLuint name = 0;
    glGenTextures(1, &name);
    return {name, [](GLuint texture) { glDeleteTextures(1, &texture); }};
}

Handle make_framebuffer()
{
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    return {name, [](GLuint framebuffer) { glDeleteFramebuffers(1, &framebuffer); }};
}

Handle make_buffer()
{
    GLuint name = 0;
    glGenBuffers(1, &name);
    return {name, [](GLuint buffer) { glDeleteBuffers(1, &buffer); }};
}

Handle make_vertex_array()
{
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    return {name, [](GLuint array) { glDeleteVertexArrays(1, &array); }};
}

Handle make_program(const std::string& vertex_shader, const std::string& fragment_shader)
{
    const GLuint vertex = compile(GL_VERTEX_SHADER, vertex_shader);
    const GLuint fragment = compile(GL_FRAGMENT_SHADER, fragment_shader);
    Handle program(glCreateProgram(), [](GLuint name) { glDeleteProgram(name); });
    glAttachShader(program, vertex);
    glAttachShader(program, fragment);
    glLinkProgram(program);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked == 0)
        throw std::runtime_error("shaders do not link");
    return program;
}

void set(GLuint program, const char* name, int value)
{
    glUniform1i(glGetUniformLocation(program, name), value);
}

void set(GLuint program, const char* name, double value)
{
    glUniform1f(glGetUniformLocation(program, name), static_cast<float>(value));
}

void set(GLuint program, const char* name, const Vec3& value)
{
    const Eigen::Vector3f single = value.cast<float>();
    glUniform3fv(glGetUniformLocation(program, name), 1, single.data());
}

void set(GLuint program, const char* name, const Mat3& value)
{
    const Eigen::Matrix3f single = value.cast<float>();
    glUniformMatrix3fv(glGetUniformLocation(program, name), 1, GL_FALSE, single.data());
}

void set(GLuint program, const char* name, const Eigen::Matrix4d& value)
{
    const Eigen::Matrix4f single = value.cast<float>();
    glUniformMatrix4fv(glGetUniformLocation(program, name), 1, GL_FALSE, single.data());
}

}  // namespace enduring::graphics
