#include "common/experiments/render/on/context.hpp"

#include <GL/osmesa.h>

#include <array>
#include <stdexcept>

namespace enduring::graphics {
namespace {

OSMesaContext make_context()
{
    const std::array<int, 11> attributes{OSMESA_FORMAT,
                                         OSMESA_RGBA,
                                         OSMESA_PROFILE,
                                         OSMESA_CORE_PROFILE,
                                         OSMESA_CONTEXT_MAJOR_VERSION,
                                         3,
                                         OSMESA_CONTEXT_MINOR_VERSION,
                                         3,
                                         0,
                                         0,
                                         0};
    OSMesaContext context = OSMesaCreateContextAttribs(attributes.data(), nullptr);
    if (context == nullptr)
        throw std::runtime_error("OSMesa gives no OpenGL 3.3 context");
    return context;
}

}  // namespace

void make_current()
{
    static OSMesaContext context = make_context();
    static std::array<unsigned char, 4> pixel{};  // every picture goes to a framebuffer of its own
    if (OSMesaGetCurrentContext() != context &&
        OSMesaMakeCurrent(context, pixel.data(), GL_UNSIGNED_BYTE, 1, 1) == GL_FALSE)
        throw std::runtime_error("OSMesa's context cannot be made current");
}

}  // namespace enduring::graphics
