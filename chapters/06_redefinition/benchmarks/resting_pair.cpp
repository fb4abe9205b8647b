// What one resting pair costs in each stage and altogether: passes over the pairs
// under a cube that rests on a triangulated floor, of one kind or of both, divided by
// their number. The column that counts is "per_pair" [s].
//
// Mass-splitting friction solves all pairs together. With half of them taken away the cube no longer rests,
// and it takes more rounds: "both" is the number to read there.

#include "chapters/01_particle_plane/plane_contact.hpp"
#include "chapters/03_penalty_impulses/penalty_law.hpp"
#include "chapters/04_friction/friction_contact.hpp"
#include "chapters/05_categorisation/category.hpp"
#include "chapters/06_redefinition/edge_pairs.hpp"
#include "chapters/06_redefinition/resolution.hpp"
#include "chapters/06_redefinition/solver.hpp"
#include "chapters/06_redefinition/vertex_face_redefinition.hpp"
#include "common/experiments/run/run.hpp"

#include <benchmark/benchmark.h>

#include <optional>

namespace {

using namespace enduring;

/// The cube at rest, held by friction, and its next step predicted.
struct Resting {
    Resting(std::optional<ContactKind> only, const std::string& model)
        : kind(only),
          scene(load_scene(scene_file("hooked"),
                           R"({"/bodies/cube/velocity": [0, 0, 0], "contact": {"friction": {"model": ")" +
                               model + R"(", "mu_s": 0.5, "mu_d": 0.4}}})"))
    {
        RunLimits limits;
        limits.steps = 300;
        all = run(scene, chapter06_solver(scene.contact), {}, limits).contacts;
        for (Contact& contact : all) {
            if (contact.answered())
                contact.state = ContactState::waiting;
            contact.start = 0;
            if (contact.kind == kind.value_or(contact.kind) && !contact.held())
                pairs.push_back(contact);
        }
        for (const auto& body : scene.world.bodies)
            body->predict(scene.world.gravity, scene.dt);
        search.find_candidates(scene.world);
    }

    bool has(ContactKind one) const { return kind.value_or(one) == one; }

    std::optional<ContactKind> kind;
    Scene scene;
    Contacts all;    ///< of both kinds: whether an edge pair is resolved is decided by the vertex pairs
    Contacts pairs;  ///< those asked for, if they push
    CandidateSearch search;
    Redefinitions redefinitions;
};

using Stage = void (*)(Resting&);

void resolve(Resting& at)
{
    if (at.has(ContactKind::vertex_face))
        resolve_vertices_that_left(at.scene.world, at.search, at.all, at.redefinitions);
    if (at.has(ContactKind::edge_edge))
        resolve_edges_that_left(at.scene.world, at.search, at.all);
}

void categorise_only(Resting& at) { label_contacts(at.scene.world, at.pairs); }

/// Categorises on its way.
void follow(Resting& at)
{
    if (at.has(ContactKind::vertex_face))
        redefine_enduring_vertices(at.scene.world, at.pairs, at.redefinitions);
    if (at.has(ContactKind::edge_edge))
        dismiss_enduring_edges(at.scene.world, at.pairs);
}

void push(Resting& at, const NormalLaw& law)
{
    push_apart(at.scene.world, at.pairs, law, at.scene.contact.stiffness, at.scene.dt);
}
void push_continuous(Resting& at) { push(at, continuous_penalty); }
void push_discrete(Resting& at) { push(at, discrete_penalty); }

void friction(Resting& at)
{
    compute_friction_impulses(at.scene.world, at.pairs, at.scene.contact.friction, at.scene.dt);
}

template <Stage impulse>
void altogether(Resting& at)
{
    follow(at);
    impulse(at);
    friction(at);
    resolve(at);
}

void run_stage(benchmark::State& state, std::optional<ContactKind> kind, Stage stage,
               const std::string& model = "mass_splitting")
{
    Resting at(kind, model);
    push_continuous(at);  // friction needs a normal impulse
    for (auto _ : state) {
        stage(at);
        benchmark::ClobberMemory();
    }
    state.counters["pairs"] = static_cast<double>(at.pairs.size());
    state.counters["per_pair"] = benchmark::Counter(
        static_cast<double>(at.pairs.size()),
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

constexpr ContactKind VF = ContactKind::vertex_face, EE = ContactKind::edge_edge;
const std::string thesis = "yamane_nakamura";

#define EACH_KIND(name, ...)                                  \
    BENCHMARK_CAPTURE(run_stage, name##_VF, VF, __VA_ARGS__); \
    BENCHMARK_CAPTURE(run_stage, name##_EE, EE, __VA_ARGS__); \
    BENCHMARK_CAPTURE(run_stage, name##_both, std::nullopt, __VA_ARGS__)

EACH_KIND(resolve, resolve);
EACH_KIND(categorise, categorise_only);
EACH_KIND(follow, follow);
EACH_KIND(impulse_cpf, push_continuous);
EACH_KIND(impulse_dpf, push_discrete);
EACH_KIND(friction_thesis, friction, thesis);
EACH_KIND(friction_mass_splitting, friction);
EACH_KIND(altogether_cpf_thesis, altogether<push_continuous>, thesis);
EACH_KIND(altogether_dpf_thesis, altogether<push_discrete>, thesis);
EACH_KIND(altogether_cpf_mass_splitting, altogether<push_continuous>);
EACH_KIND(altogether_dpf_mass_splitting, altogether<push_discrete>);

}  // namespace
