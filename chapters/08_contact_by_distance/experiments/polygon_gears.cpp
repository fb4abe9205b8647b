#include "chapters/08_contact_by_distance/experiments/polygon_gears.hpp"

#include "common/simulation/rigid_body.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace enduring::chapter08 {
namespace {

using Vec2 = Eigen::Vector2d;
using Polygon = std::vector<Vec2>;

Polygon turned(const Polygon& polygon, double angle, const Vec2& by)
{
    const Eigen::Rotation2Dd turn(angle);
    Polygon result;
    for (const Vec2& p : polygon)
        result.push_back(turn * p + by);
    return result;
}

/// Calls visit(angle) for the turns about the origin that bring a point onto a segment, in -pi to pi.
template <class Visit>
void visit_turns(const Vec2& p, const Vec2& from, const Vec2& to, const Visit& visit)
{
    const Vec2 along = to - from;
    const double a = along.squaredNorm(), b = from.dot(along),
                 root = b * b - a * (from.squaredNorm() - p.squaredNorm());
    for (const double sign : {-1.0, 1.0}) {
        const double t = (-b + sign * std::sqrt(root)) / a;  // not a number where the circle misses the line
        if (!(t >= 0 && t <= 1))
            continue;
        const Vec2 q = from + t * along;
        visit(std::atan2(p.x() * q.y() - p.y() * q.x(), p.dot(q)));
    }
}

/// The turns about the origin by which B is free to turn, backwards and forwards, before it touches A.
struct Room {
    double back = -std::numbers::pi, ahead = std::numbers::pi;  ///< [rad]
    void bound(double turn)
    {
        (turn < 0 ? back : ahead) = turn < 0 ? std::max(back, turn) : std::min(ahead, turn);
    }
};

/// @param reach_a  distance of A's points from its own centre that B's points reach [m]; so B's from the
///     origin
Room room_of(const Polygon& a, const Vec2& centre_a, double reach_a, const Polygon& b, double reach_b)
{
    const auto near = [](const Polygon& polygon, const Vec2& centre, double reach) {
        Polygon ends;  // of sides with a point in reach, two by two
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
            if ((p - centre).norm() < reach || (q - centre).norm() < reach)
                ends.insert(ends.end(), {p, q});
        }
        return ends;
    };
    const Polygon sides_a = near(a, Vec2::Zero(), reach_b), sides_b = near(b, centre_a, reach_a);
    Room room;
    for (std::size_t i = 0; i < sides_a.size(); i += 2)
        for (std::size_t j = 0; j < sides_b.size(); j += 2) {
            visit_turns(sides_b[j], sides_a[i], sides_a[i + 1], [&](double turn) { room.bound(turn); });
            visit_turns(sides_a[i], sides_b[j], sides_b[j + 1], [&](double turn) { room.bound(-turn); });
        }
    return room;
}

/// By how much the second gear may run behind the ratio, and ahead of it, over a pitch of the first.
class Mesh {
public:
    explicit Mesh(const GearPair& pair)
        : pitch_(2 * std::numbers::pi / pair.teeth),
          ratio_(static_cast<double>(pair.teeth) / pair.other_teeth)
    {
        const GearShape first{.teeth = pair.teeth, .flank_points = pair.flank_points},
            second{.teeth = pair.other_teeth, .flank_points = pair.flank_points};
        const Polygon a = outline(first), b = outline(second);
        const Vec2 centre(-first.pitch_radius() - second.pitch_radius(), 0);
        for (int i = 0; i < samples; ++i) {
            const double angle = pitch_ * i / samples;
            const Polygon turned_a = turned(a, angle, centre),
                          turned_b = turned(
                              b, std::numbers::pi + std::numbers::pi / pair.other_teeth - ratio_ * angle,
                              Vec2::Zero());
            rooms_.push_back(room_of(turned_a, centre, first.pitch_radius() + 1.1 * first.module, turned_b,
                                     second.pitch_radius() + 1.1 * second.module));
        }
    }

    /// Where a bound of the second gear's angle (turned backwards) lies, and its change with the first's.
    struct Bound {
        double angle, slope;
    };
    Bound least(double angle) const { return bound(angle, &Room::ahead); }
    Bound most(double angle) const { return bound(angle, &Room::back); }

private:
    static constexpr int samples = 4000;

    static Polygon outline(const GearShape& shape)
    {
        const SurfaceMesh mesh = gear(shape);
        Polygon points;
        for (int i = 0; i < 2 * shape.teeth * (shape.flank_points + 2); ++i)
            points.push_back(mesh.vertices[static_cast<std::size_t>(i)].head<2>());
        return points;
    }
    Bound bound(double angle, double Room::*side) const
    {
        const double place = (angle / pitch_ - std::floor(angle / pitch_)) * samples;
        const auto i = static_cast<std::size_t>(place) % samples;
        const double from = rooms_[i].*side, change = rooms_[(i + 1) % samples].*side - from;
        return {ratio_ * angle - from - change * (place - std::floor(place)),
                ratio_ - change * samples / pitch_};
    }

    double pitch_, ratio_;
    std::vector<Room> rooms_;
};

double inertia_of(int teeth, int flank_points)
{
    return mass_properties(gear({.teeth = teeth, .flank_points = flank_points}), 7800).inertia(2, 2);
}

}  // namespace

double acceleration_of_polygons(const GearPair& pair, double turns)
{
    const Mesh mesh(pair);
    const double first = inertia_of(pair.teeth, pair.flank_points),
                 second = inertia_of(pair.other_teeth, pair.flank_points), dt = 0.01 * pair.dt;
    double angle = 0, other = 0, speed = 0, other_speed = 0;  // the second gear's count backwards
    double time = 0, start_time = -1, start_speed = 0;
    while (angle < 2 * std::numbers::pi * turns && time < 60) {
        speed += drive_torque / first * dt;
        other_speed -= brake_torque / second * dt;
        const auto stop_at = [&](const Mesh::Bound& bound) {
            const double impulse = (bound.angle - other - other_speed * dt) / dt /
                                   (1 / second + bound.slope * bound.slope / first);
            speed -= bound.slope * impulse / first;
            other_speed += impulse / second;
        };
        for (int again = 0; again < 4; ++again) {
            const double end = angle + speed * dt, other_end = other + other_speed * dt;
            if (const Mesh::Bound least = mesh.least(end); other_end < least.angle)
                stop_at(least);
            else if (const Mesh::Bound most = mesh.most(end); other_end > most.angle)
                stop_at(most);
        }
        angle += speed * dt;
        other += other_speed * dt;
        time += dt;
        if (start_time < 0 && angle > 0.2) {
            start_time = time;
            start_speed = speed;
        }
    }
    return (speed - start_speed) / (time - start_time);
}

}  // namespace enduring::chapter08
