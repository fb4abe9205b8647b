#pragma once

#include "chapters/02_collision_detection/candidate_search.hpp"
#include "common/rigid/rigid_motion.hpp"
#include "common/simulation/step.hpp"

#include <array>
#include <tuple>
#include <vector>

namespace enduring {

class DeformableBody;

/// The axis of a turn times its angle in [0, pi] [rad].
Vec3 rotation_vector(const Quaternion& turn);

//! [moving_body]
/// A rigid body within a step, as a method moves it. What stands still or moves as given has no inverse mass,
/// and its pose is the world's; so has a soft body, whose nodes move.
struct MovingBody {
    bool moves = false;
    bool is_soft = false;
    double inverse_mass = 0;               ///< [1/kg]
    Mat3 inertia_in_body = Mat3::Zero();   ///< along the body's axes [kg m^2]
    Mat3 inverse_in_body = Mat3::Zero();   ///< its inverse
    Vec3 gravity = Vec3::Zero();           ///< [m/s^2]
    double size = 1;                       ///< [m]
    Pose start, pose;                      ///< when the step begins, and now
    Vec3 velocity = Vec3::Zero();          ///< before gravity acts in this step [m/s]
    Vec3 angular_velocity = Vec3::Zero();  ///< [rad/s]

    Mat3 inverse_inertia() const { return turned(inverse_in_body); }
    Mat3 inertia() const { return turned(inertia_in_body); }
    /// Gravity over h [s].
    void fall(double h) { velocity += h * gravity; }
    /// Along and about its velocities over h [s], by the exponential map.
    void move(double h);
    /// An impulse [N s] at r from the centre [m].
    void push(const Vec3& impulse, const Vec3& r);

private:
    Mat3 turned(const Mat3& in_body) const;
};
//! [moving_body]

//! [soft_body]
/// A node of a soft body within a step. Its mass is the row sum of the mass matrix, as in the papers.
struct SoftNode {
    double inverse_mass = 0;       ///< [1/kg]; 0 where it is fixed
    Vec3 gravity = Vec3::Zero();   ///< [m/s^2]
    Vec3 start, place;             ///< when the step begins, and now [m]
    Vec3 velocity = Vec3::Zero();  ///< before gravity and elements act in this step [m/s]
};

/// A soft body of linear tetrahedra within a step: its nodes lie behind one another in MethodStep::nodes.
struct SoftBody {
    const DeformableBody* of = nullptr;
    std::size_t body = 0;   ///< its place in MethodStep::bodies
    std::size_t first = 0;  ///< its node 0 there
};
//! [soft_body]

//! [contact_point]
/// A pair as the methods see it: a point of A, a point of B, and a normal that stays for the step.
struct ContactPoint {
    int a = -1, b = -1;  ///< places in MethodStep::bodies
    Vec3 on_a, on_b;     ///< in body coordinates [m]
    Vec3 given =
        Vec3::Zero();  ///< velocity of A against B that is given: what is driven, surfaces that run [m/s]
    Vec3 normal, tangent_1, tangent_2;  ///< unit length; the normal out of B
    double separation = 0;              ///< n . (p - q) when the step begins [m], negative inside
    double mu_s = 0, mu_d = 0;
    double restitution = 0;
    Vec3 impulse = Vec3::Zero();  ///< on A [N s]: first that of the last step, in the end that of this one
    PairKey key;
    std::array<int, 4> vertices{-1, -1, -1, -1};  ///< of both features, as Contact has them
    std::array<Vec3, 4>
        corners;  ///< the same in body coordinates, of the surfaces that a search for contact sees [m]
    std::array<double, 4> weights{};           ///< of the vertices: p - q is their sum, but for a plane's q
    std::array<int, 4> nodes{-1, -1, -1, -1};  ///< of vertices of soft bodies, in MethodStep::nodes; else -1

    ContactKind kind() const { return std::get<0>(key); }
    int corners_of_a() const { return kind() == ContactKind::edge_edge ? 2 : 1; }
    int corner_count() const { return on_plane() ? 1 : 4; }
    bool on_plane() const { return kind() == ContactKind::vertex_plane; }
};
//! [contact_point]

/// All that a method of this chapter gets, and all that it changes.
struct MethodStep {
    double dt = 0;                   ///< [s]
    std::vector<MovingBody> bodies;  ///< those of the world, and the ground behind them
    std::vector<SoftNode> nodes;     ///< of all soft bodies
    std::vector<SoftBody> soft;
    std::vector<ContactPoint> points;
    bool is_solved = true;  ///< unless a method that has a tolerance says that it has not come so far
    double given = 0;       ///< energy that a method's own potential has given to the bodies in this step [J]

    MovingBody& a(const ContactPoint& p) { return bodies[static_cast<std::size_t>(p.a)]; }
    MovingBody& b(const ContactPoint& p) { return bodies[static_cast<std::size_t>(p.b)]; }
    const MovingBody& a(const ContactPoint& p) const { return bodies[static_cast<std::size_t>(p.a)]; }
    const MovingBody& b(const ContactPoint& p) const { return bodies[static_cast<std::size_t>(p.b)]; }
    /// From the centres to the points now [m]; zero on a soft body.
    Vec3 lever_a(const ContactPoint& p) const { return a(p).pose.orientation * p.on_a; }
    Vec3 lever_b(const ContactPoint& p) const { return b(p).pose.orientation * p.on_b; }
    /// p - q now; `elapsed` [s] tells where given motion has come to [m].
    Vec3 difference(const ContactPoint& p, double elapsed) const;
    /// Velocity of p against q now [m/s].
    Vec3 relative_velocity(const ContactPoint& p) const;
    /// An impulse on A at p, and its opposite on B at q [N s].
    void push(const ContactPoint& p, const Vec3& impulse);
    /// Velocity along a direction per impulse along it [1/kg]; 0 where nothing moves.
    double response(const ContactPoint& p, const Vec3& direction) const;

    /// Calls visit(node, weight) for the nodes of soft bodies that a pair moves.
    template <class Visit>
    void each_node(const ContactPoint& p, Visit&& visit)
    {
        for (std::size_t i = 0; i < 4; ++i)
            if (p.nodes[i] >= 0)
                visit(nodes[static_cast<std::size_t>(p.nodes[i])], p.weights[i]);
    }
    template <class Visit>
    void each_node(const ContactPoint& p, Visit&& visit) const
    {
        for (std::size_t i = 0; i < 4; ++i)
            if (p.nodes[i] >= 0)
                visit(nodes[static_cast<std::size_t>(p.nodes[i])], p.weights[i]);
    }
};

}  // namespace enduring
