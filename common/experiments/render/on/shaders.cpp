#include "common/experiments/render/on/shaders.hpp"

namespace enduring::shaders {

const std::string depth_vertex = R"(#version 330 core
layout(location = 0) in vec3 position;
uniform mat3 light;      // rows: across, upward, toward the light
uniform float radius;
void main()
{
    vec3 q = light * position / radius;
    gl_Position = vec4(q.xy, -q.z, 1);
}
)";

const std::string depth_fragment = R"(#version 330 core
void main() {}
)";

const std::string stage_vertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 color;
layout(location = 3) in vec3 barycentric;
uniform mat4 view_projection;
out vec3 p, n, albedo, corner;
void main()
{
    p = position;
    n = normal;
    albedo = color;
    corner = barycentric;
    gl_Position = view_projection * vec4(position, 1);
}
)";

static const std::string backdrop = R"(
uniform float picture_height;
vec3 backdrop()
{
    return mix(vec3(0.905, 0.890, 0.862), vec3(0.742, 0.738, 0.732), smoothstep(0.0, 1.0, gl_FragCoord.y / picture_height));
}
)";

// Each of the four samples of a pixel sees a quarter of the lights;
// averaging the samples brings them together.
static const std::string light = R"(
const int lights = 28;
uniform mat3 light[lights];
uniform vec3 radiance[lights];
uniform int sun_lights;
uniform sampler2DArrayShadow shadows;
uniform float radius, texel;

float visibility(int i, vec3 point)
{
    vec3 q = light[i] * point / radius;
    return texture(shadows, vec4(0.5 + 0.5 * q.xy, i, min(0.5 - 0.5 * q.z - 0.0015, 1.0)));
}

vec3 toward(int i) { return vec3(light[i][0][2], light[i][1][2], light[i][2][2]); }

struct Light { vec3 diffuse, gloss; };

// A hash of a place on the screen (PCG, Jarzynski and Olano 2020): the same grain in every picture.
float grain(uvec2 place)
{
    uint state = place.x * 747796405u + place.y * 2891336453u;
    state = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return float(((state >> 22u) ^ state) & 0xffffu) / 65536.0;
}

Light light_at(vec3 point, vec3 normal, vec3 view)
{
    Light sum = Light(vec3(0), vec3(0));
    vec3 lifted = point + 1.7 * texel * normal;
    vec3 x = normalize(abs(normal.x) < 0.9 ? cross(normal, vec3(1, 0, 0)) : cross(normal, vec3(0, 0, 1))), y = cross(normal, x);
    int first = (int(gl_FragCoord.x) & 1) + 2 * (int(gl_FragCoord.y) & 1);
    uvec2 pixel = uvec2(gl_FragCoord.xy) / 2u;
    // four neighbours share the circle
    float quarter = float((pixel.x & 1u) ^ (pixel.y & 1u)) * 0.5 + float(pixel.y & 1u) * 0.25;
    float turn = 6.2831853 * (grain(pixel / 2u) + quarter), reach = fract(grain(pixel / 2u + 7919u) + quarter);
    for (int i = first; i < lights; i += 4) {
        float facing = dot(normal, toward(i));
        if (facing <= 0)
            continue;
        // A few directions stand for the whole sky: looking from places a
        // little apart along the surface hides the gaps.
        reach = fract(reach + 0.618034);
        turn += 2.3999632;
        float away = radius * (i < sun_lights ? 0.015 : 0.05) * sqrt(reach);
        vec3 seen = 4 * facing * radiance[i] * visibility(i, lifted + away * (cos(turn) * x + sin(turn) * y));
        sum.diffuse += seen;
        if (i < sun_lights)
            sum.gloss += seen * pow(max(0, dot(normal, normalize(toward(i) + view))), 40.0);
    }
    return sum;
}
)";

static const std::string surface_main = R"(
in vec3 p, n, albedo, corner;
uniform vec3 eye, floor_point, floor_normal, fade_centre;
uniform vec3 open_floor;   // light on a level floor without shadows
uniform bool is_ground;
uniform float opacity, line_width, grid;
out vec4 result;

// A body stands between the sky's light and what the floor throws
// back; close to the floor lies its own shadow.
vec3 bounce(vec3 normal)
{
    float below = 0.5 - 0.5 * dot(normal, floor_normal);
    float height = max(0, dot(p - floor_point, floor_normal)) / radius;
    return vec3(0.36, 0.34, 0.31) * below * (0.25 + 0.75 * smoothstep(0.0, 0.7, height));
}

// A thin line along the triangle's edges; where triangles are hardly larger
// than the line it fades instead of filling them.
float edge_line()
{
    vec3 slope = fwidth(corner), away = corner / slope;
    float nearest = min(away.x, min(away.y, away.z)), height = 1 / max(slope.x, max(slope.y, slope.z));
    float line = 1 - smoothstep(0.5 * line_width - 0.6, 0.5 * line_width + 0.6, nearest);
    return line * smoothstep(1.0, 10.0, height / line_width);
}

vec3 body_color()
{
    vec3 view = normalize(eye - p);
    vec3 normal = normalize(n);
    if (!gl_FrontFacing)
        normal = -normal;
    Light arriving = light_at(p, normal, view);
    float rim = pow(1 - max(0, dot(normal, view)), 4.0);
    vec3 color = albedo * (arriving.diffuse + bounce(normal)) + 0.10 * arriving.gloss + 0.06 * rim * arriving.diffuse;
    return line_width > 0 ? mix(color, 0.22 * color, 0.75 * edge_line()) : color;
}

float grid_line(vec3 along)
{
    float x = dot(p - floor_point, along) / grid, width = fwidth(x);
    float line = 1 - smoothstep(0.4 * width, 1.6 * width, abs(fract(x - 0.5) - 0.5));
    return line * (1 - smoothstep(0.1, 0.4, width));
}

// The ground is the backdrop itself, darkened by shadows and lines: it has no border and no horizon.
vec4 ground_color()
{
    float fade = 1 - smoothstep(0.6, 1.5, length(p - fade_centre) / length(eye - fade_centre));
    if (fade == 0)
        return vec4(backdrop(), 1);
    Light arriving = light_at(p, n, normalize(eye - p));
    vec3 across = normalize(abs(n.x) < 0.9 ? cross(n, vec3(1, 0, 0)) : cross(n, vec3(0, 0, 1)));
    float lines = grid > 0 ? max(grid_line(across), grid_line(cross(n, across))) : 0;
    return vec4(backdrop() * mix(vec3(1), arriving.diffuse / open_floor * (1 - 0.13 * lines), fade), 1);
}

void main() { result = is_ground ? ground_color() : vec4(body_color(), opacity); }
)";

const std::string surface_fragment = "#version 330 core\n" + backdrop + light + surface_main;

const std::string annotation_fragment = R"(#version 330 core
in vec3 p, n, albedo;
uniform vec3 eye;
uniform float opacity;
out vec4 result;
void main()
{
    float facing = abs(dot(normalize(n), normalize(eye - p)));
    result = vec4(albedo * (0.55 + 0.45 * facing) + 0.06 * pow(facing, 30.0), opacity);
}
)";

const std::string screen_vertex = R"(#version 330 core
void main()
{
    gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1);
}
)";

const std::string backdrop_fragment = "#version 330 core\n" + backdrop + R"(
out vec4 result;
void main() { result = vec4(backdrop(), 1); }
)";

// From light to bytes: 4 x 4 samples a pixel, weighted so that the four kinds of samples count alike; bright
// colours run into white softly; then the curve of a screen.
const std::string develop_fragment = R"(#version 330 core
uniform sampler2D samples;
out vec4 result;
void main()
{
    ivec2 corner = 2 * ivec2(gl_FragCoord.xy) - 1, last = textureSize(samples, 0) - 1;
    const float weight[4] = float[4](0.1, 0.4, 0.4, 0.1);
    vec3 light = vec3(0);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            light += weight[x] * weight[y] * texelFetch(samples, clamp(corner + ivec2(x, y), ivec2(0), last), 0).rgb;
    light = mix(light, 1 - 0.2 * exp(-(light - 0.8) / 0.2), greaterThan(light, vec3(0.8)));
    result = vec4(mix(12.92 * light, 1.055 * pow(light, vec3(1 / 2.4)) - 0.055, greaterThan(light, vec3(0.0031308))), 1);
}
)";

}  // namespace enduring::shaders
