#include "chapters/06_redefinition/experiments/plane_slide.hpp"

#include "common/experiments/run/run.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter06 {
namespace {

Vec3 direction_of(const PlaneSlide& slide)
{
    const double angle = slide.direction * std::numbers::pi / 4;
    return {std::cos(angle), 0, std::sin(angle)};
}

/// One cell is 0.1 m; diagonally the cube crosses as many rows as columns.
double distance_of(const PlaneSlide& slide)
{
    return 0.1 * slide_cells * (slide.direction % 2 == 0 ? 1 : std::numbers::sqrt2);
}

/// Follows the cube.
class SlideProbe final : public Probe {
public:
    SlideProbe(const PlaneSlide& slide, double duration)
        : direction_(direction_of(slide)), settled_(duration / 10), stiffness_(slide.stiffness)
    {}

    void observe(const World& world, const Contacts& contacts, double) override
    {
        const Body& cube = body_named(world, "cube");
        const Vec3 velocity = cube.mean_velocity() / slide_speed;
        const double along = velocity.dot(direction_);
        if (std::abs(along - 1) > std::abs(outcome_.speed_change))
            outcome_.speed_change = along - 1;
        const Vec3 across(-direction_.z(), 0, direction_.x());
        outcome_.sideways_speed = std::max(outcome_.sideways_speed, std::abs(velocity.dot(across)));
        if (world.time > settled_) {
            double lowest = INFINITY;
            for (const Vec3& x : cube.positions_t0())
                lowest = std::min(lowest, x.y());
            outcome_.lowest = std::min(outcome_.lowest, lowest);
            outcome_.highest = std::max(outcome_.highest, lowest);
        }
        pushes_ += std::count_if(contacts.begin(), contacts.end(),
                                 [](const Contact& c) { return c.answered(); });
        mass_times_gravity_ = -cube.mass() * world.gravity.y();
        ++looks_;
    }

    SlideOutcome outcome() const
    {
        SlideOutcome result = outcome_;
        // the first look is before any step
        result.mean_pairs = static_cast<double>(pushes_) / static_cast<double>(looks_ - 1);
        result.sag = mass_times_gravity_ / (result.mean_pairs * stiffness_);
        return result;
    }

private:
    Vec3 direction_;
    double settled_, stiffness_, mass_times_gravity_ = 0;
    long pushes_ = 0, looks_ = 0;
    SlideOutcome outcome_{.lowest = INFINITY, .highest = -INFINITY};
};

}  // namespace

std::string name_of(GridDiagonals diagonals)
{
    switch (diagonals) {
        case GridDiagonals::same: return "same";
        case GridDiagonals::alternating: return "alternating";
        case GridDiagonals::crossed: break;
    }
    return "crossed";
}

Scene scene_of(const PlaneSlide& slide)
{
    // The cube's half side is 2.5 cells, so a middle in the middle of a
    // cell puts its faces on lines of the grid.
    const Vec3 middle = slide.on_lattice ? Vec3(0.05, 0.2500001, 0.05) : Vec3(0.013, 0.2500001, 0.027);
    const Vec3 start = middle - distance_of(slide) / 2 * direction_of(slide),
               velocity = slide_speed * direction_of(slide);
    const auto list = [](const Vec3& v) { return nlohmann::json{v.x(), v.y(), v.z()}; };
    const nlohmann::json change{{"dt", slide.dt},
                                {"duration", distance_of(slide) / slide_speed},
                                {"contact", {{"stiffness", slide.stiffness}}},
                                {"/bodies/floor/shape/plane_grid/diagonals", name_of(slide.diagonals)},
                                {"/bodies/cube/position", list(start)},
                                {"/bodies/cube/velocity", list(velocity)}};
    return load_scene(scene_file("sliding_plane"), change.dump());
}

SlideOutcome slide_over_plane(const PlaneSlide& slide, const Solver& solver, Probe* observer)
{
    Scene scene = scene_of(slide);
    SlideProbe probe(slide, scene.duration);
    std::vector<Probe*> probes{&probe};
    if (observer)
        probes.push_back(observer);
    run(scene, solver, probes, {.may_gain_energy = slide.may_gain_energy});
    return probe.outcome();
}

}  // namespace enduring::chapter06
