#pragma once

#include <string>

namespace enduring::shaders {

extern const std::string depth_vertex, depth_fragment;  ///< fills one shadow map
extern const std::string stage_vertex;                  ///< all that stands on the stage
extern const std::string surface_fragment;              ///< bodies and grounds in the light
extern const std::string annotation_fragment;           ///< dots, arrows, tinted triangles
extern const std::string screen_vertex;                 ///< one triangle over the whole picture
extern const std::string backdrop_fragment, develop_fragment;

}  // namespace enduring::shaders
