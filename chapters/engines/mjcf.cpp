#include "chapters/engines/mjcf.hpp"

#include "common/input/number_text.hpp"

#include <sstream>

namespace enduring::engines {
namespace {

constexpr double wedge_thickness =
    0.05;  ///< [m]; a tenth: fast bodies come through; ten times: wedges of a hollow reach into it

/// Numbers with a space between them, that read back the same.
std::ostream& operator<<(std::ostream& out, const Vec3& v)
{
    return out << shortest(v.x()) << ' ' << shortest(v.y()) << ' ' << shortest(v.z());
}

/// Shapes of meshes, and what stands or moves in the world.
struct Mjcf {
    std::ostringstream assets, world;
    int meshes = 0;

    void mesh(const std::vector<Vec3>& points)
    {
        ++meshes;
        assets << "<mesh name=\"m" << meshes << "\" vertex=\"";
        for (const Vec3& x : points)
            assets << x << ' ';
        assets << "\"/>\n";
        world << "<geom type=\"mesh\" mesh=\"m" << meshes << "\"/>\n";
    }
    void add_static(const EngineBody& body)
    {
        if (body.convex) {
            mesh(body.points);
            return;
        }
        for (const auto& [a, b, c] : body.faces) {
            const auto corner = [&](int i) { return body.points[static_cast<std::size_t>(i)]; };
            const Vec3 back = -wedge_thickness *
                              (corner(b) - corner(a)).cross(corner(c) - corner(a)).normalized();
            mesh({corner(a), corner(b), corner(c), corner(a) + back, corner(b) + back, corner(c) + back});
        }
    }
    void add_moving(const EngineBody& body)
    {
        const Quaternion& q = body.frame.orientation;
        world << "<body pos=\"" << body.frame.position << "\" quat=\"" << shortest(q.w()) << ' '
              << Vec3(q.vec()) << "\"><freejoint/><inertial pos=\"0 0 0\" mass=\"" << shortest(body.mass)
              << "\" diaginertia=\"" << body.inertia << "\"/>";
        if (body.half_size)
            world << "<geom type=\"box\" size=\"" << *body.half_size << "\"/>";
        else
            mesh(body.points);
        world << "</body>\n";
    }
};

}  // namespace

std::string mjcf_of(const EngineScene& scene, const Way& way, double step, bool buffer)
{
    Mjcf parts;
    for (const Plane& plane : scene.planes)
        parts.world << "<geom type=\"plane\" size=\"0 0 1\" pos=\"" << plane.point << "\" zaxis=\""
                    << plane.normal << "\"/>\n";
    for (const EngineBody& body : scene.bodies)
        body.moves ? parts.add_moving(body) : parts.add_static(body);
    std::ostringstream text;
    text << "<mujoco>\n<compiler balanceinertia=\"true\"/>\n";
    if (buffer)
        text << "<size njmax=\"12000\" nconmax=\"3000\"/>\n";
    text << "<option timestep=\"" << shortest(step) << "\" gravity=\"" << scene.gravity << "\"";
    if (way.fine)
        text << " cone=\"elliptic\" impratio=\"10\"";
    if (way.iterations > 0)
        text << " iterations=\"" << way.iterations << "\"";
    text << "/>\n<default><geom friction=\"" << shortest(scene.friction) << " 0.005 0.0001\"";
    if (way.fine)
        text << " solref=\"" << shortest(2 * step) << " 1\"";
    text << "/></default>\n<asset>\n"
         << parts.assets.str() << "</asset>\n<worldbody>\n"
         << parts.world.str() << "</worldbody>\n</mujoco>\n";
    return text.str();
}

std::vector<double> mujoco_velocities(const EngineScene& scene)
{
    std::vector<double> all;
    for (const EngineBody& body : scene.bodies)
        if (body.moves) {
            const Vec3 own = body.frame.orientation.conjugate() * body.angular_velocity;
            all.insert(all.end(), body.velocity.begin(), body.velocity.end());
            all.insert(all.end(), own.begin(), own.end());
        }
    return all;
}

}  // namespace enduring::engines
