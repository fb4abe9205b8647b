#include "chapters/05_categorisation/experiments/known_truth.hpp"

#include "common/experiments/run/run.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <cmath>
#include <memory>

namespace enduring::chapter05 {
namespace {

/// The right direction of a contact's normal, from B to A.
Vec3 right_direction(const TruthScene& scene, const World& world, const Contact& contact, const Vec3& point)
{
    const auto b = scene.outwards.find(name_of_b(world, contact));
    return b != scene.outwards.end() ? b->second(point)
                                     : Vec3(-scene.outwards.at(name_of_a(world, contact))(point));
}

/// Nearer than this to the cosine of 45 degrees the truth itself is a matter of
/// rounding: a side's diagonal on a floor's edge.
constexpr double border = 1e-2;

/// Watches the labels as they are given.
class LabelAudit {
public:
    LabelAudit(const TruthScene& scene, LabelCounts& counts) : scene_(scene), counts_(counts) {}

    void enduring(const World& world, const Contacts& contacts)
    {
        seen_ = 0;
        appended(world, contacts);
    }
    /// Those behind the ones that are known: a detection appends.
    void appended(const World& world, const Contacts& contacts)
    {
        for (; seen_ < contacts.size(); ++seen_)
            count(world, contacts[seen_]);
    }

private:
    void count(const World& world, const Contact& contact)
    {
        if (contact.category == ContactCategory::unknown) {
            ++counts_.without_normal;
            return;
        }
        const ContactGeometry geometry = contact_geometry(world, contact, contact.start);
        const double off = geometry.normal.dot(right_direction(scene_, world, contact, geometry.p)) -
                           hook_cosine;
        if (std::abs(off) < border) {
            ++counts_.on_border;
            return;
        }
        const bool is_true = off > 0;
        const bool regular = contact.category == ContactCategory::regular;
        ++(is_true ? (regular ? counts_.true_regular : counts_.true_hooked)
                   : (regular ? counts_.artefact_regular : counts_.artefact_hooked));
    }

    const TruthScene& scene_;
    LabelCounts& counts_;
    std::size_t seen_ = 0;
};

}  // namespace

LabelCounts& LabelCounts::operator+=(const LabelCounts& other)
{
    true_regular += other.true_regular;
    true_hooked += other.true_hooked;
    artefact_regular += other.artefact_regular;
    artefact_hooked += other.artefact_hooked;
    on_border += other.on_border;
    without_normal += other.without_normal;
    return *this;
}

std::vector<TruthScene> truth_scenes()
{
    const Outwards up = [](const Vec3&) { return Vec3(Vec3::UnitY()); };
    const Outwards to_the_cube = [](const Vec3&) { return Vec3(-Vec3::UnitX()); };
    const Outwards to_the_centre = [](const Vec3& point) { return Vec3(-point.normalized()); };
    const std::string crossed = R"({"name": "floor", "type": "static", "shape": {"plane_grid":
        {"size": [4, 2], "cells": [10, 5], "diagonals": "crossed"}}, "position": [1, 0, 0]})";
    const std::string cube =
        R"("name": "cube", "type": "rigid", "shape": {"box": {"size": [0.5, 0.5, 0.5]}}, "mass": 20, "velocity": [1.5, 0, 0])";
    const auto bodies = [&](const std::string& rest) {
        return R"({"bodies": [)" + crossed + ", " + rest + "]}";
    };
    return {
        {"cube, pushed as ever", "", {{"floor", up}}, HookedPairs::pushed},
        {"cube", "", {{"floor", up}}},
        {"cube, turned by 27°",
         bodies("{" + cube +
                R"(, "position": [0, 0.255, 0.03], "rotation": {"axis": [0, 1, 0], "angle_deg": 27}})"),
         {{"floor", up}}},
        {"cube meets a wall",
         bodies("{" + cube + R"(, "position": [0, 0.255, 0.03]}, {"name": "wall", "type": "static",
            "shape": {"box": {"size": [0.4, 1.5, 1.5], "cells": [1, 6, 6]}}, "position": [0.91, 0.2, 0.07]})"),
         {{"floor", up}, {"wall", to_the_cube}}},
        {"cube in a bowl",
         R"({"bodies": [{"name": "bowl", "type": "static", "shape": {"bowl": {"inner_radius": 1.0, "thickness": 0.12,
            "rim_angle_deg": 80, "segments_around": 20, "segments_along": 8, "segments_rim": 2}}}, {"name": "cube", "type": "rigid",
            "shape": {"box": {"size": [0.3, 0.3, 0.3], "cells": [3, 3, 3]}}, "mass": 20, "position": [0.45, -0.45, 0.03], "velocity": [0, 0, 1],
            "rotation": {"axis": [0, 0, 1], "angle_deg": 45}}]})",
         {{"bowl", to_the_centre}}},
        {"ball",
         bodies(
             R"({"name": "ball", "type": "rigid", "shape": {"sphere": {"radius": 0.25, "subdivisions": 2}}, "mass": 20,
            "velocity": [1.5, 0, 0], "position": [0, 0.255, 0.03]})"),
         {{"floor", up}}},
        {"tetrahedron on its tip",
         bodies(R"({"name": "tip", "type": "rigid", "shape": {"tetrahedron": {"edge": 0.5}}, "mass": 20,
            "velocity": [1.5, 0, 0], "position": [0, 0.36, 0.03], "rotation": {"axis": [1, 0, 0.2], "angle_deg": 170}})"),
         {{"floor", up}}},
    };
}

LabelCounts count_labels(const TruthScene& truth, double share, EdgeRule rule)
{
    Scene scene = load_scene(scene_file("hooked"), truth.patch);
    scene.duration *= share;
    LabelCounts counts;
    const auto audit = std::make_shared<LabelAudit>(truth, counts);
    Solver solver = solver_that(truth.treatment, rule, scene.contact);
    solver.append(StepStage::refresh, "audit",
                  [audit](World& world, Contacts& contacts, double) { audit->enduring(world, contacts); });
    solver.append(StepStage::detect, "audit new",
                  [audit](World& world, Contacts& contacts, double) { audit->appended(world, contacts); });
    run(scene, solver);
    return counts;
}

}  // namespace enduring::chapter05
