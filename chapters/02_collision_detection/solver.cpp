#include "chapters/02_collision_detection/solver.hpp"

#include "chapters/01_particle_plane/solver.hpp"
#include "chapters/02_collision_detection/candidate_search.hpp"
#include "chapters/02_collision_detection/certified.hpp"
#include "chapters/02_collision_detection/impact_weights.hpp"

#include <memory>

namespace enduring {
namespace {

/// A first touch. On which side of each other the features go on is chapter 3's question.
struct Meeting {
    double time;
    std::array<double, 4> weights;
    double orientation = 1;
};

std::optional<Meeting> vertex_meets_face(const VertexFaceStep& step)
{
    const std::optional<double> time = time_of_impact(step);
    if (!time)
        return std::nullopt;
    const auto [w0, w1, w2] = impact_weights(step, *time);
    return Meeting{*time, {1, -w0, -w1, -w2}};
}

std::optional<Meeting> edge_meets_edge(const EdgeEdgeStep& step, const SurfaceStep&, int, const SurfaceStep&,
                                       int)
{
    const std::optional<double> time = time_of_impact(step);
    if (!time)
        return std::nullopt;
    const auto [s, t] = impact_weights(step, *time);
    return Meeting{*time, {1 - s, s, t - 1, -t}};
}

}  // namespace

//! [solver]
Solver chapter02_solver(const ContactParameters& parameters)
{
    const auto search = std::make_shared<CandidateSearch>();
    Solver solver = chapter01_solver(parameters);
    solver.name = "chapter 2";
    solver.append(StepStage::detect, "broad phase",
                  [search](World& world, Contacts&, double) { search->find_candidates(world); });
    solver.append(StepStage::detect, "queries", [search](World& world, Contacts& contacts, double) {
        const std::size_t first_new = contacts.size();
        append_pairs(world, *search, vertex_meets_face, edge_meets_edge, contacts);
        for (std::size_t i = first_new; i < contacts.size(); ++i)
            contacts[i].hold(true);  // no layer answers them yet
    });
    return solver;
}
//! [solver]

}  // namespace enduring
