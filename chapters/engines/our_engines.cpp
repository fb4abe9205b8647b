#include "chapters/10_self_contact/solver.hpp"
#include "chapters/11_exact_contact/solver.hpp"
#include "chapters/engines/bullet/bullet_solver.hpp"
#include "chapters/engines/engine.hpp"

namespace enduring::engines {
namespace {

/// What steps our World: our solvers, and Bullet behind the bodies that stand for its own.
class SolverWorld final : public EngineWorld {
public:
    SolverWorld(Scene scene, const EngineScene& described, const std::function<Solver(Scene&)>& make)
        : scene_(std::move(scene)), described_(described), solver_(make(scene_))
    {}
    void step(double dt) override { advance(scene_.world, contacts_, solver_, dt); }
    Pose pose(std::size_t body) const override
    {
        return pose_of(described_.bodies[body], scene_.world.bodies[body]->positions_t0());
    }

private:
    Scene scene_;
    const EngineScene& described_;
    Contacts contacts_;
    Solver solver_;
};

using MakeOurs = Solver (*)(const ContactParameters&, ImplicitSettings);

/// Ours has no settings but the step.
Engine our_engine(const std::string& name, MakeOurs make)
{
    return {name, "", "", "", {"default"}, {"best", 2}, [make](Scene scene, const Way& way, int steps) {
                return run_solver(std::move(scene), way.substeps, steps, [&](Scene& taken) {
                    ImplicitSettings settings;
                    settings.record = [](const SolveRecord&) {};
                    settings.threads = 1;  // processor time is compared, and the others have one thread, too
                    return make(taken.contact, settings);
                });
            }};
}

}  // namespace

Trajectory run_solver(Scene scene, int substeps, int steps, const std::function<Solver(Scene&)>& make)
{
    const EngineScene described = describe(scene);
    SolverWorld world(std::move(scene), described, make);
    return follow(described, world, substeps, steps);
}

Engine chapter10_engine() { return our_engine("chapter 10", chapter10_solver); }
Engine chapter11_engine() { return our_engine("chapter 11", chapter11_solver); }

/// The manual: more iterations and smaller steps for stacks (10 and 1/60 s are its defaults).
Engine bullet_engine()
{
    return {"Bullet",
            bullet_version(),
            "",
            "https://github.com/bulletphysics/bullet3/blob/master/docs/Bullet_User_Manual.pdf",
            {"default"},
            {"best", 4, 100},
            [](Scene scene, const Way& way, int steps) {
                return run_solver(std::move(scene), way.substeps, steps, [&](Scene& taken) {
                    return way.iterations > 0 ? iterated_bullet_solver(taken, way.iterations)
                                              : bullet_solver(taken);
                });
            }};
}

}  // namespace enduring::engines
