#include "chapters/08_contact_by_distance/experiments/forces_statics.hpp"

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "common/geometry/box_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter08::force_rows {
namespace {

constexpr double earth = 9.81;  // [m/s^2]

/// A pyramid with a polygon as its base at the height 0.3 m, and its tip down at the origin.
SurfaceMesh tip_down(int sides, double radius)
{
    constexpr double height = 0.3;
    SurfaceMesh mesh;
    mesh.vertices.emplace_back(Vec3::Zero());
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        mesh.vertices.emplace_back(radius * std::cos(angle), height, radius * std::sin(angle));
    }
    for (int i = 1; i <= sides; ++i) {
        const int next = i % sides + 1;
        mesh.faces.push_back({0, i, next});
        if (i > 1 && i < sides)
            mesh.faces.push_back({1, next, i});
    }
    return mesh;
}

struct Standing {
    std::string name;
    SurfaceMesh mesh;
    bool upright = false;  ///< held, for it would fall over
};

std::vector<Standing> standing_bodies(bool full)
{
    SurfaceMesh three = turned(moved(tip_down(3, 0.3), Vec3(0, -0.3, 0)),
                               Quaternion(Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitX())));
    std::vector<Standing> bodies{{"1 pair", tip_down(5, 0.2), true},
                                 {"2 pairs", chapter07::prism({{0, 0}, {0.2, 0.4}, {-0.2, 0.4}}, 0.5), true},
                                 {"3 pairs", three}};
    for (const int cells : full ? std::vector{1, 4, 10, 21} : std::vector{1, 4, 10})
        bodies.push_back({std::to_string((cells + 1) * (cells + 1)) + " pairs",
                          moved(box({1, 0.2, 1}, {cells, 1, cells}), Vec3(0, 0.1, 0))});
    return bodies;
}

}  // namespace

Rows weights(const MakeSolver& make, bool full)
{
    Row sum{"weight", "body on 1 to " + std::string(full ? "484" : "121") + " pairs", "sum of the forces",
            "m g", 1e-7},
        law{"law", "the same", "force of each pair", "k times its depth", 1e-6};
    for (const Floor floor : all_floors)
        for (const double dt : full ? std::vector{1.0 / 60, 0.002} : std::vector{1.0 / 60})
            for (const Standing& standing : standing_bodies(full)) {
                Scene scene = empty_scene(dt, 0.5);
                add_floor(scene, floor);
                RigidBody& body = add_rigid(scene, "body", standing.mesh, 10);
                if (standing.upright)
                    body.hold({.translation = Vec3::Ones(), .rotation = Vec3::Zero()});
                Stepped run(std::move(scene), make);
                run.come_to_rest(3);
                const std::size_t last = run.world().bodies.size() - 1;
                const std::string name = standing.name + " on a " + name_of(floor) + named(", dt", dt);
                sum.add(name, 100 * (run.on_bodies()[last] - Vec3(0, 10 * earth, 0)).norm() / (10 * earth));
                law.add(name, 100 * run.off_law());
            }
    return {sum, law};
}

namespace {

constexpr double table_radius = 0.5, leg_height = 0.3, table_mass = 20, load = 100;  // [m], [kg], [N]

/// A slab on pyramids with their tips down, at the corners of a regular polygon; the first leg lies towards
/// +x.
SurfaceMesh table_mesh(int legs)
{
    SurfaceMesh mesh = moved(box({1.2, 0.1, 1.2}), Vec3(0, leg_height + 0.05, 0));
    for (int i = 0; i < legs; ++i) {
        const double angle = 2 * std::numbers::pi * i / legs;
        mesh = together(mesh,
                        moved(tip_down(4, 0.03), table_radius * Vec3(std::cos(angle), 0, std::sin(angle))));
    }
    return mesh;
}

/// Loads on the legs, in their order [N].
std::vector<double> leg_loads(const Stepped& run, std::size_t table, int legs)
{
    const std::vector<Vec3> forces = run.on_vertices(table);
    std::vector<double> loads;
    loads.reserve(static_cast<std::size_t>(legs));
    for (int i = 0; i < legs; ++i)
        loads.push_back(forces[static_cast<std::size_t>(8 + 5 * i)].y());
    return loads;
}

/// Where a point of a rigid body is now [m]: by the affine map that takes the vertices from where they began
/// to where they are.
Vec3 carried_along(const Vec3& point, const std::vector<Vec3>& began, const Body& body)
{
    Vec3 from = Vec3::Zero(), to = Vec3::Zero();
    for (std::size_t i = 0; i < began.size(); ++i) {
        from += began[i] / static_cast<double>(began.size());
        to += body.positions_t0()[i] / static_cast<double>(began.size());
    }
    Mat3 both = Mat3::Zero(), spread = Mat3::Zero();
    for (std::size_t i = 0; i < began.size(); ++i) {
        both += (body.positions_t0()[i] - to) * (began[i] - from).transpose();
        spread += (began[i] - from) * (began[i] - from).transpose();
    }
    return to + both * spread.inverse() * (point - from);
}

}  // namespace

Rows tables(const MakeSolver& make, bool full)
{
    Row sum{"table", "table on 4, 5 and 6 legs, loaded in the middle or beside it", "sum, and moments",
            "statics", 1e-6},
        equal{"legs", "the same", "legs that are mirror images, or all of a regular table", "equal loads",
              1e-4},
        law{"legs_law", "the same", "force of each leg", "k times its depth", 1e-6};
    for (const int legs : {4, 5, 6})
        for (const Floor floor : all_floors)
            for (const double beside : full ? std::vector{0.0, 0.1, 0.2} : std::vector{0.0, 0.2}) {
                Scene scene = empty_scene(1.0 / 60, 0.5);
                add_floor(scene, floor);
                const SurfaceMesh mesh = table_mesh(legs);
                const Vec3 middle = mass_properties(mesh, 1).centre, loaded(beside, 0.4, 0);
                RigidBody& body = add_rigid(scene, "table", mesh, table_mass);
                body.add_load({.force = TimedVector(Vec3(0, -load, 0)), .point = loaded});
                Stepped run(std::move(scene), make);
                run.come_to_rest(3);
                const std::size_t last = run.world().bodies.size() - 1;
                const std::string name = std::to_string(legs) + " legs on a " + name_of(floor) +
                                         named(", load at", beside);
                const double all = table_mass * earth + load;
                const double off_sum = std::abs(run.on_bodies()[last].y() - all) / all;
                // its springs let the table lean by a microradian: weight and load are where they are then
                const Vec3 expected =
                    carried_along(middle, mesh.vertices, run.body(last))
                        .cross(Vec3(0, table_mass * earth, 0)) +
                    carried_along(loaded, mesh.vertices, run.body(last)).cross(Vec3(0, load, 0));
                const double off_moment = (run.moment(last, Vec3::Zero()) - expected).norm() /
                                          (all * table_radius);
                sum.add(name, 100 * std::max(off_sum, off_moment));
                const std::vector<double> loads = leg_loads(run, last, legs);
                double off = 0;
                for (int i = 0; i < legs; ++i) {
                    const double own = loads[static_cast<std::size_t>(i)];
                    off = std::max(off, std::abs(own - loads[static_cast<std::size_t>((legs - i) % legs)]));
                    if (beside == 0)
                        off = std::max(off, std::abs(own - all / legs));
                }
                equal.add(name, 100 * off / (all / legs));
                law.add(name, 100 * run.off_law());
            }
    return {sum, equal, law};
}

namespace {

/// How far the vertical forces on the lower vertices of a body are from those on their mirror images, over
/// the largest.
double off_mirror(const Stepped& run, std::size_t index, const Vec3& mirror)
{
    const std::vector<Vec3> forces = run.on_vertices(index);
    const auto positions = run.body(index).positions_t0();
    const Vec3 centre = run.body(index).centre();
    double largest = 0, off = 0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
        const Vec3 image = centre + mirror.cwiseProduct(positions[i] - centre);
        const auto nearest = std::min_element(
            positions.begin(), positions.end(), [&](const Vec3& a, const Vec3& b) {
                return (a - image).squaredNorm() < (b - image).squaredNorm();
            });
        const auto other = static_cast<std::size_t>(nearest - positions.begin());
        largest = std::max(largest, std::abs(forces[i].y()));
        off = std::max(off, std::abs(forces[i].y() - forces[other].y()));
    }
    return largest > 0 ? off / largest : INFINITY;
}

}  // namespace

Rows mirror_images(const MakeSolver& make, bool full)
{
    Row row{"mirror", "box with a symmetric grid of vertices", "forces of mirror images", "equal", 1e-4};
    for (const auto& [x, z] : full ? std::vector<std::array<int, 2>>{{2, 2}, {4, 6}, {7, 3}, {10, 10}}
                                   : std::vector<std::array<int, 2>>{{2, 2}, {4, 6}})
        for (const Floor floor : all_floors)
            for (const double dt : {1.0 / 60, 0.005}) {
                Scene scene = empty_scene(dt, 0.5);
                add_floor(scene, floor);
                add_rigid(scene, "box", moved(box({1, 0.2, 0.8}, {x, 1, z}), Vec3(0, 0.1, 0)), 10);
                Stepped run(std::move(scene), make);
                run.come_to_rest(3);
                const std::size_t last = run.world().bodies.size() - 1;
                const std::string name = std::to_string(x) + " x " + std::to_string(z) + " cells on a " +
                                         name_of(floor) + named(", dt", dt);
                for (const Vec3& mirror : {Vec3(-1, 1, 1), Vec3(1, 1, -1)})
                    row.add(name, 100 * off_mirror(run, last, mirror));
            }
    return {row};
}

namespace {

double all_weight(const Stepped& run)
{
    double sum = 0;
    for (std::size_t i = 0; i < run.world().bodies.size(); ++i)
        sum += run.weight(i);
    return sum;
}

double off_base(const Stepped& run)
{
    Vec3 ground = Vec3::Zero();
    for (std::size_t i = 0; i < run.world().bodies.size(); ++i)
        ground += run.between(static_cast<int>(i), Stepped::planes);
    const double weight = all_weight(run);
    return (ground - Vec3(0, weight, 0)).norm() / weight;
}

/// Of each box in a stack: what the one above presses it with, against the weight above, over all weight.
double off_between(const Stepped& run)
{
    double above = 0, off = 0;
    for (std::size_t i = run.world().bodies.size() - 1; i > 0; --i) {
        above += run.weight(i);
        const Vec3 force = run.between(static_cast<int>(i), static_cast<int>(i - 1));
        off = std::max(off, (force - Vec3(0, above, 0)).norm());
    }
    return off / all_weight(run);
}

/// Rows of bricks, each with one less than the row below.
std::vector<chapter07::Box> pyramid(int rows)
{
    std::vector<chapter07::Box> boxes;
    for (int row = 0; row < rows; ++row)
        for (int i = 0; i < rows - row; ++i)
            boxes.push_back({.mass = 5,
                             .centre = Vec3(1.05 * (i - 0.5 * (rows - row - 1)), 0.25 + 0.5 * row, 0),
                             .size = Vec3(1, 0.5, 0.6)});
    return boxes;
}

}  // namespace

Rows piles(const MakeSolver& make, bool full)
{
    Row base{"pile", "stacks, pyramids and heaps at rest", "forces of the ground", "weight of all", 1e-6},
        stack{"stack", "stacks", "forces between two boxes", "weight above", 1e-6};
    for (const double dt : full ? std::vector{1.0 / 60, 0.005} : std::vector{1.0 / 60}) {
        for (const int n : full ? std::vector{3, 10, 20} : std::vector{3, 10})
            for (const double last : {10.0, 200.0}) {
                Stepped run(chapter07::scene_of(chapter07::stack_of(n, 10, last), dt), make);
                run.come_to_rest(3);
                const std::string name = named(std::to_string(n) + " boxes, upper one [kg]", last);
                base.add(name, 100 * off_base(run));
                stack.add(name, 100 * off_between(run));
            }
        Stepped bricks(chapter07::scene_of(pyramid(4), dt), make);
        bricks.come_to_rest(3);
        base.add("pyramid of 10 bricks", 100 * off_base(bricks));
        Stepped heap(chapter07::scene_of(chapter07::loose_cubes(6, 2, 3), dt), make);
        heap.run_for(1);
        heap.come_to_rest(5);
        base.add("heap of 6 cubes", 100 * off_base(heap));
    }
    return {base, stack};
}

Rows slopes(const MakeSolver& make, bool full)
{
    Row row{"slope", "box on a slope, below the threshold", "friction, and normal force",
            "m g sin α, m g cos α", 1e-6};
    constexpr double mass = 10, mu = 0.5;  // holds up to 26.57 degrees
    for (const double degrees : full ? std::vector{1.0, 5.0, 15.0, 26.0, 26.5} : std::vector{5.0, 26.0})
        for (const int cells : {1, 6})
            for (const bool on_mesh : {false, true})
                for (const double dt : full ? std::vector{1.0 / 60, 0.002} : std::vector{1.0 / 60}) {
                    const double angle = degrees * std::numbers::pi / 180;
                    const Quaternion turn(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
                    Scene scene = empty_scene(dt, mu);
                    if (on_mesh)
                        add_static(scene, "slope", slope({5, 0.3, 3}, angle, {5, 1, 3}));
                    else
                        add_ground(scene, angle);
                    add_rigid(scene, "box",
                              turned(moved(box({1, 0.2, 0.8}, {cells, 1, cells}), Vec3(0, 0.1, 0)), turn),
                              mass);
                    Stepped run(std::move(scene), make);
                    run.come_to_rest(3);
                    const Vec3 force = turn.conjugate() * run.on_bodies().back();
                    const double along = mass * earth * std::sin(angle), up = mass * earth * std::cos(angle);
                    row.add(named("slope", degrees) + "°, " + std::to_string(cells) + " cells, " +
                                (on_mesh ? "mesh" : "plane") + named(", dt", dt),
                            100 * std::max((force - Vec3(along, up, 0)).norm() / along,
                                           std::abs(force.y() - up) / up));
                }
    return {row};
}

}  // namespace enduring::chapter08::force_rows
