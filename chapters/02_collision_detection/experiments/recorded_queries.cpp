#include "chapters/02_collision_detection/experiments/recorded_queries.hpp"

#include "chapters/01_particle_plane/plane_contact.hpp"
#include "chapters/01_particle_plane/solver.hpp"
#include "chapters/02_collision_detection/broad_phase.hpp"
#include "common/experiments/run/run.hpp"

namespace enduring::chapter02 {
namespace {

/// A pass that looks at every pair of bodies whenever the step detects.
class Recorder {
public:
    explicit Recorder(const World& world)
    {
        for (const auto& body : world.bodies)
            trees_.emplace_back(body->surface(), body->positions_t0());
    }

    void record(const World& world)
    {
        const std::size_t before = queries.vertex_face.size() + queries.edge_edge.size();
        for (std::size_t i = 0; i < trees_.size(); ++i)
            trees_[i].refit(surface_step(*world.bodies[i]));
        for (std::size_t i = 0; i < trees_.size(); ++i)
            for (std::size_t j = i + 1; j < trees_.size(); ++j)
                record_pair(surface_step(*world.bodies[i]), trees_[i], surface_step(*world.bodies[j]), trees_[j]);
        queries.detections += queries.vertex_face.size() + queries.edge_edge.size() > before;
    }

    RecordedQueries queries;

private:
    void record_pair(const SurfaceStep& a, const FaceTree& tree_a, const SurfaceStep& b, const FaceTree& tree_b)
    {
        collect_pairs(tree_a, tree_b, pairs_);
        for (const auto& [vertex, face] : pairs_.vertex_face)
            queries.vertex_face.push_back(vertex_face_step(a, vertex, b, face));
        for (const auto& [face, vertex] : pairs_.face_vertex)
            queries.vertex_face.push_back(vertex_face_step(b, vertex, a, face));
        for (const auto& [edge_a, edge_b] : pairs_.edge_edge)
            queries.edge_edge.push_back(edge_edge_step(a, edge_a, b, edge_b));
    }

    std::vector<FaceTree> trees_;
    CandidatePairs pairs_;
};

}  // namespace

RecordedQueries record_queries(const std::string& scene_name, int detections)
{
    Scene scene = load_scene(scene_file(scene_name));
    Recorder recorder(scene.world);
    Solver solver = chapter01_solver(scene.contact);
    solver.append(StepStage::detect, {"record", [&](World& world, Contacts&, double) { recorder.record(world); }});
    run(scene, solver, {}, {std::nullopt, [&](const World&, const Contacts&) { return recorder.queries.detections >= detections; }});
    return std::move(recorder.queries);
}

}  // namespace enduring::chapter02
