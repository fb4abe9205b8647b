#include "common/experiments/render/on/context.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstdlib>
#include <stdexcept>

namespace enduring::graphics {
namespace {

struct SurfacelessContext {
    EGLDisplay display;
    EGLContext context;
};

SurfacelessContext make_context()
{
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);  // pictures do not depend on a graphics card
    const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY,
                                                     nullptr);
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE ||
        eglBindAPI(EGL_OPENGL_API) == EGL_FALSE)
        throw std::runtime_error("EGL gives no display without a screen");
    const std::array<EGLint, 7> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                           3,
                                           EGL_CONTEXT_MINOR_VERSION,
                                           3,
                                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                           EGL_NONE};
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT,
                                                attributes.data());
    if (context == EGL_NO_CONTEXT)
        throw std::runtime_error("EGL gives no OpenGL 3.3 context");
    return {display, context};
}

}  // namespace

void make_current()
{
    static const SurfacelessContext only = make_context();
    if (eglGetCurrentContext() != only.context &&
        eglMakeCurrent(only.display, EGL_NO_SURFACE, EGL_NO_SURFACE, only.context) == EGL_FALSE)
        throw std::runtime_error("EGL's context cannot be made current");
}

}  // namespace enduring::graphics
