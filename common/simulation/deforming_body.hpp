#pragma once

#include "common/simulation/body.hpp"
#include "common/simulation/given_motion.hpp"

namespace enduring {

/// A surface whose shape changes as given, whatever pushes it: a hand that closes, a membrane that swings. It
/// takes impulses as a static body does. Pairs feel its velocity by where its vertices are at both ends of
/// the step.
class DeformingBody final : public Body {
public:
    /// Where its vertices are at one time.
    struct Shape {
        double time;                 ///< [s]
        std::vector<Vec3> vertices;  ///< in the world [m]
    };

    /// Each coordinate of a vertex is a cubic between two shapes, as in the table of a given motion
    /// (GivenMotion::through): it stays between the values of both, and the velocity is continuous. Before
    /// the first shape and after the last one the body rests.
    /// @param shapes  two or more, with times that ascend and one position for each vertex of `surface`
    /// @param time    at which it begins [s]
    /// @throws std::invalid_argument  other shapes
    DeformingBody(std::string name, SurfaceTopology surface, std::vector<Shape> shapes, double time = 0);

    void predict(const Vec3& gravity, double dt) override;
    void update_prediction(double dt) override;
    void commit(double dt) override;

    void apply_impulse(int, const Vec3&) override {}
    /// At the start of the step.
    Vec3 velocity(int vertex) const override { return at(time_, static_cast<std::size_t>(vertex)).slope; }
    Mat3 inverse_mass(int) const override { return Mat3::Zero(); }

    bool is_driven() const override { return true; }
    bool is_static() const override { return true; }
    double mass() const override { return 0; }
    Energy energy(const Vec3&) const override { return {}; }
    Vec3 linear_momentum() const override { return Vec3::Zero(); }
    Vec3 angular_momentum(const Vec3&) const override { return Vec3::Zero(); }

private:
    ValueAndSlope at(double time, std::size_t vertex) const;
    Vec3 slope_at(std::size_t shape, std::size_t vertex) const;
    void place(double time, std::vector<Vec3>& positions) const;

    std::vector<Shape> shapes_;
};

}  // namespace enduring
