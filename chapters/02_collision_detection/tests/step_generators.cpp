#include "chapters/02_collision_detection/tests/step_generators.hpp"

#include <cmath>

namespace enduring::generated {
namespace {

Points random_points(Random& random, bool)
{
    Points p;
    for (Vec3& x : p)
        x = random.vector(1);
    return p;
}

/// A query whose features meet at a chosen time and place, up to
/// rounding: random lines through a common point.
Points aimed(Random& random, bool edges)
{
    Points p = random_points(random, edges);
    const double tau = random.uniform(0, 1), u = random.uniform(0, 1), w = random.uniform(0, 1 - u);
    const auto at = [&](std::size_t i) -> Vec3 { return (1 - tau) * p[i] + tau * p[i + 4]; };
    const Vec3 gap = edges ? Vec3((1 - u) * at(0) + u * at(1) - (1 - w) * at(2) - w * at(3))
                           : Vec3(at(0) - (1 - u - w) * at(1) - u * at(2) - w * at(3));
    // Move the first feature by the gap, at both ends of the step.
    for (const std::size_t i : edges ? std::vector<std::size_t>{0, 1, 4, 5} : std::vector<std::size_t>{0, 4})
        p[i] -= gap;
    return p;
}

/// Corners on a coarse lattice: coplanar, parallel, collapsed, touching, resting features come by themselves.
Points lattice(Random& random, bool)
{
    Points p;
    for (Vec3& x : p)
        x = Vec3(random.integer(-2, 2), random.integer(-2, 2), random.integer(-2, 2));
    return p;
}

/// Coplanar throughout.
Points flat_lattice(Random& random, bool edges)
{
    Points p = lattice(random, edges);
    for (Vec3& x : p)
        x.z() = 0;
    return p;
}

/// On one line throughout.
Points linear_lattice(Random& random, bool edges)
{
    Points p = lattice(random, edges);
    for (Vec3& x : p)
        x = Vec3(x.x(), 2 * x.x(), -x.x());
    return p;
}

/// Nearly degenerate: each coordinate of a lattice may move to the next double.
Points nudged(Random& random, Points p)
{
    for (Vec3& x : p)
        for (double& c : x)
            if (const int side = random.integer(-1, 1))
                c = c == 0 ? side * 0x1p-53 : std::nextafter(c, side * 10.0);
    return p;
}

Points nudged_lattice(Random& random, bool edges) { return nudged(random, lattice(random, edges)); }

Points rotated(Points p, const Vec3& axis, double angle)
{
    const Mat3 rotation = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    for (Vec3& x : p)
        x = rotation * x;
    return p;
}

/// Degenerate up to the rounding of a rotation.
Points rotated_flat_lattice(Random& random, bool edges)
{
    return rotated(flat_lattice(random, edges), random.direction(), random.uniform(0, 3));
}

Points rotated_linear_lattice(Random& random, bool edges)
{
    return rotated(linear_lattice(random, edges), random.direction(), random.uniform(0, 3));
}

/// Two parallel features that glide past each other at a tiny distance, tilted in space.
Points gliding(Random& random, bool edges)
{
    Points p = flat_lattice(random, edges);
    const double gap = std::ldexp(1.0, -random.integer(20, 52));
    for (const std::size_t i : edges ? std::vector<std::size_t>{0, 1, 4, 5} : std::vector<std::size_t>{0, 4})
        p[i].z() = gap;
    return random.integer(0, 1) ? rotated(p, random.direction(), random.uniform(0, 3)) : p;
}

/// A lattice far from the origin, with details as small as doubles there allow.
Points large_coordinates(Random& random, bool edges)
{
    Points p = lattice(random, edges);
    for (Vec3& x : p)
        x = 1e9 * Vec3(1, -1, 1) + 0x1p-20 * x;
    return p;
}

Points tiny_coordinates(Random& random, bool edges)
{
    Points p = nudged(random, lattice(random, edges));
    for (Vec3& x : p)
        x *= 1e-15;
    return p;
}

/// Faces and edges squeezed to a width of 1e-9 or less.
Points slivers(Random& random, bool edges)
{
    Points p = aimed(random, edges);
    const Vec3 thin = random.direction();
    const double keep = std::ldexp(1.0, -random.integer(30, 48));
    for (Vec3& x : p)
        x -= (1 - keep) * thin.dot(x) * thin;
    return p;
}

/// No motion at all.
Points at_rest(Random& random, bool edges)
{
    Points p = random.integer(0, 1) ? lattice(random, edges) : aimed(random, edges);
    for (std::size_t i = 0; i < 4; ++i)
        p[i + 4] = p[i];
    return p;
}

/// A height of exactly (tau - 1/2)^2 - depth over a turning plane,
/// with depths around the smallest that matter.
Points tangent(Random& random, bool edges)
{
    const double depth = random.integer(-1, 1) * std::ldexp(1.0, -random.integer(10, 60));
    const auto corner = [](double x, double y, double tilt) { return Vec3(x, y, tilt * x); };
    Points p;
    for (std::size_t end = 0; end < 2; ++end) {
        const double tilt = end == 0 ? -0.5 : 0.5;
        p[4 * end] = edges ? Vec3(-tilt, -1, -depth) : Vec3(-tilt, 0, -depth);
        p[4 * end + 1] = edges ? Vec3(-tilt, 1, -depth) : corner(-2, -2, tilt);
        p[4 * end + 2] = edges ? corner(-2, 0, tilt) : corner(2, -2, tilt);
        p[4 * end + 3] = edges ? corner(2, 0, tilt) : corner(0, 2, tilt);
    }
    return p;
}

/// Two features that rest on each other, or at the distance of a rounding, while both turn as one body.
Points turning_together(Random& random, bool edges)
{
    Points p = at_rest(random, edges);
    for (std::size_t i = 0; i < 4; ++i)
        p[i].z() = 0;
    const Mat3 turn = Eigen::AngleAxisd(random.uniform(0, 1), random.direction()).toRotationMatrix();
    for (std::size_t i = 0; i < 4; ++i)
        p[i + 4] = turn * p[i];
    return p;
}

}  // namespace

Points points_of(const VertexFaceStep& s)
{
    return {s.v_t0, s.f0_t0, s.f1_t0, s.f2_t0, s.v_t1, s.f0_t1, s.f1_t1, s.f2_t1};
}
Points points_of(const EdgeEdgeStep& s)
{
    return {s.ea0_t0, s.ea1_t0, s.eb0_t0, s.eb1_t0, s.ea0_t1, s.ea1_t1, s.eb0_t1, s.eb1_t1};
}

Vec3 Random::direction()
{
    Vec3 d = vector(1);
    while (d.norm() < 0.1 || d.norm() > 1)
        d = vector(1);
    return d.normalized();
}

const std::vector<Category>& categories()
{
    static const std::vector<Category> all{{"random", random_points},
                                           {"aimed", aimed},
                                           {"lattice", lattice},
                                           {"flat lattice", flat_lattice},
                                           {"linear lattice", linear_lattice},
                                           {"nudged lattice", nudged_lattice},
                                           {"rotated flat lattice", rotated_flat_lattice},
                                           {"rotated linear lattice", rotated_linear_lattice},
                                           {"gliding", gliding},
                                           {"large coordinates", large_coordinates},
                                           {"tiny coordinates", tiny_coordinates},
                                           {"slivers", slivers},
                                           {"at rest", at_rest},
                                           {"tangent", tangent},
                                           {"turning together", turning_together}};
    return all;
}

}  // namespace enduring::generated
