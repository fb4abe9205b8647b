#include "chapters/01_particle_plane/amplification.hpp"
#include "chapters/01_particle_plane/experiments/experiments.hpp"
#include "chapters/01_particle_plane/plane_contact.hpp"
#include "chapters/01_particle_plane/solver.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/run/run.hpp"

#include <algorithm>

namespace enduring::chapter01 {
namespace {

/// What the ground does to one body in one step.
struct Touch {
    int vertices = 0;  ///< that were pushed
    double force = 0;  ///< sum of the impulses over dt [N]
    double depth = 0;  ///< mean over those vertices at the step's end, positive inside [m]
};

Touch touch_of(const World& world, const Contacts& contacts, int body, double dt)
{
    Touch touch;
    for (const Contact& contact : contacts)
        if (contact.body_a == body && contact.impulse.norm() > 0) {
            const Plane& plane = world.planes[contact.body_b];
            const Vec3& point = world.bodies[body]->positions_t0()[contact.feature_a];
            touch.vertices += 1;
            touch.force += plane.normal.dot(contact.impulse) / dt;
            touch.depth -= plane.normal.dot(point - plane.point);
        }
    touch.depth /= std::max(touch.vertices, 1);
    return touch;
}

/// method, time_s, body, vertices, force_n, depth_m: a row for each body and step.
class GroundProbe final : public TableProbe {
public:
    explicit GroundProbe(std::string method)
        : TableProbe({"method", "time_s", "body", "vertices", "force_n", "depth_m"}),
          method_(std::move(method))
    {}
    void observe(const World& world, const Contacts& contacts, double dt) override
    {
        last_.clear();
        for (std::size_t body = 0; body < world.bodies.size(); ++body) {
            last_.push_back(touch_of(world, contacts, static_cast<int>(body), dt));
            const Touch& touch = last_.back();
            table_.add({method_, world.time, world.bodies[body]->name(), static_cast<long>(touch.vertices),
                        touch.force, touch.depth});
        }
    }
    const Touch& last(std::size_t body) const { return last_[body]; }

private:
    std::string method_;
    std::vector<Touch> last_;
};

/// Mean predicted fall [m] of the vertices that are about to be pushed, for each body: what gravity and the
/// body's own springs would do in this step if there were no ground.
std::vector<double> predicted_falls(const World& world, const Contacts& contacts, double dt)
{
    std::vector<double> sum(world.bodies.size(), 0.0), count(world.bodies.size(), 0.0);
    for (const Contact& contact : contacts) {
        const auto body = static_cast<std::size_t>(contact.body_a);
        const Vec3& normal = world.planes[contact.body_b].normal;
        sum[body] -= dt * normal.dot(world.bodies[body]->velocity(contact.feature_a));
        count[body] += 1;
    }
    for (std::size_t body = 0; body < sum.size(); ++body)
        sum[body] /= std::max(count[body], 1.0);
    return sum;
}

//! [watching_solver]
/// The chapter's solver with one pass more, which notes the predicted falls just before the push.
Solver watching_solver(const ContactParameters& parameters, std::vector<double>& falls)
{
    Solver solver = chapter01_solver(parameters);
    const auto note = [&falls](World& world, Contacts& contacts, double dt) {
        falls = predicted_falls(world, contacts, dt);
    };
    solver.insert_before("push out of planes", "note the predicted falls", note);
    return solver;
}
//! [watching_solver]

void add_rest(Table& rest, const Scene& scene, const GroundProbe& probe, const std::vector<double>& falls)
{
    const double g = scene.world.gravity.norm();
    for (std::size_t body = 0; body < scene.world.bodies.size(); ++body) {
        const Body& b = *scene.world.bodies[body];
        const Touch& touch = probe.last(body);
        const double nk = std::max(touch.vertices, 1) * scene.contact.stiffness,
                     static_depth = b.mass() * g / nk;
        rest.add({b.name(), short_name(scene.contact.method), static_cast<long>(touch.vertices), b.mass() * g,
                  touch.force, 1000 * static_depth, 1000 * falls[body],
                  1000 * (static_depth - look_ahead(scene.contact.method) * falls[body]),
                  1000 * touch.depth});
    }
}

}  // namespace

/// The chapter's solver on bodies: each vertex below the plane is a
/// particle with that vertex's share of the body.
void ground(const RunOptions& options, Report& report)
{
    Table forces({"method", "time_s", "body", "vertices", "force_n", "depth_m"});
    Table rest({"body", "method", "vertices", "weight_n", "force_n", "mg_over_nk_mm", "fall_mm",
                "predicted_mm", "depth_mm"});
    for (const std::string method : {"cpf", "dpf"}) {
        Scene scene = load_scene(options.scene.value_or(scene_file("ground")),
                                 R"({"contact": {"method": ")" + method + R"("}})");
        GroundProbe touches(short_name(scene.contact.method));
        StripProbe moments(scene, {0.0, 0.2, 0.6, scene.duration});
        std::vector<Probe*> probes{&touches};
        if (method == "cpf")
            probes.push_back(&moments);
        std::vector<double> falls(scene.world.bodies.size(), 0.0);
        run(scene, watching_solver(scene.contact, falls), probes);
        forces.append(touches.table());
        add_rest(rest, scene, touches, falls);
        if (method == "cpf")
            write_png(moments.all(2), report.file("ground.png"));
    }
    report.table("ground", forces);
    report.table("ground_rest", rest);
    report.page_table("ground_rest", rest, 4);
    report.plot("chapters/01_particle_plane/plots/ground.gp", "ground_force");
}

}  // namespace enduring::chapter01
