#pragma once

#include "common/experiments/run/probes.hpp"
#include "common/rigid/rigid_motion.hpp"
#include "common/scenes/scene.hpp"

#include <filesystem>
#include <vector>

namespace enduring {

/// What an animation costs. Viewers interpolate between its frames along straight lines.
struct AnimationLimits {
    double frame = 1.0 / 30;  ///< from one frame to the next [s], not less than a step
    /// Frames of a soft body, of which each is a surface of its own: 64 of 5000 vertices are 4 MB. With more
    /// of them files grow and viewers slow down; with a tenth of them a bounce loses its shape.
    std::size_t soft_frames = 64;
};

/// Watches a run and leaves it as one glTF file (.glb) with an animation, for Blender, f3d or a web page.
///
/// What moves as a whole is a node with translations and rotations; a soft body is a mesh with a morph target
/// for each of its frames. Colours are those of the pictures; planes are squares. Units are metres, y is up.
/// https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
class GltfAnimation final : public Probe {
public:
    /// @param scene  gives the colours
    /// @param file   ends with .glb
    /// @throws InputError  another ending; a place that cannot be written; the program was built without
    ///     TinyGLTF
    GltfAnimation(const Scene& scene, std::filesystem::path file, const AnimationLimits& limits = {});
    void observe(const World& world, const Contacts& contacts, double dt) override;
    /// Writes the file; without a frame it writes none.
    /// @throws InputError  it cannot be written
    void finish() const;

    /// One body's frames: poses, or the surfaces of what changes its shape.
    struct Track {
        std::vector<Vec3>
            points{};  ///< drawn, of the first frame; of what moves as a whole in its own coordinates [m]
        std::vector<Vec3> vertices{};  ///< the body's own, of the first frame [m]
        std::vector<Face> faces{};
        Vec3 color = Vec3::Zero();
        bool closed = true, soft = false, moves = false;
        std::string name{};
        std::vector<double> times{};  ///< [s]
        std::vector<Pose> poses{};
        std::vector<std::vector<Vec3>> surfaces{};
        int stride = 1, newest = 0;  ///< every so many frames, and the newest one
    };
    const std::vector<Track>& tracks() const { return tracks_; }

private:
    void begin(const World& world);

    const Scene& scene_;
    std::filesystem::path file_;
    AnimationLimits limits_;
    std::vector<Track> tracks_;
    std::vector<Plane> planes_;
    int frames_ = 0;
};

}  // namespace enduring
