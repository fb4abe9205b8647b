// Each elementary case as a strip of three pictures - before, at the touch, after - and what the queries say about it.
#include "experiments.hpp"
#include "gallery_cases.hpp"
#include "gallery_stage.hpp"

#include "chapters/02_collision_detection/certified.hpp"
#include "chapters/02_collision_detection/edge_triangle.hpp"
#include "chapters/02_collision_detection/textbook.hpp"

#include "common/report/number_text.hpp"

namespace enduring::chapter02 {
namespace {

std::string time_text(const std::optional<double>& tau)
{
    return tau ? readable(*tau, 6) : "none";
}

void add_case(const GalleryCase& one, GalleryStage& stage, Table& table, Report& report)
{
    const auto certified = std::visit([](const auto& step) { return time_of_impact(step); }, one.step);
    const auto textbook = std::visit([](const auto& step) { return textbook_time_of_impact(step); }, one.step);
    table.add({one.name, time_text(textbook), time_text(certified)});
    stage.write_case(one, certified, report.file("gallery_" + one.name + ".png"));
}

/// Edges of one tetrahedron or quadrilateral plate that pass through faces of the other, at one moment.
int discrete_hits(const std::vector<Vec3>& spike, const std::vector<Vec3>& plate)
{
    int hits = 0;
    for (const Face& face : plate_faces())
        for (const auto& [i, j] : tetrahedron_edges)
            hits += find_edge_triangle_hit(spike[std::size_t(i)], spike[std::size_t(j)], plate[std::size_t(face[0])],
                                           plate[std::size_t(face[1])], plate[std::size_t(face[2])]).has_value();
    for (const Face& face : spike_faces())
        for (std::size_t i = 0; i < 4; ++i)
            hits += find_edge_triangle_hit(plate[i], plate[(i + 1) % 4], spike[std::size_t(face[0])],
                                           spike[std::size_t(face[1])], spike[std::size_t(face[2])]).has_value();
    return hits;
}

std::optional<double> first_touch(const Tunnelling& scene)
{
    std::optional<double> first;
    for (std::size_t v = 0; v < scene.spike_t0.size(); ++v)
        for (const Face& face : plate_faces()) {
            const auto corner = [&](std::size_t i) { return scene.plate[std::size_t(face[i])]; };
            const VertexFaceStep step{scene.spike_t0[v], corner(0), corner(1), corner(2), scene.spike_t1[v], corner(0), corner(1), corner(2)};
            if (const auto tau = time_of_impact(step); tau && (!first || *tau < *first))
                first = tau;
        }
    return first;
}

}  // namespace

void gallery(const RunOptions&, Report& report)
{
    GalleryStage stage;
    Table table({"case", "textbook_tau", "certified_tau"});
    for (const GalleryCase& one : gallery_cases())
        add_case(one, stage, table, report);
    report.table("gallery", table);
    report.page_table("gallery", table);

    const Tunnelling scene = tunnelling();
    const auto touch = first_touch(scene);
    const int before = discrete_hits(scene.spike_t0, scene.plate), after = discrete_hits(scene.spike_t1, scene.plate);
    report.fact("gallery", "tunnelling_discrete_before", before);
    report.fact("gallery", "tunnelling_discrete_after", after);
    report.fact("gallery", "tunnelling_tau", touch.value_or(-1), 4);
    stage.write_tunnelling(scene, touch.value_or(0.5), before, after, report.file("gallery_tunnelling.png"));
    stage.write_edge_triangle(report.file("gallery_edge_triangle.png"));
}

}  // namespace enduring::chapter02
