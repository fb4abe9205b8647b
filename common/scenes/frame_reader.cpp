#include "common/scenes/frame_reader.hpp"

#include "common/geometry/read_obj.hpp"
#include "common/geometry/read_surface.hpp"
#include "common/rigid/mass_properties.hpp"

#include <cmath>

namespace enduring {
namespace {

const NumberRange coordinate{-1e4, 1e4, true, true, "m"};

SurfaceMesh read_frame_file(const JsonValue& value, const SceneSurroundings& surroundings)
{
    const std::filesystem::path path = find_mesh(value, surroundings.mesh_folders);
    if (ending_of(path) != ".obj")
        value.fail("a file of points and edges ending in .obj");
    return read_obj_frame(path, surroundings.limits.surface_faces);
}

std::vector<Vec3> read_vertices(const JsonValue& value, const SceneLimits& limits)
{
    std::vector<Vec3> vertices;
    for (const JsonValue& entry :
         value.at("vertices").items(2, static_cast<std::size_t>(limits.surface_faces)))
        vertices.push_back(entry.vector(coordinate));
    return vertices;
}

/// @throws InputError  edges that are no edges, all points at one place
void check_frame(const JsonValue& value, const SurfaceMesh& frame)
{
    try {
        (void)topology_of(frame);
        (void)frame_properties(frame, 1);
    } catch (const InputError& error) {
        value.pass_on(error);
    }
}

}  // namespace

SurfaceMesh read_points(const JsonValue& value, const SceneSurroundings& surroundings)
{
    value.require_keys({"vertices", "file"});
    SurfaceMesh cloud;
    if (const std::optional<JsonValue> file = value.find("file")) {
        if (const std::optional<JsonValue> beside = value.find("vertices"))
            beside->complain("stands beside \"file\"; one of the two is enough");
        cloud = read_frame_file(*file, surroundings);
        if (!cloud.wires.empty())
            file->complain("the file has lines; a shape of points and edges is a \"wire\"");
    } else {
        cloud.vertices = read_vertices(value, surroundings.limits);
    }
    check_frame(value, cloud);
    return cloud;
}

SurfaceMesh read_wire(const JsonValue& value, const SceneSurroundings& surroundings)
{
    value.require_keys({"vertices", "edges", "file"});
    SurfaceMesh frame;
    if (const std::optional<JsonValue> file = value.find("file")) {
        for (const char* key : {"vertices", "edges"})
            if (const std::optional<JsonValue> beside = value.find(key))
                beside->complain("stands beside \"file\"; one of the two is enough");
        frame = read_frame_file(*file, surroundings);
        if (frame.wires.empty())
            file->complain("the file has no line; a shape of points alone is \"points\"");
    } else {
        frame.vertices = read_vertices(value, surroundings.limits);
        const auto last = static_cast<int>(frame.vertices.size()) - 1;
        for (const JsonValue& entry :
             value.at("edges").items(1, static_cast<std::size_t>(surroundings.limits.surface_faces))) {
            const std::vector<JsonValue> ends = entry.items(2, 2);
            frame.wires.push_back({ends[0].integer(0, last), ends[1].integer(0, last)});
        }
    }
    check_frame(value, frame);
    const SurfaceTopology topology = topology_of(frame);
    for (int v = 0; v < topology.vertex_count(); ++v)
        if (topology.edges_around_vertex(v).empty())
            value.complain("vertex " + std::to_string(v) + " is in no edge, so it has no mass");
    return frame;
}

void refuse_turns_about_own_line(const JsonValue& body, std::span<const Vec3> placed)
{
    const std::optional<Vec3> line = common_line(placed);
    if (!line)
        return;
    constexpr double along = 1e-9;  // of a spin: less is rounding of how the body was turned
    if (const std::optional<JsonValue> spin = body.find("angular_velocity")) {
        const Vec3 given = spin->vector({-1e4, 1e4, true, true, "rad/s"});
        if (std::abs(line->dot(given)) > along * given.norm())
            spin->complain(
                "has a part along the line on which all points of the body lie: nothing turns there");
    }
    if (const std::optional<JsonValue> forces = body.find("forces"))
        for (const JsonValue& entry : forces->items(0, 1000))
            if (const std::optional<JsonValue> torque = entry.find("torque"))
                torque->complain(
                    "acts on a body whose points all lie on one line; give two forces at two of its points");
}

}  // namespace enduring
