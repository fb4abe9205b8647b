#pragma once

namespace enduring::graphics {

/// Makes the process' one context current: OpenGL 3.3 core, without a window, drawn by the
/// CPU. Two libraries know how, OSMesa (context/osmesa.cpp) and, on systems that no longer
/// have it, EGL (context/egl.cpp); the build links one of them.
/// @throws std::runtime_error  the library gives none
void make_current();

}  // namespace enduring::graphics
