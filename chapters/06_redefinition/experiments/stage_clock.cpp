#include "chapters/06_redefinition/experiments/stage_clock.hpp"

#include "chapters/01_particle_plane/normal_response.hpp"
#include "chapters/03_penalty_impulses/penalty_law.hpp"
#include "chapters/04_friction/friction_contact.hpp"
#include "chapters/05_categorisation/category.hpp"
#include "chapters/06_redefinition/edge_edge_dismissal.hpp"
#include "chapters/06_redefinition/redefinition_passes.hpp"
#include "chapters/06_redefinition/resolution.hpp"
#include "chapters/06_redefinition/solver.hpp"
#include "chapters/06_redefinition/vertex_face_redefinition.hpp"
#include "common/experiments/run/processor_clock.hpp"

#include <algorithm>
#include <iterator>

namespace enduring::chapter06 {
namespace {

constexpr int rounds = 3;  ///< of each pass; the quickest counts, for others on the machine can only slow it down

/// The quickest of several rounds of one pass over a list, each from a fresh copy [s].
template <class Pass>
double quickest(const Contacts& contacts, const Pass& pass)
{
    if (contacts.empty())
        return 0;  // nothing but the clock would be measured
    double best = 1e300;
    for (int round = 0; round < rounds; ++round) {
        Contacts copy = contacts;
        const double begin = processor_seconds();
        pass(copy);
        best = std::min(best, processor_seconds() - begin);
    }
    return best;
}

Contacts only(const Contacts& contacts, ContactKind kind)
{
    Contacts some;
    std::copy_if(contacts.begin(), contacts.end(), std::back_inserter(some),
                 [&](const Contact& contact) { return contact.kind == kind && !contact.held(); });
    return some;
}

/// Seconds, summed over the steps, until the end makes nanoseconds a pair of them.
class StageClock {
public:
    explicit StageClock(ContactKind kind) : kind_(kind) {}

    /// Pairs that endure, from the step's first prediction.
    void at_the_start(const World& world, const Contacts& contacts)
    {
        const Contacts pairs = only(contacts, kind_);
        enduring_ += static_cast<long>(pairs.size());
        Redefinitions unused;
        const double labels = quickest(pairs, [&](Contacts& list) { label_contacts(world, list); });
        const double follows = quickest(pairs, [&](Contacts& list) {
            if (kind_ == ContactKind::vertex_face)
                redefine_enduring_vertices(world, list, unused);
            else
                dismiss_enduring_edges(world, list);
        });
        times_.categorise += labels;
        times_.redefine += std::max(0.0, follows - labels);
    }

    /// Pairs that wait for their impulses.
    void before_the_response(const World& world, const Contacts& contacts, const ContactParameters& parameters, double dt)
    {
        Contacts pairs = only(contacts, kind_);
        pairs.erase(std::remove_if(pairs.begin(), pairs.end(), [](const Contact& contact) { return !contact.waiting(); }), pairs.end());
        answered_ += static_cast<long>(pairs.size());
        const auto push = [&](const NormalLaw& law) {
            return quickest(pairs, [&](Contacts& list) { push_apart(world, list, law, parameters.stiffness, dt); });
        };
        times_.dpf += push(discrete_penalty);
        times_.cpf += push(continuous_penalty);
        push_apart(world, pairs, continuous_penalty, parameters.stiffness, dt);
        times_.friction += quickest(pairs, [&](Contacts& list) { compute_friction_impulses(world, list, parameters.friction, dt); });
    }

    /// All pairs, before the step is committed: vertex pairs decide about edge pairs.
    void at_the_end(const World& world, const CrossingDetection& detection, const Contacts& contacts)
    {
        resolved_ += std::count_if(contacts.begin(), contacts.end(), [&](const Contact& contact) { return contact.kind == kind_; });
        Redefinitions unused;
        times_.resolve += quickest(contacts, [&](Contacts& list) {
            if (kind_ == ContactKind::vertex_face)
                resolve_vertices_that_left(world, detection, list, unused);
            else
                resolve_edges_that_left(world, detection, list);
        });
    }

    StageTimes per_pair() const
    {
        const double enduring = 1e9 / static_cast<double>(std::max(enduring_, 1L));
        const double answered = 1e9 / static_cast<double>(std::max(answered_, 1L));
        const double resolved = 1e9 / static_cast<double>(std::max(resolved_, 1L));
        return {times_.resolve * resolved,   times_.categorise * enduring, times_.redefine * enduring,
                times_.cpf * answered,       times_.dpf * answered,        times_.friction * answered};
    }
    long pairs() const { return enduring_; }

private:
    ContactKind kind_;
    StageTimes times_;
    long enduring_ = 0, answered_ = 0, resolved_ = 0;
};

}  // namespace

PairTimes time_stages(Scene& scene, int steps, int from)
{
    StageClock vertex_face(ContactKind::vertex_face), edge_edge(ContactKind::edge_edge);
    const auto both = [&](const auto& work) {
        if (scene.world.step < from)
            return;
        work(vertex_face);
        work(edge_edge);
    };
    CrossingDetection detection;
    Solver solver = chapter06_solver(scene.contact);
    solver.refresh.insert(solver.refresh.begin(), {"clock", [&](World& world, Contacts& contacts, double) {
        both([&](StageClock& clock) { clock.at_the_start(world, contacts); });
    }});
    solver.respond.insert(solver.respond.begin(), {"clock", [&](World& world, Contacts& contacts, double dt) {
        both([&](StageClock& clock) { clock.before_the_response(world, contacts, scene.contact, dt); });
    }});
    solver.finish.insert(solver.finish.begin(), {"clock", [&](World& world, Contacts& contacts, double) {
        detection.find_candidates(world);
        both([&](StageClock& clock) { clock.at_the_end(world, detection, contacts); });
    }});
    RunLimits limits;
    limits.steps = steps;
    run(scene, solver, {}, limits);
    return {vertex_face.per_pair(), edge_edge.per_pair(), static_cast<double>(vertex_face.pairs() + edge_edge.pairs()) / (steps - from)};
}

}  // namespace enduring::chapter06
