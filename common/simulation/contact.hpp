#pragma once

#include "common/geometry/vector.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace enduring {

enum class ContactKind : std::uint8_t { vertex_plane, vertex_face, edge_edge };

/// Whether a pair waits for its impulse of this step, has received it,
/// or takes none while it stays in the list.
enum class ContactState : std::uint8_t { waiting, answered, held };

/// Whether a pair pushes its bodies apart or along each other.
enum class ContactCategory : std::uint8_t { unknown, regular, hooked };

/// What a pair hands on to the next step: the spring along its normal, and that of its friction.
struct PairMemory {
    Vec3 stretch = Vec3::Zero();  ///< from the point where friction holds p to p, along the surface [m]
    double slip = 0;              ///< speed at which friction lets go in this step [m/s], 0 while it holds
    double stiffness = 0;         ///< k of a pair that is given its own [N/m]; 0 before that
    double rest_offset = 0;       ///< depth at which the spring of such a pair pushes nothing [m]
    double load = 0;              ///< normal force that such a pair carried at the end of the last step [N]
};

/// One pair of features in contact: a point p of body A and a point q of
/// body B, each a fixed combination of vertices.
///
/// Whatever the kind, p - q = sum_i weights[i] x[vertices[i]], and an
/// impulse I on p reaches vertex i as weights[i] I.
///   vertex_plane  vertices {v, -, -, -}          weights {1, 0, 0, 0}, and q is the foot on the plane
///   vertex_face   vertices {v, f0, f1, f2}       weights {1, -w0, -w1, -w2}; normal (f1-f0) x (f2-f0)
///   edge_edge     vertices {a0, a1, b0, b1}      weights {1-s, s, -(1-t), -t};
///                                                normal orientation * (a1-a0) x (b1-b0)
/// The normal points out of B, towards A; depth is n . (p - q) - gap, negative inside.
struct Contact {
    ContactKind kind = ContactKind::vertex_face;
    /// indices into World::bodies; for a plane body_b indexes World::planes
    int body_a = -1, body_b = -1;
    int feature_a = -1, feature_b = -1;  ///< vertex and face, or the two edges; feature_b is -1 for a plane
    std::array<int, 4> vertices{-1, -1, -1, -1};
    std::array<double, 4> weights{};
    double orientation = 1;  ///< edge_edge: the sign that made the normal point from B to A at first contact
    /// part of the step from which the pair pushes: its time of impact, 0 when it endures
    double start = 0;
    Vec3 impulse = Vec3::Zero();  ///< along the normal, on A in this step [N s]; kept for probes and pictures

    Vec3 friction = Vec3::Zero();  ///< friction impulse on A in this step [N s]
    Vec3 turning = Vec3::Zero();   ///< against rolling and spinning, on A in this step [N m s]
    PairMemory spring{};           ///< what the next step takes over
    double outward = 1;            ///< part of the way out of the other body that lies along its normal
    /// normal of the path on which the pair's vertex came along a surface that bends in this step; zero where
    /// it did not
    Vec3 sliding_normal = Vec3::Zero();
    /// from q to p at the start of the step, unit length, which turns with the features; zero where these
    /// tell the normal
    Vec3 normal_t0 = Vec3::Zero();
    double gap = 0;  ///< distance below which it counts as inside [m]
    ContactCategory category = ContactCategory::unknown;
    ContactState state = ContactState::waiting;
    /// separated in this step, whatever its state: seen by the probes, gone with the next
    bool resolved = false;
    /// found when springs are remembered: apart or just touched when this step began, without a load on its
    /// spring. Such pairs may bounce
    bool began_open = false;

    bool waiting() const { return state == ContactState::waiting && !resolved; }
    bool answered() const { return state == ContactState::answered; }
    bool held() const { return state == ContactState::held; }
    /// Held, or else (again) waiting for its impulse.
    void hold(bool yes) { state = yes ? ContactState::held : ContactState::waiting; }
    /// Its depth, where it is negative, is that of a spring: a held pair pushes nothing, and a resolved one
    /// has left by another face.
    bool is_spring() const { return !held() && !resolved; }
    /// Inside since an earlier step; so is one that enters at the very start of this one.
    bool endures() const { return start == 0; }

    /// How many of `vertices` belong to A (the others belong to B).
    int vertices_of_a() const { return kind == ContactKind::edge_edge ? 2 : 1; }
    int vertex_count() const { return on_plane() ? 1 : 4; }
    /// Whether B is a plane, and no body.
    bool on_plane() const { return kind == ContactKind::vertex_plane; }
};

using Contacts = std::vector<Contact>;

}  // namespace enduring
