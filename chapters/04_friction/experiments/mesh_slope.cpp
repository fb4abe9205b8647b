#include "chapters/04_friction/experiments/experiments.hpp"
#include "chapters/04_friction/experiments/launch.hpp"
#include "chapters/04_friction/friction_contact.hpp"
#include "chapters/04_friction/solver.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/run/run.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter04 {
namespace {

bool pushes_along(const World& world, const Contact& contact, double angle_deg)
{
    const Vec3 up = uphill(angle_deg);
    return std::abs(contact_geometry(world, contact, 0).normal.dot(Vec3(-up.y(), up.x(), 0))) <
           std::sqrt(0.5);
}

/// floor, time_s, distance_m, speed_m_per_s, pairs, sideways.
class BlockProbe final : public TableProbe {
public:
    BlockProbe(std::string floor, std::string block, double angle_deg)
        : TableProbe({"floor", "time_s", "distance_m", "speed_m_per_s", "pairs", "sideways"}),
          floor_(std::move(floor)), block_(std::move(block)), angle_deg_(angle_deg)
    {}
    void observe(const World& world, const Contacts& contacts, double) override
    {
        const Body& block = body_named(world, block_);
        const Vec3 middle = block.centre();
        const Vec3 up = uphill(angle_deg_);
        const auto sideways = std::count_if(contacts.begin(), contacts.end(), [&](const Contact& c) {
            return pushes_along(world, c, angle_deg_);
        });
        if (world.step == 0)
            start_ = middle.dot(up);
        const double way = middle.dot(up) - start_;
        farthest_ = std::max(farthest_, way);
        table_.add({floor_, world.time, way, block.linear_momentum().dot(up) / block.mass(),
                    static_cast<long>(contacts.size()), static_cast<long>(sideways)});
    }
    double farthest() const { return farthest_; }

private:
    std::string floor_, block_;
    double angle_deg_, start_ = 0, farthest_ = 0;
};

}  // namespace

/// What is left to do: on triangles friction works, and hooked pairs stop the block before it can.
void mesh_slope(const RunOptions& options, Report& report)
{
    constexpr double angle_deg = 10;
    Scene mesh = load_scene(options.scene.value_or(scene_file("block_on_triangles")));
    BlockProbe on_mesh("triangles", "block", angle_deg);
    const MarkContacts mark = [](Stage& stage, const World& world, const Contacts& contacts) {
        for (Drawable& drawable : stage.bodies)
            drawable.wireframe = true;
        Contacts along, outward;
        for (const Contact& contact : contacts)
            (pushes_along(world, contact, angle_deg) ? along : outward).push_back(contact);
        mark_contacts(stage, world, outward);
        mark_artefacts(stage, world, along);
    };
    StripProbe pictures(mesh, {0.04, 0.12, 0.3, 1.0}, mark, 560, 380);
    run(mesh, chapter04_solver(mesh.contact), {&on_mesh, &pictures});
    write_png(pictures.all(2), report.file("mesh_slope.png"));

    Scene plane = load_scene(scene_file("block_on_slope"));
    plane.contact = mesh.contact;
    BlockProbe on_plane("plane", "block", angle_deg);
    run(plane, chapter04_solver(plane.contact), {&on_plane});

    Table table({"floor", "time_s", "distance_m", "speed_m_per_s", "pairs", "sideways"});
    table.append(on_plane.table());
    table.append(on_mesh.table());
    report.table("mesh_slope", table);
    report.plot("chapters/04_friction/plots/mesh_slope.gp");
    report.fact("mesh_slope", "farthest_mesh", on_mesh.farthest(), 3);
    report.fact("mesh_slope", "farthest_plane", on_plane.farthest(), 3);
}

}  // namespace enduring::chapter04
