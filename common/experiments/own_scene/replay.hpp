#pragma once

#include "common/experiments/run/probes.hpp"
#include "common/scenes/scene.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace enduring {

/// Watches a run and leaves it as one file that the book's laboratory shows again (./course lab replay.json).
///
/// The file is JSON. "scene" is shown_scene(), and the points of each body. "frames" have shown_numbers();
/// "motion", the bodies in their order: nothing of one at rest, position and quaternion (w last) of a rigid
/// one, all vertices of another; "pairs", the pair_numbers() of each; and joint_numbers() where there are
/// "joints". These lists are floats of 32 bits in base64; behind the last number there may be zeros.
class Replay final : public Probe {
public:
    /// With a tenth of it a bounce of the bunny keeps 50 of its frames; ten times of it, and a phone does not
    /// load it.
    static constexpr std::size_t most_bytes = 16U << 20;

    /// @param scene   gives colours and camera
    /// @param solver  how the page calls it
    /// @param most    bytes of all frames: above it, every other frame goes
    Replay(const Scene& scene, std::string solver, std::size_t most = most_bytes);
    void observe(const World& world, const Contacts& contacts, double dt) override;
    /// @throws InputError  it cannot be written
    void write(const std::filesystem::path& file) const;

private:
    struct Frame {
        std::string numbers, motion, pairs, joints;
    };

    void begin(const World& world);
    void thin_out();

    const Scene& scene_;
    std::string solver_, described_;
    std::size_t most_, bytes_ = 0;
    std::vector<Frame> frames_;
    int seen_ = 0, newest_ = 0, stride_ = 1;  ///< every so many steps, and the newest one
};

}  // namespace enduring
