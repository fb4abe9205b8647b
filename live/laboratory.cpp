#include "live/laboratory.hpp"

#include "chapters/13_other_solvers/solver.hpp"
#include "chapters/solvers/chapter_solver.hpp"
#include "common/scenes/drawn_body.hpp"
#include "common/scenes/scene_reader.hpp"

#include <charconv>
#include <utility>

namespace enduring::laboratory {
namespace {

/// Settings that say nothing of a step that is not solved: the page shows it.
ImplicitSettings silent()
{
    ImplicitSettings settings;
    settings.record = [](const SolveRecord&) {};
    return settings;
}

std::tuple<ContactKind, int, int, int, int> features_of(const Contact& contact)
{
    return {contact.kind, contact.body_a, contact.feature_a, contact.body_b, contact.feature_b};
}

/// The solver of a chapter by its number, or a method of chapter 13 by its name.
Solver solver_named(const std::string& name, const ContactParameters& contact)
{
    int chapter = 0;
    const char* const end = name.data() + name.size();
    const auto [at, error] = std::from_chars(name.data(), end, chapter);
    return error == std::errc() && at == end ? solvers::chapter_solver(chapter, contact, silent())
                                             : chapter13_solver(name, contact);
}

}  // namespace

Laboratory::Laboratory(const std::string& text, const std::string& file,
                       const std::vector<std::filesystem::path>& meshes, const std::string& solver)
    : scene_(read_scene(text, "", file, {meshes})), solver_(solver_named(solver, scene_.contact))
{
    require_asked(scene_, solver_);
    const auto pulled = [this](World& world, Contacts&, double dt) { pull(world, dt); };
    const std::vector<Pass>& refresh = solver_.passes(StepStage::refresh);
    if (refresh.empty())
        solver_.append(StepStage::refresh, "hand", pulled);
    else
        solver_.insert_before(std::string(refresh.front().name), "hand", pulled);
}

/// The damped spring's impulse at the end of the step, so that no step is too long for it.
void Laboratory::pull(World& world, double dt) const
{
    if (hand_.body < 0)
        return;
    Body& body = *world.bodies[static_cast<std::size_t>(hand_.body)];
    const std::vector<int> corners = vertices_of_drawn_face(body, hand_.face);
    const auto count = static_cast<double>(corners.size());
    Vec3 place = Vec3::Zero(), velocity = Vec3::Zero();
    for (const int vertex : corners) {
        place += body.position(vertex, 0) / count;
        velocity += body.velocity(vertex) / count;
    }
    const double k = Hand::stiffness * body.mass(), c = Hand::damping * body.mass();
    const Vec3 force = (k * (hand_.target - place - dt * velocity) - c * velocity) /
                       (1 + dt * Hand::damping + dt * dt * Hand::stiffness);
    for (const int vertex : corners)
        push_from_outside(world, static_cast<std::size_t>(hand_.body), vertex, dt / count * force);
    body.update_prediction(dt);
}

void Laboratory::step()
{
    advance(scene_.world, contacts_, solver_, scene_.dt);
    note_pairs();
}

void Laboratory::note_pairs()
{
    std::map<PairKey, int> since;
    for (const Contact& contact : contacts_) {
        const auto known = since_.find(features_of(contact));
        since[features_of(contact)] = known == since_.end() ? scene_.world.step : known->second;
    }
    since_ = std::move(since);
}

std::vector<PairNumbers> Laboratory::pairs() const
{
    std::vector<PairNumbers> pairs;
    pairs.reserve(contacts_.size());
    for (const Contact& contact : contacts_) {
        const auto met = since_.find(features_of(contact));
        pairs.push_back(
            pair_numbers(scene_.world, contact, met == since_.end() ? scene_.world.step : met->second));
    }
    return pairs;
}

}  // namespace enduring::laboratory
