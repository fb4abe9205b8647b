#pragma once

#include "common/experiments/render/film_probes.hpp"

#include <filesystem>
#include <vector>

namespace enduring {

/// Watches a run and keeps what its pictures will show. They are drawn when it is over, because only then is
/// it known where the camera has to stand: it is the scene's, or where the scene names none, one that sees
/// every moment that is shown.
class RunPictures final : public Probe {
public:
    /// What is shown: `pictures` moments, evenly over the run, and a film if `filmed`. A second of the run
    /// takes a second of the film, unless it would have more than max_frames: then the run is shown faster.
    struct Shown {
        int pictures = 6;
        bool filmed = true;
        MarkContacts mark = mark_pairs;  ///< on the pictures
    };
    static constexpr int frames_per_second = 20, max_frames = 600;

    /// @param scene  looks, camera, step and duration; outlives this
    explicit RunPictures(const Scene& scene) : RunPictures(scene, Shown{}) {}
    RunPictures(const Scene& scene, Shown shown);
    void observe(const World& world, const Contacts& contacts, double dt) override;

    Camera camera() const;
    int frames() const { return static_cast<int>(frames_.size()); }
    /// The pictures, `columns` in a row, each with its time.
    Picture strip_of_all(int columns) const;
    /// @param file  as for Clip
    void write_film(const std::filesystem::path& file) const;

private:
    struct Moment {
        double time;
        Stage stage;
    };
    using Positions = std::vector<std::vector<Vec3>>;  ///< by body

    const Scene& scene_;
    Shown shown_;
    double begin_;       ///< of the run [s]
    double frame_time_;  ///< of the run, from one frame to the next [s]
    std::vector<Moment> moments_;
    std::vector<Positions> frames_;
};

}  // namespace enduring
