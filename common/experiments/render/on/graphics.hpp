#pragma once

// The only place that speaks OpenGL's own names: three things that clean up after themselves.

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
// The functions past OpenGL 1.1 come from here.
#include <GL/glext.h>

#include "common/geometry/vector.hpp"

#include <functional>
#include <string>

namespace enduring::graphics {

/// A name that OpenGL gave and that must be given back.
class Handle {
public:
    Handle() = default;
    Handle(GLuint name, std::function<void(GLuint)> give_back) : name_(name), give_back_(std::move(give_back))
    {}
    ~Handle()
    {
        if (give_back_)
            give_back_(name_);
    }
    Handle(Handle&& other) noexcept { swap(other); }
    Handle& operator=(Handle&& other) noexcept
    {
        swap(other);
        return *this;
    }
    operator GLuint() const { return name_; }

private:
    void swap(Handle& other) noexcept
    {
        std::swap(name_, other.name_);
        std::swap(give_back_, other.give_back_);
    }
    GLuint name_ = 0;
    std::function<void(GLuint)> give_back_;
};

Handle make_texture();
Handle make_framebuffer();
Handle make_buffer();
Handle make_vertex_array();

/// @throws std::runtime_error  with the compiler's words; a mistake in our own shaders
Handle make_program(const std::string& vertex_shader, const std::string& fragment_shader);

void set(GLuint program, const char* name, int value);
void set(GLuint program, const char* name, double value);
void set(GLuint program, const char* name, const Vec3& value);
void set(GLuint program, const char* name, const Mat3& value);
void set(GLuint program, const char* name, const Eigen::Matrix4d& value);

}  // namespace enduring::graphics
