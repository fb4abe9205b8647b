#include "chapters/06_redefinition/experiments/stage_clock.hpp"

#include "chapters/03_penalty_impulses/solver.hpp"
#include "chapters/05_categorisation/category.hpp"
#include "chapters/06_redefinition/solver.hpp"
#include "common/experiments/run/processor_clock.hpp"

#include <algorithm>
#include <iterator>

namespace enduring::chapter06 {
namespace {

/// of each pass; the quickest counts, for others on the machine can only slow it down
constexpr int rounds = 3;

/// The quickest of several rounds of some work over a list, each from a fresh copy [s].
template <class Work>
double quickest(const Contacts& contacts, const Work& work)
{
    if (contacts.empty())
        return 0;  // nothing but the clock would be measured
    double best = 1e300;
    for (int round = 0; round < rounds; ++round) {
        Contacts copy = contacts;
        const double begin = processor_seconds();
        work(copy);
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

/// The passes of a step, one by one.
struct StagePasses {
    Solver layer, discrete, continuous;

    explicit StagePasses(const ContactParameters& parameters)
        : layer(chapter06_solver(parameters)),
          discrete(chapter03_solver({PenaltyMethod::discrete, parameters.stiffness})),
          continuous(chapter03_solver({PenaltyMethod::continuous, parameters.stiffness}))
    {}
};

/// Seconds, summed over the steps, until the end makes nanoseconds a pair of them.
class StageClock {
public:
    StageClock(ContactKind kind, const StagePasses& passes) : kind_(kind), passes_(passes) {}

    /// Pairs that endure, from the step's first prediction.
    void at_the_start(World& world, const Contacts& contacts, double dt)
    {
        const Contacts pairs = only(contacts, kind_);
        enduring_ += static_cast<long>(pairs.size());
        const double labels = quickest(pairs, [&](Contacts& list) { label_contacts(world, list); });
        const Pass& follow = passes_.layer.pass(kind_ == ContactKind::vertex_face ? "redefine vertices"
                                                                                  : "dismiss edges");
        const double follows = quickest(pairs, [&](Contacts& list) { follow.run(world, list, dt); });
        times_.categorise += labels;
        times_.redefine += std::max(0.0, follows - labels);
    }

    /// Pairs that wait for their impulses.
    void before_the_response(World& world, const Contacts& contacts, double dt)
    {
        Contacts pairs = only(contacts, kind_);
        std::erase_if(pairs, [](const Contact& contact) { return !contact.waiting(); });
        answered_ += static_cast<long>(pairs.size());
        const Pass &dpf = passes_.discrete.pass("impulses"), &cpf = passes_.continuous.pass("impulses"),
                   &friction = passes_.layer.pass("friction");
        times_.dpf += quickest(pairs, [&](Contacts& list) { dpf.run(world, list, dt); });
        times_.cpf += quickest(pairs, [&](Contacts& list) { cpf.run(world, list, dt); });
        cpf.run(world, pairs, dt);
        times_.friction += quickest(pairs, [&](Contacts& list) { friction.run(world, list, dt); });
    }

    /// All pairs, before the step is committed: vertex pairs decide about edge pairs.
    void at_the_end(World& world, const Contacts& contacts, double dt)
    {
        resolved_ += std::count_if(contacts.begin(), contacts.end(),
                                   [&](const Contact& contact) { return contact.kind == kind_; });
        const Pass& resolve = passes_.layer.pass(kind_ == ContactKind::vertex_face ? "resolve vertices"
                                                                                   : "resolve edges");
        times_.resolve += quickest(contacts, [&](Contacts& list) { resolve.run(world, list, dt); });
    }

    StageTimes per_pair() const
    {
        const double enduring = 1e9 / static_cast<double>(std::max(enduring_, 1L));
        const double answered = 1e9 / static_cast<double>(std::max(answered_, 1L));
        const double resolved = 1e9 / static_cast<double>(std::max(resolved_, 1L));
        return {times_.resolve * resolved, times_.categorise * enduring, times_.redefine * enduring,
                times_.cpf * answered,     times_.dpf * answered,        times_.friction * answered};
    }
    long pairs() const { return enduring_; }

private:
    ContactKind kind_;
    const StagePasses& passes_;
    StageTimes times_;
    long enduring_ = 0, answered_ = 0, resolved_ = 0;
};

}  // namespace

PairTimes time_stages(Scene& scene, int steps, int from)
{
    const StagePasses passes(scene.contact);
    StageClock vertex_face(ContactKind::vertex_face, passes), edge_edge(ContactKind::edge_edge, passes);
    const auto both = [&](World& world, const auto& work) {
        if (world.step < from)
            return;
        work(vertex_face);
        work(edge_edge);
    };
    Solver solver = passes.layer;
    solver.insert_before("resolve planes", "clock what endures",
                         [&](World& world, Contacts& contacts, double dt) {
                             both(world, [&](StageClock& clock) { clock.at_the_start(world, contacts, dt); });
                         });
    solver.insert_before("impulses", "clock the response", [&](World& world, Contacts& contacts, double dt) {
        both(world, [&](StageClock& clock) { clock.before_the_response(world, contacts, dt); });
    });
    solver.insert_before("resolve vertices", "clock the resolution",
                         [&](World& world, Contacts& contacts, double dt) {
                             both(world, [&](StageClock& clock) { clock.at_the_end(world, contacts, dt); });
                         });
    RunLimits limits;
    limits.steps = steps;
    run(scene, solver, {}, limits);
    return {vertex_face.per_pair(), edge_edge.per_pair(),
            static_cast<double>(vertex_face.pairs() + edge_edge.pairs()) / (steps - from)};
}

}  // namespace enduring::chapter06
