#include "chapters/03_penalty_impulses/crossing_detection.hpp"
#include "chapters/05_categorisation/category.hpp"
#include "chapters/06_redefinition/experiments/experiments.hpp"
#include "chapters/06_redefinition/face_choice.hpp"
#include "chapters/06_redefinition/solver.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/run/run.hpp"

#include <algorithm>
#include <stdexcept>

namespace enduring::chapter06 {
namespace {

/// A redefinition caught in the act: all that algorithm 6.1 looked at,
/// from its own functions, and the surfaces it saw.
struct Caught {
    std::string title;
    Stage stage;  ///< without marks
    Vec3 vertex;
    std::array<Vec3, 3> present;             ///< the face that the pair had
    std::vector<FaceTrial> trials;           ///< each candidate once
    std::vector<std::array<Vec3, 3>> faces;  ///< of the trials
    std::vector<Vec3> feet;
    std::optional<FaceTrial> choice;
};

std::array<Vec3, 3> corners_of(const SurfaceMoment& surface, int face)
{
    const auto [f0, f1, f2] = surface.step.face(face);
    return {surface.position(f0), surface.position(f1), surface.position(f2)};
}

Vec3 foot_point(const std::array<Vec3, 3>& corners, const TriangleFoot& foot)
{
    return foot.weights[0] * corners[0] + foot.weights[1] * corners[1] + foot.weights[2] * corners[2];
}

/// The stage as algorithm 6.1 sees it at tau, the bodies see-through.
Stage stage_at(const World& world, const Scene& scene, double tau)
{
    Stage stage = stage_of(world, scene);
    for (std::size_t body = 0; body < world.bodies.size(); ++body) {
        const SurfaceMoment surface = surface_at(*world.bodies[body], tau);
        for (std::size_t vertex = 0; vertex < stage.bodies[body].positions.size(); ++vertex)
            stage.bodies[body].positions[vertex] = surface.position(static_cast<int>(vertex));
        stage.bodies[body].wireframe = true;
    }
    return stage;
}

//! [catch]
Caught catch_redefinition(const World& world, const Scene& scene, const Contact& contact, double tau,
                          const Corners& around, double tolerance)
{
    const PairSurfaces surfaces(world, contact, tau);
    Caught caught{"",
                  stage_at(world, scene, tau),
                  surfaces.a.position(contact.feature_a),
                  corners_of(surfaces.b, contact.feature_b),
                  {},
                  {},
                  {},
                  find_face(world, contact, tau, around, {tolerance})};
    visit_candidates(surfaces, contact, around, [&](int face) {
        if (std::any_of(caught.trials.begin(), caught.trials.end(),
                        [&](const FaceTrial& trial) { return trial.face == face; }))
            return;
        caught.trials.push_back(try_face(surfaces, contact.feature_a, face, {tolerance}));
        caught.faces.push_back(corners_of(surfaces.b, face));
        caught.feet.push_back(foot_point(caught.faces.back(), caught.trials.back().foot));
    });
    return caught;
}
//! [catch]

/// Thesis figure 6.10: the first pair whose foot has left its face.
std::optional<Caught> barycentric_case(const World& world, const Scene& scene, const Contacts& contacts)
{
    for (const Contact& contact : contacts) {
        if (contact.kind != ContactKind::vertex_face || contact.held())
            continue;
        const PairSurfaces surfaces(world, contact, 0);
        const auto foot = foot_on_face(surfaces.a, contact.feature_a, surfaces.b, contact.feature_b);
        if (foot && overshoot(foot->weights) > 0 &&
            find_face(world, contact, 0, corners_towards(*foot), {overshoot(foot->weights)}))
            return catch_redefinition(world, scene, contact, 0, corners_towards(*foot),
                                      overshoot(foot->weights));
    }
    return std::nullopt;
}

/// Not at a corner, where little could be seen.
bool in_the_middle(const Contact& contact)
{
    return std::all_of(contact.weights.begin() + 1, contact.weights.end(),
                       [](double weight) { return std::abs(weight) < 0.75; });
}

/// Thesis figures 6.12 and 6.13: the first hooked pair that a detection brings.
std::optional<Caught> hooked_case(const World& world, const Scene& scene, const Contacts& contacts,
                                  CrossingDetection& detection)
{
    Contacts fresh = contacts;
    detection.find_candidates(world);
    detection.append_entries(world, fresh);
    for (std::size_t i = contacts.size(); i < fresh.size(); ++i) {
        const bool hooked = fresh[i].kind == ContactKind::vertex_face &&
                            categorise(world, fresh[i], fresh[i].start) == ContactCategory::hooked;
        if (hooked && in_the_middle(fresh[i]) && find_face(world, fresh[i], 1, all_corners, {}))
            return catch_redefinition(world, scene, fresh[i], 1, all_corners, 0);
    }
    return std::nullopt;
}

/// Runs a scene under the chapter's solver with a spy in front of its passes.
/// @throws std::runtime_error  nothing was caught
Caught run_until_caught(const std::string& name, bool hooked)
{
    const std::string aside = R"({"/bodies/cube/position": [0, 0.255, 0.1]})";  // so that a vertex meets its
                                                                                // front away from the corners
    Scene scene = load_scene(scene_file(name), hooked ? aside : "");
    Solver solver = chapter06_solver(scene.contact);
    std::optional<Caught> caught;
    const auto detection = std::make_shared<CrossingDetection>();
    const Pass spy{"spy", [&](World& world, Contacts& contacts, double) {
                       if (!caught)
                           caught = hooked ? hooked_case(world, scene, contacts, *detection)
                                           : barycentric_case(world, scene, contacts);
                   }};
    solver.insert_before(hooked ? "detect planes" : "resolve planes", spy);
    run(scene, solver, {}, {std::nullopt, [&](const World&, const Contacts&) { return caught.has_value(); }});
    if (!caught)
        throw std::runtime_error("step_by_step: scene " + name + " has no such redefinition");
    caught->title = hooked ? "hooked" : "barycentric";
    return *caught;
}

/// What the four steps have left of a candidate.
bool still_in(const FaceTrial& trial, int step, const std::optional<FaceTrial>& choice)
{
    switch (step) {
        case 1: return true;
        case 2: return trial.verdict == FaceVerdict::hooked || trial.verdict == FaceVerdict::fit;
        case 3: return trial.verdict == FaceVerdict::fit;
        default: return choice && trial.face == choice->face;
    }
}

void add_outline(Stage& stage, const std::array<Vec3, 3>& corners)
{
    for (std::size_t i = 0; i < 3; ++i)
        stage.segments.push_back({corners[i], corners[(i + 1) % 3], palette::ivory, 1.5});
}

//! [draw]
Stage draw_step(const Caught& caught, int step)
{
    Stage stage = caught.stage;
    if (step < 4)
        stage.triangles.push_back({caught.present, palette::artefact});
    for (std::size_t i = 0; i < caught.trials.size(); ++i) {
        const bool in = still_in(caught.trials[i], step, caught.choice);
        if (in) {
            stage.triangles.push_back(
                {caught.faces[i], step == 4 ? palette::colliding_edge : palette::colliding_face});
            add_outline(stage, caught.faces[i]);
        }
        if (step == 2 || (in && step > 2)) {
            stage.segments.push_back(
                {caught.vertex, caught.feet[i], in ? palette::ink : palette::slate, 2, false, true});
            stage.dots.push_back({caught.feet[i], in ? palette::ink : palette::slate, 4});
        }
    }
    stage.dots.push_back({caught.vertex, palette::colliding_vertex, 6});
    return stage;
}
//! [draw]

std::string words(FaceVerdict verdict)
{
    switch (verdict) {
        case FaceVerdict::above: return "not below it";
        case FaceVerdict::deep: return "on the far side";
        case FaceVerdict::beside: return "foot outside";
        case FaceVerdict::hooked: return "hooked";
        default: return "regular";
    }
}

void add_rows(Table& table, const Caught& caught)
{
    for (const FaceTrial& trial : caught.trials) {
        const bool chosen = caught.choice && trial.face == caught.choice->face;
        table.add({caught.title, static_cast<long>(trial.face), 1000 * trial.foot.depth, trial.overshoot,
                   words(trial.verdict) + (chosen ? ", chosen" : "")});
    }
}

constexpr std::array<const char*, 4> captions{"1: the faces around are candidates",
                                              "2: those with the foot outside go", "3: hooked ones go",
                                              "4: the one left, or the least deep"};

/// Nearer than the scene's camera, from the same side.
void look_at(Stage& stage, const Vec3& target, double distance, double raise)
{
    Vec3 towards = (stage.camera.eye - stage.camera.target).normalized();
    towards.y() += raise;
    stage.camera.target = target;
    stage.camera.eye = target + distance * towards.normalized();
}

}  // namespace

/// Thesis figures 6.10 to 6.13 from what the solver's own functions say.
void step_by_step(const RunOptions&, Report& report)
{
    Table table({"case", "face", "depth_mm", "overshoot", "verdict"});
    Renderer renderer(480, 340);
    for (const bool hooked : {false, true}) {
        Caught caught = run_until_caught(hooked ? "hooked" : "shifted", hooked);
        for (Drawable& drawable : caught.stage.bodies)
            drawable.opacity = 0.45;
        look_at(caught.stage, caught.vertex + Vec3(0, hooked ? 0.1 : 0.03, 0), hooked ? 1.9 : 1.1,
                hooked ? 0.0 : 0.35);
        std::vector<StripPicture> pictures;
        for (int step = 1; step <= 4; ++step)
            pictures.push_back({renderer.draw(draw_step(caught, step)), captions[step - 1]});
        write_png(strip(pictures, 2), report.file("step_by_step_" + caught.title + ".png"));
        add_rows(table, caught);
    }
    report.table("step_by_step", table);
    report.page_table("step_by_step", table);
}

}  // namespace enduring::chapter06
