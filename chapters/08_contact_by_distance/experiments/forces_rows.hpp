#pragma once

#include "common/geometry/moved_mesh.hpp"
#include "common/scenes/scene.hpp"
#include "common/simulation/rigid_body.hpp"

#include <functional>
#include <random>
#include <string>
#include <vector>

/// Forces of pairs against statics and formulas. Rows know no solver: each is given one, of any chapter that
/// answers all pairs together.
namespace enduring::chapter08::force_rows {

using MakeSolver = std::function<Solver(const ContactParameters&)>;

/// A kind of scenes in which forces are known, and the run that is farthest off.
struct Row {
    std::string key;  ///< of its facts
    std::string scene, quantity, formula;
    double allowed = 0;  ///< in the unit
    std::string unit = "%";
    long runs = 0;
    double off = 0;       ///< in the unit
    std::string worst{};  ///< run, and step where steps are compared

    /// What is no number is infinitely far off.
    void add(const std::string& run, double off_in_unit);
    bool holds() const { return runs > 0 && off <= allowed; }
};
using Rows = std::vector<Row>;

/// "name 3", "name 0.5": of runs, from a number that is varied.
std::string named(const std::string& name, double value);

/// A scene without bodies and planes.
/// @param mu  static and dynamic
Scene empty_scene(double dt, double mu);
void add_ground(Scene& scene, double slope_rad = 0);  ///< a plane through the origin; it falls towards -x
RigidBody& add_rigid(Scene& scene, const std::string& name, const SurfaceMesh& mesh, double mass,
                     const Vec3& velocity = Vec3::Zero(), const Vec3& angular_velocity = Vec3::Zero());
void add_static(Scene& scene, const std::string& name, const SurfaceMesh& mesh);

/// Random, and the same on each machine.
Quaternion random_turn(std::mt19937& random);

/// The first of its lowest vertices.
Vec3 lowest(const SurfaceMesh& mesh);
/// Both as one surface of several parts.
SurfaceMesh together(SurfaceMesh one, const SurfaceMesh& other);

/// On what a body stands, with its upper side at y = 0.
enum class Floor { plane, box, cut_box };
inline constexpr std::array all_floors{Floor::plane, Floor::box, Floor::cut_box};
std::string name_of(Floor floor);
/// @param side  of a box [m]; a cut box has cells whose lines lie askew below what stands in the middle
void add_floor(Scene& scene, Floor floor, double side = 3);

/// A scene that is stepped, and what its pairs exert.
class Stepped {
public:
    Stepped(Scene scene, const MakeSolver& make);

    void step();
    void run_for(double duration);
    /// Steps until all bodies rest, for a tenth of a second at least and `longest` [s] at most.
    void come_to_rest(double longest);

    /// Parts in which the last step was taken.
    long parts() const { return 1 + world().thrown_away - thrown_before_; }
    /// The most of any step so far.
    long most_parts() const { return most_parts_; }
    /// The speed of the fastest body in any step so far [m/s].
    double fastest() const { return fastest_; }

    World& world() { return scene_.world; }
    const World& world() const { return scene_.world; }
    const Contacts& contacts() const { return contacts_; }
    double dt() const { return scene_.dt; }
    const Body& body(std::size_t index) const { return *world().bodies[index]; }
    /// Of a rigid body.
    const RigidMotion& motion(std::size_t index) const
    {
        return dynamic_cast<const RigidBody&>(body(index)).motion();
    }
    double weight(std::size_t index) const { return body(index).mass() * world().gravity.norm(); }

    std::vector<Vec3> on_bodies() const;  ///< of all pairs [N]
    /// Force on one body from another, or from all planes for `planes` [N].
    Vec3 between(int body, int other) const;
    static constexpr int planes = -1;
    std::vector<Vec3> on_vertices(std::size_t body) const;   ///< [N]
    Vec3 moment(std::size_t body, const Vec3& about) const;  ///< of all pairs [N m]
    /// How far pairs are from k times depth, over the largest force or spring; 0 for a solver whose springs
    /// give nothing.
    double off_law() const;

private:
    Scene scene_;
    Solver solver_;
    Contacts contacts_;
    long thrown_before_ = 0, most_parts_ = 1;
    double fastest_ = 0;
};

}  // namespace enduring::chapter08::force_rows
