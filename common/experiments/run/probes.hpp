#pragma once

#include "common/experiments/report/report.hpp"
#include "common/simulation/step.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace enduring {

/// Watches a run: sees the world once before the first step and once after every step.
class Probe {
public:
    virtual ~Probe() = default;
    /// @param contacts  those alive after the step, with the impulses they gave in it
    virtual void observe(const World& world, const Contacts& contacts, double dt) = 0;
};

/// A probe whose notes are one table, a row each time it looks.
class TableProbe : public Probe {
public:
    const Table& table() const { return table_; }

protected:
    explicit TableProbe(std::vector<std::string> columns) : table_(std::move(columns)) {}
    Table table_;
};

/// Any function as a probe: for pictures, or for one number that only one experiment wants.
class WatchProbe final : public Probe {
public:
    using Watch = std::function<void(const World&, const Contacts&, double dt)>;
    explicit WatchProbe(Watch watch) : watch_(std::move(watch)) {}
    void observe(const World& world, const Contacts& contacts, double dt) override
    {
        watch_(world, contacts, dt);
    }

private:
    Watch watch_;
};

/// time_s, kinetic_j, gravitational_j, elastic_j, total_j: summed over all bodies.
class EnergyProbe final : public TableProbe {
public:
    EnergyProbe();
    void observe(const World& world, const Contacts& contacts, double dt) override;
};

/// time_s, px, py, pz [kg m/s], lx, ly, lz [kg m^2/s] about the origin: summed over all bodies.
class MomentumProbe final : public TableProbe {
public:
    MomentumProbe();
    void observe(const World& world, const Contacts& contacts, double dt) override;
};

/// How deep the contacts are at the end of the step, and how stiff they are together.
///
/// time_s, pairs (alive), pairs_inside (their depth is negative, and they are springs: neither held nor
/// resolved in this step), depth_sum_m and depth_max_m (of those, planes counted, as positive lengths),
/// nk_n_per_m, stable_step_s, dt_s, plane_depth_m (deepest vertex in a plane). Three of them compare the step
/// with a particle's bound: n pairs between two bodies act as one spring of stiffness n k on their reduced
/// mass m, whose explicit step is stable up to sqrt(2 m / (n k)). The row holds the largest n k and the
/// smallest bound over all pairs of bodies (0 without contact).
class PenetrationProbe final : public TableProbe {
public:
    /// @param stiffness  k of one pair [N/m]; that of a plane with its own is read from the plane
    explicit PenetrationProbe(double stiffness);
    void observe(const World& world, const Contacts& contacts, double dt) override;

private:
    double stiffness_;
};

/// Mean contact force over the step that one body receives from another body or a plane.
///
/// time_s, fx_n, fy_n, fz_n, pairs. Counts the contacts that are alive after the step.
class ForceProbe final : public TableProbe {
public:
    /// @param on, from  names; observe() throws InputError if the world has no such body or plane
    ForceProbe(std::string on, std::string from);
    void observe(const World& world, const Contacts& contacts, double dt) override;

private:
    std::string on_, from_;
};

/// time_s, x, y, z [m], vx, vy, vz [m/s] of the centre of mass of one moving body.
class MotionProbe final : public TableProbe {
public:
    explicit MotionProbe(std::string body);
    void observe(const World& world, const Contacts& contacts, double dt) override;

private:
    std::string body_;
};

/// The body of this name.
/// @throws InputError  there is none; lists those there are
const Body& body_named(const World& world, std::string_view name);

}  // namespace enduring
