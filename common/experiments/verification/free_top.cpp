#include "common/experiments/verification/free_top.hpp"

#include "common/rigid/rigid_motion.hpp"

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

const Vec3 sides(0.4, 0.2, 0.1);        // [m]
const Vec3 first_spin(0.05, 5.0, 0.0);  // [rad/s]; y is the middle axis

/// Moments of a box of 1 kg about its axes of symmetry.
Vec3 box_moments()
{
    const Vec3 squared = sides.cwiseAbs2();
    return Vec3(squared.y() + squared.z(), squared.z() + squared.x(), squared.x() + squared.y()) / 12;
}

/// Follows the largest departure from what it saw first.
class DriftMeter {
public:
    void see(double energy, const Vec3& momentum)
    {
        if (!started_) {
            started_ = true;
            first_energy_ = energy;
            first_momentum_ = momentum;
        }
        drift_.energy = std::max(drift_.energy, std::abs(energy - first_energy_) / first_energy_);
        drift_.momentum = std::max(drift_.momentum,
                                   (momentum - first_momentum_).norm() / first_momentum_.norm());
    }
    const TopDrift& drift() const { return drift_; }

private:
    bool started_ = false;
    double first_energy_ = 0;
    Vec3 first_momentum_ = Vec3::Zero();
    TopDrift drift_;
};

TopDrift drift_of_ours(int steps, double dt)
{
    MassProperties box;
    box.mass = 1;
    box.inertia = box_moments().asDiagonal();
    RigidMotion top(box, Vec3::Zero(), first_spin);
    const Quaternion first_orientation = top.pose().orientation;

    DriftMeter meter;
    for (int step = 0; step <= steps; ++step) {
        // Both from the pose and the angular velocity alone, not from the momentum that the motion keeps.
        const Quaternion turned = top.pose().orientation * first_orientation.conjugate();
        const Vec3 spin = turned.conjugate() * top.angular_velocity();
        const Vec3 momentum = box_moments().cwiseProduct(spin);
        meter.see(0.5 * spin.dot(momentum), turned * momentum);
        top.predict(Vec3::Zero(), dt);
        top.commit(dt);
    }
    return meter.drift();
}

//! [bullet_step]
/// What Bullet's world adds to the angular velocity for the gyroscopic term, by the body's flag.
btVector3 gyroscopic_change(const btRigidBody& body, TopMethod method, double dt)
{
    switch (method) {
        case TopMethod::bullet_explicit:
            return body.getInvInertiaTensorWorld() * body.computeGyroscopicForceExplicit(1e30) * -dt;
        case TopMethod::bullet_implicit_world: return body.computeGyroscopicImpulseImplicit_World(dt);
        case TopMethod::bullet_implicit_body: return body.computeGyroscopicImpulseImplicit_Body(dt);
        default: return {0, 0, 0};
    }
}
//! [bullet_step]

TopDrift drift_of_bullet(TopMethod method, int steps, double dt)
{
    const Vec3 moments = box_moments();
    const btVector3 inertia(moments.x(), moments.y(), moments.z());
    btRigidBody body(btRigidBody::btRigidBodyConstructionInfo(1.0, nullptr, nullptr, inertia));
    body.setAngularVelocity({first_spin.x(), first_spin.y(), first_spin.z()});

    DriftMeter meter;
    for (int step = 0; step <= steps; ++step) {
        const btMatrix3x3& turned = body.getWorldTransform().getBasis();
        const btVector3 spin = body.getAngularVelocity() * turned;  // row times matrix: into body axes
        const btVector3 momentum = turned * (inertia * spin);
        meter.see(0.5 * spin.dot(inertia * spin), Vec3(momentum.x(), momentum.y(), momentum.z()));

        body.setAngularVelocity(body.getAngularVelocity() + gyroscopic_change(body, method, dt));
        btTransform next;
        body.predictIntegratedTransform(dt, next);
        body.proceedToTransform(next);
    }
    return meter.drift();
}

}  // namespace

const std::vector<TopMethod>& all_top_methods()
{
    static const std::vector<TopMethod> methods{TopMethod::bullet_kept, TopMethod::bullet_explicit,
                                                TopMethod::bullet_implicit_world,
                                                TopMethod::bullet_implicit_body, TopMethod::ours};
    return methods;
}

std::string name_of(TopMethod method)
{
    switch (method) {
        case TopMethod::bullet_kept: return "Bullet, velocity kept";
        case TopMethod::bullet_explicit: return "Bullet, explicit";
        case TopMethod::bullet_implicit_world: return "Bullet, implicit in the world";
        case TopMethod::bullet_implicit_body: return "Bullet, implicit in the body";
        case TopMethod::ours: return "Simo and Wong (ours)";
    }
    return {};
}

TopDrift top_drift(TopMethod method, double seconds, double rate)
{
    const int steps = static_cast<int>(std::lround(seconds * rate));
    return method == TopMethod::ours ? drift_of_ours(steps, 1 / rate)
                                     : drift_of_bullet(method, steps, 1 / rate);
}

Table top_drift_table()
{
    Table table({"method", "rate_hz", "energy_drift", "momentum_drift"});
    for (const TopMethod method : all_top_methods())
        for (const long rate : {60L, 240L, 960L}) {
            const TopDrift drift = top_drift(method, 10, static_cast<double>(rate));
            table.add({name_of(method), rate, drift.energy, drift.momentum});
        }
    return table;
}

void report_top_drift(Report& report)
{
    const Table table = top_drift_table();
    report.table("top_drift", table);
    report.page_table("top_drift", table, 2);
    const TopDrift bullet = top_drift(TopMethod::bullet_implicit_body, 10, 240),
                   ours = top_drift(TopMethod::ours, 10, 240);
    report.fact("rigid", "bullet_energy_percent", 100 * bullet.energy, 2);
    report.fact("rigid", "bullet_momentum_percent", 100 * bullet.momentum, 2);
    report.fact("rigid", "our_energy", ours.energy, 1);
    report.fact("rigid", "our_momentum", ours.momentum, 1);
}

}  // namespace enduring
