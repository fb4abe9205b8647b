#include "chapters/03_penalty_impulses/experiments/experiments.hpp"
#include "chapters/03_penalty_impulses/experiments/scene_change.hpp"
#include "chapters/03_penalty_impulses/solver.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/run/run.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace enduring::chapter03 {
namespace {

/// Of a contact whose normal lies closer to the floor than to the
/// upright, where every true contact here is upright.
bool pushes_sideways(const World& world, const Contact& contact)
{
    return std::abs(contact_geometry(world, contact, 0).normal.y()) < std::sqrt(0.5);
}

/// floor, time_s, x_m, speed_m_per_s, pairs, sideways: where the cube is,
/// and how many pairs push it along the floor.
class SlideProbe final : public TableProbe {
public:
    explicit SlideProbe(std::string floor)
        : TableProbe({"floor", "time_s", "x_m", "speed_m_per_s", "pairs", "sideways"}),
          floor_(std::move(floor))
    {}

    void observe(const World& world, const Contacts& contacts, double) override
    {
        const Body& cube = body_named(world, "cube");
        const Vec3 middle = cube.centre();
        const double speed = cube.mean_velocity().x();
        const auto sideways = std::count_if(contacts.begin(), contacts.end(), [&](const Contact& contact) {
            return pushes_sideways(world, contact);
        });
        if (stopped_at_ < 0 && world.step > 0 && speed <= 0)
            stopped_at_ = world.time;
        farthest_ = std::max(farthest_, middle.x());
        last_speed_ = speed;
        table_.add({floor_, world.time, middle.x(), speed, static_cast<long>(contacts.size()),
                    static_cast<long>(sideways)});
    }

    /// first time the cube no longer moves forward [s], -1 never
    double stopped_at() const { return stopped_at_; }
    double farthest() const { return farthest_; }      ///< [m]
    double last_speed() const { return last_speed_; }  ///< [m/s]

private:
    std::string floor_;
    double stopped_at_ = -1, farthest_ = -1e9, last_speed_ = 0;
};

/// Triangles drawn, pairs in the thesis' colours, the sideways ones in orange.
void mark_sideways(Stage& stage, const World& world, const Contacts& contacts)
{
    for (Drawable& drawable : stage.bodies)
        drawable.wireframe = true;
    Contacts sideways, upwards;
    for (const Contact& contact : contacts)
        (pushes_sideways(world, contact) ? sideways : upwards).push_back(contact);
    mark_contacts(stage, world, upwards);
    mark_artefacts(stage, world, sideways);
}

/// The same scene with an analytic plane in the floor's place.
nlohmann::json plane_instead_of_floor(const std::filesystem::path& file)
{
    nlohmann::json moving = nlohmann::json::array();
    for (const nlohmann::json& body : bodies_of(file))
        if (body.value("type", "") != "static")
            moving.push_back(body);
    return {{"planes", {{{"name", "floor"}}}}, {"bodies", moving}};
}

}  // namespace

/// Thesis 6.1.2: the same cube on a plane and on triangles that form the same plane.
void hooked(const RunOptions& options, Report& report)
{
    const std::filesystem::path file = options.scene.value_or(scene_file("hooked"));
    Scene on_triangles = load_scene(file);
    SlideProbe triangles("triangles");
    StripProbe pictures(on_triangles, {0.1, 0.3, 0.35, 0.6}, mark_sideways);
    run(on_triangles, chapter03_solver(on_triangles.contact), {&triangles, &pictures});
    write_png(pictures.all(2), report.file("hooked.png"));

    Scene on_plane = load_scene(file, plane_instead_of_floor(file).dump());
    SlideProbe plane("plane");
    run(on_plane, chapter03_solver(on_plane.contact), {&plane});

    Table table({"floor", "time_s", "x_m", "speed_m_per_s", "pairs", "sideways"});
    table.append(plane.table());
    table.append(triangles.table());
    report.table("hooked", table);
    report.plot("chapters/03_penalty_impulses/plots/hooked.gp");
    report.fact("hooked", "stopped_at", triangles.stopped_at(), 3);
    report.fact("hooked", "farthest", triangles.farthest(), 3);
    report.fact("hooked", "plane_farthest", plane.farthest(), 3);
    report.fact("hooked", "plane_speed", plane.last_speed(), 3);
}

}  // namespace enduring::chapter03
