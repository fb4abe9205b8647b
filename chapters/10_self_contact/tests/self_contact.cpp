#include "chapters/09_deep_contacts/solver.hpp"
#include "chapters/10_self_contact/experiments/bent_bars.hpp"
#include "chapters/10_self_contact/experiments/folding_scenes.hpp"
#include "chapters/10_self_contact/experiments/pulled_knot.hpp"
#include "chapters/10_self_contact/experiments/self_crossings.hpp"
#include "chapters/10_self_contact/self_search.hpp"
#include "chapters/10_self_contact/solver.hpp"
#include "common/geometry/quadratic.hpp"
#include "common/scenes/scene_warnings.hpp"
#include "common/simulation/deformable_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <random>
#include <set>

using namespace enduring;

namespace {

constexpr double leg = 0.15, bend = 0.03;

/// Two legs upwards, 6 cm from middle to middle.
chapter10::CurvePoint fork_curve(double s)
{
    const double angle = std::clamp((s - leg) / bend, 0.0, std::numbers::pi);
    const Vec3 along(std::sin(angle), -std::cos(angle), 0), left(std::cos(angle), std::sin(angle), 0);
    const double past = s - leg - angle * bend;  // on a leg: negative on the first, positive on the second
    return {past * along - bend * left, left};
}

TetrahedralMesh fork_mesh(int fineness)
{
    return chapter10::bent_bar(2 * leg + std::numbers::pi * bend, 0.02, 0.02,
                               {20 * fineness, fineness, fineness}, fork_curve);
}

std::unique_ptr<DeformableBody> soft_fork(int fineness, double young, bool self_contact)
{
    DeformableSettings settings;
    settings.material = {.young = young, .density = 1000, .stiffness_damping = 0.001};
    settings.impulse_response = ImpulseResponse::implicit;
    settings.self_contact = self_contact;
    return std::make_unique<DeformableBody>("fork", with_edge_midpoints(fork_mesh(fineness)), settings);
}

}  // namespace

TEST_CASE("self-detection: of all pairs of features whose boxes overlap each comes once, but for neighbours")
{
    const auto body = soft_fork(1, 1e5, true);
    const RestNeighbours& neighbours = *rest_neighbours(*body);
    const SurfaceTopology& surface = body->surface();
    std::mt19937 random(8);
    std::uniform_real_distribution<double> displacement(-0.03, 0.03);
    std::vector<Vec3> end(body->positions_t0().begin(), body->positions_t0().end());
    for (Vec3& x : end)
        x += Vec3(displacement(random), displacement(random), displacement(random));
    FaceTree tree(surface, body->positions_t0());
    tree.refit({surface, body->positions_t0(), end});
    CandidatePairs pairs;
    collect_own_pairs(tree, neighbours, pairs);

    std::set<FeaturePair> vertex_face, edge_edge;
    for (int f = 0; f < static_cast<int>(surface.faces().size()); ++f)
        for (int v = 0; v < surface.vertex_count(); ++v)
            if (tree.vertex_box(v).overlaps(tree.face_box(f)) && !neighbours.vertex_and_face(v, f))
                vertex_face.insert({v, f});
    for (int e = 0; e < static_cast<int>(surface.edges().size()); ++e)
        for (int g = e + 1; g < static_cast<int>(surface.edges().size()); ++g)
            if (tree.edge_box(e).overlaps(tree.edge_box(g)) && !neighbours.edges(e, g))
                edge_edge.insert({e, g});
    CHECK(vertex_face.size() > 100);
    CHECK(edge_edge.size() > 100);
    CHECK(pairs.vertex_face.size() == vertex_face.size());
    CHECK(pairs.face_vertex.empty());
    CHECK(pairs.edge_edge.size() == edge_edge.size());
    for (const FeaturePair& pair : pairs.vertex_face)
        CHECK(vertex_face.contains(pair));
    for (const FeaturePair& pair : pairs.edge_edge)
        CHECK(edge_edge.contains(pair));
}

TEST_CASE("self-detection: each body that asks for it is looked at, and no other")
{
    World world;
    for (const bool self_contact : {false, true, true})
        world.bodies.push_back(soft_fork(1, 1e5, self_contact));
    SelfSearch search;
    search.find_candidates(world, std::vector<double>(world.bodies.size(), 0.03));
    std::array<long, 3> of_itself{};
    const auto count = [&](int a, int, int b, int) { of_itself[static_cast<std::size_t>(a)] += a == b; };
    search.visit_candidates(count, count);
    CHECK(of_itself[0] == 0);
    CHECK(of_itself[1] > 100);
    CHECK(of_itself[2] == of_itself[1]);
}

TEST_CASE("self-contact: bodies that do not ask for it move as with chapter 9, to the last bit")
{
    std::vector<Vec3> ends[2];
    for (const bool own : {false, true}) {
        Scene scene = load_scene(scene_file("initial_overlap"));
        const Solver solver = own ? chapter10_solver(scene.contact) : chapter09_solver(scene.contact);
        Contacts contacts;
        for (int step = 0; step < 40; ++step)
            advance(scene.world, contacts, solver, scene.dt);
        for (const auto& body : scene.world.bodies)
            ends[own].insert(ends[own].end(), body->positions_t0().begin(), body->positions_t0().end());
    }
    CHECK((ends[0] == ends[1]));
}

namespace {

/// What becomes of a fork, weightless, whose legs are thrown together.
struct Clap {
    long deep_crossings = 0;  ///< most after any step, deeper than 0.2 mm
    long unordered = 0;       ///< pairs of edges that stand twice in the list, or the larger first
    double momentum = 0;      ///< most after any step
    double gain = 0;          ///< of energy, over the first
};

Clap clap(int fineness, double young, double dt, bool self_contact)
{
    World world;
    world.gravity.setZero();
    world.bodies.push_back(soft_fork(fineness, young, self_contact));
    Body& body = *world.bodies[0];
    std::vector<int> tips[2];
    for (int v = 0; v < body.surface().vertex_count(); ++v)
        if (const Vec3& x = body.positions_t0()[v]; x.y() > 0.05)
            tips[x.x() > 0].push_back(v);
    for (const int side : {0, 1})
        for (const int v : tips[side])
            body.apply_impulse(v, Vec3((side ? -0.08 : 0.08) / static_cast<double>(tips[side].size()), 0, 0));
    const auto probe = soft_fork(fineness, young, true);  // knows the neighbours
    const Solver solver = chapter10_solver({});
    Contacts contacts;
    Clap result;
    double before = 0;
    for (int step = 0; step < 0.25 / dt; ++step) {
        advance(world, contacts, solver, dt);
        const double energy = body.energy(world.gravity).total();
        before = step == 0 ? energy : before;
        result.gain = std::max(result.gain, energy / before - 1);
        result.deep_crossings = std::max(result.deep_crossings,
                                         chapter10::self_crossings(body, *rest_neighbours(*probe), 2e-4));
        result.momentum = std::max(result.momentum, body.linear_momentum().norm());
        std::set<FeaturePair> edges;
        for (const Contact& c : contacts)
            if (c.kind == ContactKind::edge_edge)
                result.unordered += c.feature_a >= c.feature_b ||
                                    !edges.insert({c.feature_a, c.feature_b}).second;
    }
    return result;
}

}  // namespace

TEST_CASE(
    "self-contact: the legs of a fork that clap together do not pass each other, while without it they do")
{
    for (const double young : {3e4, 3e5})
        for (const double dt : {0.005, 0.01}) {
            CAPTURE(young);
            CAPTURE(dt);
            const Clap with = clap(1, young, dt, true), without = clap(1, young, dt, false);
            CHECK(with.deep_crossings == 0);
            CHECK(with.unordered == 0);
            CHECK(with.momentum < 1e-13);
            CHECK(with.gain < 1e-3);
            CHECK(without.deep_crossings > 0);
        }
}

TEST_CASE("self-contact: a hairpin whose ends nearly touch falls freely, and nothing pushes")
{
    for (const double gap : {2e-3, 1e-4, 1e-5})
        for (const double dt : {0.001, 0.01, 0.04}) {
            CAPTURE(gap);
            CAPTURE(dt);
            const chapter10::HairpinFall fall = chapter10::run_hairpin(gap, dt, 10);
            CHECK(fall.pushed < 1e-10);
            CHECK(fall.off_fall < 1e-10);
        }
}

TEST_CASE(
    "self-contact: a body that begins crossed with itself is warned of, and is neither separated nor thrown")
{
    DeformableSettings settings;
    settings.material = {.young = 3e4, .density = 1000, .stiffness_damping = 0.01};
    settings.impulse_response = ImpulseResponse::implicit;
    settings.self_contact = true;
    Scene scene;
    scene.world.gravity.setZero();
    const auto add = [&](const TetrahedralMesh& mesh) {
        scene.world.bodies.clear();
        scene.world.bodies.push_back(std::make_unique<DeformableBody>("bar", mesh, settings));
    };
    add(fork_mesh(1));
    CHECK(scene_warnings(scene, "fork").empty());
    add(chapter10::crossed_bar(0.02, 0.02, {40, 1, 1}));
    const std::vector<std::string> warnings = scene_warnings(scene, "bar");
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].find("'bar' begins crossed with itself") != std::string::npos);

    Body& bar = *scene.world.bodies[0];
    const long crossings = chapter10::self_crossings(bar, *rest_neighbours(bar));
    CHECK(crossings > 0);
    const Solver solver = chapter10_solver({});
    Contacts contacts;
    for (int step = 0; step < 100; ++step)
        advance(scene.world, contacts, solver, 0.005);
    CHECK(chapter10::self_crossings(bar, *rest_neighbours(bar)) >= crossings);
    CHECK(bar.energy(scene.world.gravity).total() < 1e-9);
}

TEST_CASE("solver of chapter 10: it solves with the settings that it is given")
{
    Scene scene = load_scene(scene_file("initial_overlap"));
    int records = 0;
    ImplicitSettings settings;
    settings.record = [&](const SolveRecord&) { ++records; };
    const Solver solver = chapter10_solver(scene.contact, settings);
    Contacts contacts;
    for (int step = 0; step < 3; ++step)
        advance(scene.world, contacts, solver, scene.dt);
    CHECK(records > 0);
}

TEST_CASE(
    "self-contact: a slippery knot that is pulled stays one, and its strands do not pass through each other")
{
    struct Knot {
        double mu, force, dt;
    };
    for (const Knot& knot : {Knot{0.02, 0.5, 0.005}, Knot{0.1, 1, 0.005}, Knot{0, 0.5, 0.002}}) {
        chapter10::SoftRun run = chapter10::pulled_knot(knot.mu, knot.force);
        run.scene.dt = knot.dt;
        const chapter10::Folded found = chapter10::fold(run, static_cast<int>(0.4 / knot.dt));
        CAPTURE(knot.mu);
        CHECK(chapter10::knot_span(run, run.scene.world) < 0.4);  // untied its rope is half a metre long
        CHECK(found.depth < 5e-4);
        CHECK(found.inverted == 0);
    }
}
