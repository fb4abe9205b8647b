#include "common/experiments/gltf/gltf_file.hpp"

#include "common/experiments/render/palette.hpp"
#include "common/experiments/report/report.hpp"
#include "common/input/input_error.hpp"

#ifdef ENDURING_GLTF
#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <sstream>
#endif

namespace enduring {

#ifndef ENDURING_GLTF

void require_gltf()
{
    throw InputError("--gltf: this program was built without TinyGLTF (Debian: libtinygltf-dev)");
}
void write_gltf(const std::filesystem::path&, const std::vector<GltfAnimation::Track>&,
                const std::vector<Plane>&)
{
    require_gltf();
}

#else

void require_gltf() {}

namespace {

using Track = GltfAnimation::Track;

/// A model whose one buffer grows by an array at a time.
class ModelWriter {
public:
    ModelWriter()
    {
        model_.asset.version = "2.0";
        model_.asset.generator = "Enduring Contacts";
        model_.buffers.emplace_back();
        model_.scenes.emplace_back();
        model_.defaultScene = 0;
    }
    const tinygltf::Model& model() const { return model_; }

    void add(const Track& track)
    {
        const int node = add_node(track.name, add_mesh(track));
        place(node, track);  // where it begins, for viewers that play nothing
        if (!track.moves || track.times.size() < 2)
            return;
        if (track.soft)
            animate(node, track, "weights", add_weights(track.surfaces.size()));
        else
            add_poses(node, track);
    }

private:
    static std::vector<float> floats(const std::vector<Vec3>& points)
    {
        std::vector<float> numbers;
        numbers.reserve(3 * points.size());
        for (const Vec3& point : points)
            for (const double x : point)
                numbers.push_back(static_cast<float>(x));
        return numbers;
    }

    /// @param components  numbers of an element of the array
    /// @param target      what the array is for, 0 for an animation
    template <class T>
    int add_array(const std::vector<T>& numbers, int components, int type, int component_type, int target,
                  bool with_bounds)
    {
        std::vector<unsigned char>& bytes = model_.buffers.front().data;
        tinygltf::BufferView view;
        view.buffer = 0;
        view.byteOffset = bytes.size();
        view.byteLength = numbers.size() * sizeof(T);
        view.target = target;
        bytes.resize(bytes.size() + view.byteLength);
        std::memcpy(bytes.data() + view.byteOffset, numbers.data(), view.byteLength);
        model_.bufferViews.push_back(std::move(view));

        tinygltf::Accessor accessor;
        accessor.bufferView = static_cast<int>(model_.bufferViews.size()) - 1;
        accessor.componentType = component_type;
        accessor.type = type;
        accessor.count = numbers.size() / static_cast<std::size_t>(components);
        for (std::size_t c = 0; with_bounds && c < static_cast<std::size_t>(components); ++c) {
            double least = static_cast<double>(numbers.at(c)), most = least;
            for (std::size_t i = c; i < numbers.size(); i += static_cast<std::size_t>(components)) {
                least = std::min(least, static_cast<double>(numbers[i]));
                most = std::max(most, static_cast<double>(numbers[i]));
            }
            accessor.minValues.push_back(least);
            accessor.maxValues.push_back(most);
        }
        model_.accessors.push_back(std::move(accessor));
        return static_cast<int>(model_.accessors.size()) - 1;
    }

    int add_points(const std::vector<Vec3>& points)
    {
        return add_array(floats(points), 3, TINYGLTF_TYPE_VEC3, TINYGLTF_COMPONENT_TYPE_FLOAT,
                         TINYGLTF_TARGET_ARRAY_BUFFER, true);
    }
    int add_numbers(const std::vector<float>& numbers, int components, int type, bool with_bounds = false)
    {
        return add_array(numbers, components, type, TINYGLTF_COMPONENT_TYPE_FLOAT, 0, with_bounds);
    }

    int add_material(const Track& track)
    {
        tinygltf::Material material;
        material.name = track.name;
        material.pbrMetallicRoughness.baseColorFactor = {track.color.x(), track.color.y(), track.color.z(),
                                                         1};
        material.pbrMetallicRoughness.metallicFactor = 0;
        material.pbrMetallicRoughness.roughnessFactor = 0.7;
        material.doubleSided = !track.closed;
        model_.materials.push_back(std::move(material));
        return static_cast<int>(model_.materials.size()) - 1;
    }

    /// A soft body's surface is that of its first frame, plus its way from there for each frame that follows.
    int add_mesh(const Track& track)
    {
        std::vector<std::uint32_t> corners;
        corners.reserve(3 * track.faces.size());
        for (const Face& face : track.faces)
            corners.insert(corners.end(), face.begin(), face.end());
        tinygltf::Primitive primitive;
        primitive.mode = TINYGLTF_MODE_TRIANGLES;
        primitive.material = add_material(track);
        primitive.attributes["POSITION"] = add_points(track.points);
        primitive.indices = add_array(corners, 1, TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                                      TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, false);
        tinygltf::Mesh mesh;
        mesh.name = track.name;
        for (std::size_t frame = 1; frame < track.surfaces.size(); ++frame) {
            std::vector<Vec3> ways;
            ways.reserve(track.points.size());
            for (std::size_t i = 0; i < track.points.size(); ++i)
                ways.emplace_back(track.surfaces[frame][i] - track.points[i]);
            primitive.targets.push_back({{"POSITION", add_points(ways)}});
            mesh.weights.push_back(0);
        }
        mesh.primitives.push_back(std::move(primitive));
        model_.meshes.push_back(std::move(mesh));
        return static_cast<int>(model_.meshes.size()) - 1;
    }

    int add_node(const std::string& name, int mesh)
    {
        tinygltf::Node node;
        node.name = name;
        node.mesh = mesh;
        model_.nodes.push_back(std::move(node));
        const int index = static_cast<int>(model_.nodes.size()) - 1;
        model_.scenes.front().nodes.push_back(index);
        return index;
    }

    void place(int node, const Track& track)
    {
        if (track.poses.empty())
            return;
        const Pose& pose = track.poses.front();
        tinygltf::Node& placed = model_.nodes[static_cast<std::size_t>(node)];
        placed.translation = {pose.position.x(), pose.position.y(), pose.position.z()};
        const Eigen::Vector4d turn = pose.orientation.coeffs();  // x, y, z, w
        placed.rotation = {turn[0], turn[1], turn[2], turn[3]};
    }

    void add_poses(int node, const Track& track)
    {
        std::vector<Vec3> places;
        std::vector<float> turns;
        places.reserve(track.poses.size());
        turns.reserve(4 * track.poses.size());
        for (const Pose& pose : track.poses) {
            places.push_back(pose.position);
            const Eigen::Vector4f turn = pose.orientation.coeffs().cast<float>().normalized();
            turns.insert(turns.end(), turn.begin(), turn.end());
        }
        animate(node, track, "translation", add_numbers(floats(places), 3, TINYGLTF_TYPE_VEC3));
        animate(node, track, "rotation", add_numbers(turns, 4, TINYGLTF_TYPE_VEC4));
    }

    /// At frame i target i - 1 counts alone; at the first one none does.
    int add_weights(std::size_t frames)
    {
        std::vector<float> weights(frames * (frames - 1), 0.0F);
        for (std::size_t frame = 1; frame < frames; ++frame)
            weights[frame * (frames - 1) + frame - 1] = 1;
        return add_numbers(weights, 1, TINYGLTF_TYPE_SCALAR);
    }

    void animate(int node, const Track& track, const char* path, int output)
    {
        if (model_.animations.empty()) {
            model_.animations.emplace_back();
            model_.animations.front().name = "run";
        }
        const std::vector<float> times(track.times.begin(), track.times.end());
        tinygltf::AnimationSampler sampler;
        sampler.input = add_numbers(times, 1, TINYGLTF_TYPE_SCALAR, true);
        sampler.output = output;
        sampler.interpolation = "LINEAR";
        tinygltf::Animation& animation = model_.animations.front();
        animation.samplers.push_back(std::move(sampler));
        tinygltf::AnimationChannel channel;
        channel.sampler = static_cast<int>(animation.samplers.size()) - 1;
        channel.target_node = node;
        channel.target_path = path;
        animation.channels.push_back(std::move(channel));
    }

    tinygltf::Model model_;
};

/// A square on the plane, below all that was there at the first frame and three times as wide.
Track square(const Plane& plane, const std::vector<Track>& tracks)
{
    Eigen::AlignedBox3d all;
    for (const Track& track : tracks)
        for (const Vec3& point : track.points)
            all.extend(track.poses.empty() ? point : track.poses.front().to_world(point));
    const Vec3 middle = all.center() - plane.normal.dot(all.center() - plane.point) * plane.normal;
    const Vec3 along = 1.5 * all.diagonal().norm() * plane.normal.unitOrthogonal(),
               across = plane.normal.cross(along);
    return {.points = {middle - along - across, middle + along - across, middle + along + across,
                       middle - along + across},
            .faces = {{0, 1, 2}, {0, 2, 3}},
            .color = palette::ivory,
            .closed = false,
            .name = plane.name};
}

}  // namespace

void write_gltf(const std::filesystem::path& file, const std::vector<Track>& tracks,
                const std::vector<Plane>& planes)
{
    ModelWriter writer;
    for (const Track& track : tracks)
        writer.add(track);
    for (const Plane& plane : planes)
        writer.add(square(plane, tracks));
    std::ostringstream bytes;  // the library does not notice a full disk
    tinygltf::TinyGLTF().WriteGltfSceneToStream(&writer.model(), bytes, false, true);
    write_file(file, bytes.str());
}

#endif

}  // namespace enduring
