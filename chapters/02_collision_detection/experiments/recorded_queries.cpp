#include "chapters/02_collision_detection/experiments/recorded_queries.hpp"

#include "chapters/01_particle_plane/solver.hpp"
#include "chapters/02_collision_detection/candidate_search.hpp"
#include "common/experiments/run/run.hpp"

namespace enduring::chapter02 {
namespace {

/// Appends the queries of all candidates of a step.
void record(const World& world, CandidateSearch& search, RecordedQueries& queries)
{
    search.find_candidates(world);
    queries.detections += search.candidate_count() > 0;
    const auto surface = [&](int body) { return surface_step(*world.bodies[body]); };
    search.visit_candidates(
        [&](int a, int vertex, int b, int face) {
            queries.vertex_face.push_back(vertex_face_step(surface(a), vertex, surface(b), face));
        },
        [&](int a, int edge_a, int b, int edge_b) {
            queries.edge_edge.push_back(edge_edge_step(surface(a), edge_a, surface(b), edge_b));
        });
}

}  // namespace

RecordedQueries record_queries(const std::string& scene_name, int detections)
{
    Scene scene = load_scene(scene_file(scene_name));
    CandidateSearch search;
    RecordedQueries queries;
    Solver solver = chapter01_solver(scene.contact);
    solver.append(StepStage::detect, "record",
                  [&](World& world, Contacts&, double) { record(world, search, queries); });
    run(scene, solver, {},
        {std::nullopt, [&](const World&, const Contacts&) { return queries.detections >= detections; }});
    return queries;
}

}  // namespace enduring::chapter02
