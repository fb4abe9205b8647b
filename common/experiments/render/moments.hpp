#pragma once

#include "common/experiments/render/film_probes.hpp"

#include <string>
#include <vector>

namespace enduring {

/// What a run shows at one moment, not drawn yet: the camera may be chosen when all moments are known.
struct Moment {
    Stage stage;
    std::string caption;
};

/// Watches a run and keeps some moments.
class MomentsProbe final : public Probe {
public:
    /// @param scene    looks and camera; outlives the probe
    /// @param times    of the moments [s], ascending; each is taken at the step next to it
    /// @param caption  stands before the time
    MomentsProbe(const Scene& scene, std::vector<double> times, MarkContacts mark = {},
                 std::string caption = "");
    void observe(const World& world, const Contacts& contacts, double dt) override;
    const std::vector<Moment>& moments() const { return moments_; }

private:
    const Scene& scene_;
    std::vector<double> times_;
    MarkContacts mark_;
    std::string caption_;
    std::vector<Moment> moments_;
};

/// Gives all moments one camera, which sees every point of all of them.
/// @param towards  from the bodies to the camera, any length
/// @param aspect   width / height of the pictures
void frame_together(std::vector<Moment>& moments, const Vec3& towards, double aspect);

/// Gives each moment a camera of its own, as near as its bodies allow.
void frame_each(std::vector<Moment>& moments, const Vec3& towards, double aspect);

/// All moments side by side, `columns` in a row.
/// @param width, height  of one of them [px]
Picture draw_moments(const std::vector<Moment>& moments, int columns, int width, int height);

}  // namespace enduring
