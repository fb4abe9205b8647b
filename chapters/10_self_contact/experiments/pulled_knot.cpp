#include "chapters/10_self_contact/experiments/pulled_knot.hpp"

#include "chapters/10_self_contact/experiments/bent_bars.hpp"

#include <algorithm>

namespace enduring::chapter10 {

SoftRun pulled_knot(double mu, double force)
{
    const SoftVariant variant{.young = 1e5, .cells = 5, .dt = 0.005, .mu = mu};
    constexpr double thickness = 0.01, kept = 0.4;  // [m]; of the pull, later
    SoftRun run = soft_run(variant);
    run.scene.world.gravity.setZero();
    add_soft(run.scene, "rope", overhand_knot(0.045, 0.06, thickness, 48), variant);
    const auto places = run.scene.world.bodies[0]->positions_t0();
    const auto [left, right] = std::minmax_element(
        places.begin(), places.end(), [](const Vec3& a, const Vec3& b) { return a.x() < b.x(); });
    for (const double side : {-1, 1}) {
        Pull pull{.force = {side * kept * force, 0, 0}, .until = knot_pulled + knot_eased};
        for (std::size_t vertex = 0; vertex < places.size(); ++vertex)
            if (side * (places[vertex].x() - (side < 0 ? left : right)->x()) > -thickness / 10)
                pull.vertices.push_back(static_cast<int>(vertex));
        run.pulls.push_back(pull);
    }
    for (const int end : {0, 1}) {
        Pull harder = run.pulls[end];
        harder.force *= 1 / kept - 1;
        harder.until = knot_pulled;
        run.pulls.push_back(harder);
    }
    run.scene.camera = {{0, 0.2, 0.75}, {0, -0.01, 0}, 17};
    run.scene.looks["rope"] = {palette::terracotta, false};
    return run;
}

double knot_span(const SoftRun& run, const World& world)
{
    const auto middle = [&](const Pull& pull) {
        Vec3 sum = Vec3::Zero();
        for (const int vertex : pull.vertices)
            sum += world.bodies[0]->positions_t0()[vertex];
        return Vec3(sum / static_cast<double>(pull.vertices.size()));
    };
    return (middle(run.pulls[1]) - middle(run.pulls[0])).norm();
}

}  // namespace enduring::chapter10
