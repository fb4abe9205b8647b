#include "chapters/10_self_contact/experiments/round_turn.hpp"

#include "chapters/10_self_contact/experiments/bent_bars.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter10 {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;
constexpr int post_cells = 4;   ///< from side to side
constexpr int post_layers = 6;  ///< along it
constexpr int post_nodes = (post_layers + 1) * (post_cells + 1) * (post_cells + 1);
constexpr int first_cell = 1;   ///< of the post's end, from which the rope grows
constexpr double gap = 0.0003;  ///< between rope and post [m]: the corners of both have room in it
constexpr double always = 1e9;  ///< [s]

/// From the middle of the post to that of the rope.
double turn_radius(const RoundTurn& shape) { return shape.radius + gap + shape.thickness / 2; }

/// Of the rope along the post.
double slope(const RoundTurn& shape) { return shape.pitch / (full_turn * turn_radius(shape)); }

/// The post below and above the middle of the turn. A rope that slips climbs: its upper end is pulled harder.
double post_below(const RoundTurn& shape) { return shape.pitch + shape.width; }
double post_above(const RoundTurn& shape) { return 2 * post_below(shape); }

/// Where the rope is held back, before the turn.
Vec3 held_place(const RoundTurn& shape)
{
    return {-shape.back, -turn_radius(shape), -shape.pitch / 2 - shape.back * slope(shape)};
}

/// Along the z axis downwards, a square grid across that is bulged to a circle.
TetrahedralMesh post_mesh(const RoundTurn& shape)
{
    const double length = post_below(shape) + post_above(shape);
    TetrahedralMesh post = bar({length, 2, 2}, {post_layers, post_cells, post_cells});
    for (Vec3& x : post.nodes) {
        const double u = x.y(), v = x.z();
        x = {shape.radius * v * std::sqrt(1 - u * u / 2), shape.radius * u * std::sqrt(1 - v * v / 2),
             length / 2 - post_below(shape) - x.x()};
    }
    return post;
}

/// A point of a rope's middle, and the direction in which it goes on.
struct LinePoint {
    Vec3 place, along;
};

/// The line of the rope, points close to each other: from the post's end in a slack bow to where it is held
/// back, straight to the post, once around it and straight away, always along a geodesic of the post.
std::vector<LinePoint> rope_line(const RoundTurn& shape)
{
    constexpr int fine = 2000;
    const double radius = turn_radius(shape), climb = slope(shape);
    const Vec3 ahead = Vec3(1, 0, climb).normalized(), held = held_place(shape);
    const double cell = 2 * shape.radius / post_cells;
    const Vec3 start(shape.radius - cell * (first_cell + 0.5), -shape.radius + cell * (first_cell + 0.5),
                     -post_below(shape));
    const double reach = shape.back + shape.radius;
    const std::array bow{start, Vec3(start - reach * Vec3::UnitZ()), Vec3(held - reach * ahead), held};
    std::vector<LinePoint> line;
    for (int i = 0; i < fine; ++i) {
        const double t = static_cast<double>(i) / fine, s = 1 - t;
        line.push_back(
            {s * s * s * bow[0] + 3 * s * s * t * bow[1] + 3 * s * t * t * bow[2] + t * t * t * bow[3],
             s * s * (bow[1] - bow[0]) + 2 * s * t * (bow[2] - bow[1]) + t * t * (bow[3] - bow[2])});
    }
    for (int i = 0; i < fine; ++i)
        line.push_back({held + Vec3(1, 0, climb) * (shape.back * i / fine), ahead});
    for (int i = 0; i < fine; ++i) {
        const double angle = full_turn * i / fine;
        line.push_back(
            {{radius * std::sin(angle), -radius * std::cos(angle), -shape.pitch / 2 + shape.pitch * i / fine},
             {std::cos(angle), std::sin(angle), climb}});
    }
    for (int i = 0; i <= fine; ++i)
        line.push_back(
            {Vec3(0, -radius, shape.pitch / 2) + Vec3(1, 0, climb) * (shape.front * i / fine), ahead});
    return line;
}

/// The side of the rope that looks at the post where it is on it, and along y elsewhere.
Vec3 inner_side(const RoundTurn& shape, const LinePoint& at)
{
    Vec3 side = Vec3::UnitY();
    const double beside = std::hypot(at.place.x(), at.place.y());
    if (std::abs(at.place.z()) < shape.pitch && beside < 1.001 * turn_radius(shape))
        side = -Vec3(at.place.x(), at.place.y(), 0);
    return (side - side.dot(at.along) / at.along.squaredNorm() * at.along).normalized();
}

TetrahedralMesh rope_mesh(const RoundTurn& shape)
{
    const std::vector<LinePoint> line = rope_line(shape);
    std::vector<double> arc{0};
    for (std::size_t i = 1; i < line.size(); ++i)
        arc.push_back(arc.back() + (line[i].place - line[i - 1].place).norm());
    const int cells = static_cast<int>(arc.back() / shape.cell + 0.5);
    return bent_bar(arc.back(), shape.thickness, shape.width, {cells, 1, 1}, [&](double s) {
        const auto i =
            static_cast<std::size_t>(std::lower_bound(arc.begin(), arc.end() - 1, s) - arc.begin());
        const Vec3 left = inner_side(shape, line[i]);
        return CurvePoint{line[i].place, left, line[i].along.normalized().cross(left)};
    });
}

/// The vertices of the rope next to a place on its middle, at most a cell apart.
std::vector<int> section(const RoundTurn& shape, const Body& body, const Vec3& place, const Vec3& along)
{
    std::vector<int> vertices;
    for (int vertex = 0; vertex < body.surface().vertex_count(); ++vertex) {
        const Vec3& x = body.positions_t0()[vertex];
        const double on = (x - place).dot(along);
        const bool of_post = std::hypot(x.x(), x.y()) < shape.radius + gap / 2;
        if (!of_post && std::abs(on) < 0.51 * shape.cell &&
            (x - place - on * along).norm() < 0.6 * shape.width)
            vertices.push_back(vertex);
    }
    return vertices;
}

}  // namespace

double RoundTurn::angle() const { return full_turn * std::cos(std::atan(slope(*this))); }

TetrahedralMesh round_turn_mesh(const RoundTurn& shape)
{
    TetrahedralMesh joined = post_mesh(shape);
    const TetrahedralMesh rope = rope_mesh(shape);
    const int in_row = static_cast<int>(rope.nodes.size()) / 4;
    std::vector<int> renamed;
    for (int node = 0; node < static_cast<int>(rope.nodes.size()); ++node) {
        const int i = node % in_row, j = node / in_row % 2, k = node / in_row / 2;
        if (i == 0) {  // the rope's first nodes are some of the post's end
            renamed.push_back(post_layers +
                              (post_layers + 1) * (first_cell + j + (post_cells + 1) * (post_cells / 2 + k)));
        } else {
            renamed.push_back(static_cast<int>(joined.nodes.size()));
            joined.nodes.push_back(rope.nodes[node]);
        }
    }
    for (auto element : rope.elements) {
        for (int& node : element)
            node = renamed[node];
        joined.elements.push_back(element);
    }
    return joined;
}

RoundTurnRun round_turn(const RoundTurn& shape, const SoftVariant& variant, double force, double ratio)
{
    SoftRun run = soft_run(variant);
    run.scene.name = "round turn";
    run.scene.contact.friction = MassSplitting{.mu_s = variant.mu, .mu_d = variant.mu};
    run.scene.world.gravity.setZero();
    const TetrahedralMesh mesh = round_turn_mesh(shape);
    std::vector<int> core;
    for (int node = 0; node < post_nodes; ++node)
        if (std::hypot(mesh.nodes[node].x(), mesh.nodes[node].y()) < 0.8 * shape.radius)
            core.push_back(node);
    add_soft(run.scene, "rope", mesh, variant, Vec3::Zero(), Vec3::Zero(), core);

    const Body& body = *run.scene.world.bodies[0];
    const Vec3 ahead = Vec3(1, 0, slope(shape)).normalized();
    const Vec3 front = Vec3(0, -turn_radius(shape), shape.pitch / 2) + shape.front / ahead.x() * ahead;
    run.pulls = {{.vertices = section(shape, body, held_place(shape), ahead),
                  .force = -force / ratio * ahead,
                  .until = always},
                 {.vertices = section(shape, body, front, ahead), .force = force * ahead, .until = always}};
    run.scene.camera = {{0.04, -0.19, 0.14}, {-0.01, 0, -0.015}, 27};
    std::vector<int> middle = section(shape, body, {0, turn_radius(shape), 0}, -Vec3::UnitX());
    return {std::move(run), std::move(middle)};
}

double displacement_of_turn(const RoundTurn& shape, const RoundTurnRun& turn)
{
    Vec3 sum = Vec3::Zero();
    for (const int vertex : turn.middle)
        sum += turn.soft.scene.world.bodies[0]->positions_t0()[vertex];
    return turn_radius(shape) * std::atan2(-sum.x(), sum.y());
}

}  // namespace enduring::chapter10
