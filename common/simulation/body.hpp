#pragma once

#include "common/geometry/surface_size.hpp"
#include "common/geometry/surface_topology.hpp"
#include "common/geometry/vector.hpp"
#include "common/simulation/contact_coordinates.hpp"
#include "common/simulation/inner_forces.hpp"
#include "common/simulation/mass_parts.hpp"
#include "common/simulation/material_friction.hpp"
#include "common/simulation/state_archive.hpp"
#include "common/simulation/trial.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace enduring {

/// What a body carries besides its surface; the sum over all bodies tells whether contact adds energy.
struct Energy {
    /// [J]; the gravitational part is zero at the origin
    double kinetic = 0, gravitational = 0, elastic = 0;
    double total() const { return kinetic + gravitational + elastic; }
};

/// The one face that static, rigid and deformable bodies show to the contact code: surface vertices that move
/// along straight lines during the step, have a mass at that point, and can be pushed.
///
/// The order within one step (thesis 3.3):
///   predict(g, dt)             new velocities from the body's own dynamics; positions_t1 follow
///   apply_impulse(v, I) ...    changes the predicted velocities only: positions_t1 stay, so that
///                              all impulses of one pass come from one prediction
///   update_prediction(dt)      positions_t1 from the changed velocities
///   commit()                   velocities, then positions: positions_t1 become positions_t0
class Body {
public:
    Body(std::string name, SurfaceTopology surface) : name_(std::move(name)), surface_(std::move(surface)) {}
    virtual ~Body() = default;
    Body(const Body&) = delete;
    Body& operator=(const Body&) = delete;

    const std::string& name() const { return name_; }
    const SurfaceTopology& surface() const { return surface_; }

    /// Surface vertices at the start of the step and at its predicted end [m]. For a
    /// rigid body the end is the pose that committing would produce, so positions_t1 -
    /// positions_t0 is not exactly dt times a velocity.
    std::span<const Vec3> positions_t0() const { return positions_t0_; }
    std::span<const Vec3> positions_t1() const { return positions_t1_; }
    /// Where a surface vertex is at tau in [0, 1] of the step [m].
    Vec3 position(int vertex, double tau) const
    {
        const auto i = static_cast<std::size_t>(vertex);
        return lerp(positions_t0_[i], positions_t1_[i], tau);
    }
    /// The same of the surface that a search for contact sees: its own, or the one that it took for this.
    /// Springs act on its own.
    std::span<const Vec3> contact_t0() const { return contact_t0_.empty() ? positions_t0_ : contact_t0_; }
    std::span<const Vec3> contact_t1() const { return contact_t1_.empty() ? positions_t1_ : contact_t1_; }
    /// Where a vertex of that surface is at tau in [0, 1] of the step [m].
    Vec3 contact_point(int vertex, double tau) const
    {
        const auto i = static_cast<std::size_t>(vertex);
        return lerp(contact_t0()[i], contact_t1()[i], tau);
    }
    /// The mean of the surface vertices at the start of the step [m]; not the centre of mass.
    Vec3 centre() const;
    /// As it was made, however it bends since (see surface_size()) [m].
    double size() const { return size_; }

    /// The time of the committed state [s], from which what is given as a function of time is taken; the step
    /// tells it before it predicts.
    void set_time(double time) { time_ = time; }
    double time() const { return time_; }

    /// New velocities from gravity [m/s^2], inner forces, damping and forces from outside over dt [s]; then
    /// positions_t1.
    virtual void predict(const Vec3& gravity, double dt) = 0;
    /// Positions_t1 from the present predicted velocities.
    virtual void update_prediction(double dt) = 0;
    /// The prediction becomes the state.
    virtual void commit(double dt) = 0;

    /// Adds an impulse [N s] at a surface vertex to the predicted velocities; a deformable body that answers
    /// implicitly collects impulses and lets them act at the next update_prediction().
    virtual void apply_impulse(int vertex, const Vec3& impulse) = 0;
    /// Predicted velocity of a surface vertex [m/s].
    virtual Vec3 velocity(int vertex) const = 0;
    /// How fast it turns as a whole [rad/s]: its vertices leave their straight lines by this. Zero for a body
    /// whose vertices move for themselves.
    virtual double turning_speed() const { return 0; }
    /// Velocity change at a surface vertex per impulse there [1/kg]; zero for what does not move.
    virtual Mat3 inverse_mass(int vertex) const = 0;

    /// To try impulses out before any is applied.
    virtual std::unique_ptr<Trial> begin_trial() const;
    /// Which pairs share this body's mass.
    virtual const MassParts& mass_parts() const;

    /// For a solver that treats all bodies as one: the velocities that contact can change. What does not move
    /// has none.
    virtual ContactCoordinates& contact_coordinates();
    /// After a step of dt [s] is committed, adds an impulse on the coordinates to the velocities; nothing
    /// moves.
    void kick(std::span<const int> touched, const Eigen::VectorXd& impulse, double dt)
    {
        contact_coordinates().apply_contact_impulse(touched, impulse);
        update_prediction(dt);
        stand_still();
    }

    /// The step ends for its vertices where it began; velocities stay.
    void stand_still()
    {
        positions_t1_ = positions_t0_;
        contact_t1_ = contact_t0_;
    }

    /// What its own elements do within the step; a rigid body has none.
    virtual InnerForces& inner_forces();
    /// What presses it beside its weight: forces from outside, torques at the arm of its size, and its own
    /// elements [N].
    virtual double pressing_force(double /*dt*/) const { return 0; }

    /// The work of forces from outside but gravity in the step as it is predicted [J].
    virtual double driven_work(double /*dt*/) const { return 0; }
    /// The work of gravity in the step as it is predicted, less that at the velocities: of a body that turns
    /// about a pin off its centre, the lever of gravity turns within the step, and this is what the turn
    /// gives [J].
    virtual double turned_lever_work(const Vec3& /*gravity*/, double /*dt*/) const { return 0; }
    /// What gravity alone makes of the motion of a surface vertex: nothing where a body stands or moves as
    /// given, and another acceleration than its own where it is held [m/s^2].
    virtual Vec3 acceleration(int /*vertex*/, const Vec3& gravity) const
    {
        return is_static() ? Vec3(Vec3::Zero()) : gravity_on(gravity);
    }
    /// Its surface vertices in coordinates that move with it, where it has such: of a rigid body its own, of
    /// a driven one those of its place without the motion; else those of the world [m].
    virtual std::span<const Vec3> shape() const { return positions_t0_; }
    /// From now on a search for contact sees another surface with the same faces. For bodies that keep their
    /// shape.
    /// @param shape  in the coordinates of shape() [m]
    virtual void take_contact_surface(const std::vector<Vec3>& shape) { contact_t0_ = contact_t1_ = shape; }
    /// Writes or reads all that the next step depends on. It is asked between steps: what was predicted is
    /// not kept.
    virtual void visit_state(StateArchive& archive) { archive(positions_t0_); }

    /// Gravity does nothing to a rigid or soft body from now on.
    void switch_gravity_off() { has_weight_ = false; }
    /// What there is for this body of the world's [m/s^2].
    Vec3 gravity_on(const Vec3& gravity) const { return has_weight_ ? gravity : Vec3(Vec3::Zero()); }
    /// By its place among the scene's materials, or MaterialFriction::none.
    void set_material(int material) { material_ = material; }
    int material() const { return material_; }
    /// Of its whole surface; a soft body, whose parts turn against each other, has none.
    void set_grain(const Grain& grain) { grain_ = grain; }
    const Grain& grain() const { return grain_; }
    /// How its surface runs though the body stands, as a conveyor's belt does [m/s]; what is along the normal
    /// of a pair has no effect. For those solvers that read it.
    void set_surface_velocity(const Vec3& velocity) { surface_velocity_ = velocity; }
    const Vec3& surface_velocity() const { return surface_velocity_; }

    /// Whether anything drives it that a body's start does not tell: given motion, a surface that runs,
    /// forces, held directions, gravity that is off. Who takes bodies over into another engine asks.
    virtual bool is_driven() const { return !has_weight_ || !surface_velocity_.isZero(0); }
    virtual bool is_static() const { return false; }
    virtual double mass() const = 0;                       ///< [kg]; 0 for a static body
    virtual Energy energy(const Vec3& gravity) const = 0;  ///< of the committed state
    virtual Vec3 linear_momentum() const = 0;              ///< [kg m/s]
    /// Of the centre of mass [m/s]; zero for a static body.
    Vec3 mean_velocity() const { return mass() > 0 ? Vec3(linear_momentum() / mass()) : Vec3(Vec3::Zero()); }
    virtual Vec3 angular_momentum(const Vec3& about) const = 0;  ///< [kg m^2/s]
    virtual int inverted_elements() const { return 0; }

protected:
    /// To be called by who makes a body, when its first positions are known.
    void measure() { size_ = surface_size(surface_, positions_t0_); }

    std::vector<Vec3> positions_t0_, positions_t1_;
    std::vector<Vec3> contact_t0_, contact_t1_;  ///< empty where contact sees the body's own surface
    double time_ = 0;                            ///< committed [s]

private:
    std::string name_;
    SurfaceTopology surface_;
    double size_ = 0;
    bool has_weight_ = true;
    int material_ = MaterialFriction::none;
    Grain grain_;
    Vec3 surface_velocity_ = Vec3::Zero();
};

/// What visit_state() writes, and the same read back.
std::vector<double> state_of(Body& body);
void restore_state(Body& body, const std::vector<double>& numbers);

}  // namespace enduring
