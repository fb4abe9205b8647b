#pragma once

#include "common/simulation/body.hpp"

namespace enduring {

/// The simplest body that moves: point masses that share a surface but no forces. Its step can be followed by
/// hand, which is what the worked step and the tests want.
class PointMasses final : public Body {
public:
    /// @param positions     one point a surface vertex [m]
    /// @param mass_of_each  [kg], positive
    /// @param velocity      of all of them [m/s]
    PointMasses(std::string name, std::vector<Vec3> positions, std::vector<Face> faces, double mass_of_each,
                const Vec3& velocity = Vec3::Zero());

    void set_velocity(int vertex, const Vec3& velocity) { velocities_[vertex] = velocity; }

    void predict(const Vec3& gravity, double dt) override;
    void update_prediction(double dt) override;
    void commit(double dt) override;

    void apply_impulse(int vertex, const Vec3& impulse) override { velocities_[vertex] += impulse / mass_; }
    Vec3 velocity(int vertex) const override { return velocities_[vertex]; }
    Mat3 inverse_mass(int) const override { return Mat3::Identity() / mass_; }

    std::unique_ptr<Trial> begin_trial() const override;
    const MassParts& mass_parts() const override { return parts_; }

    double mass() const override { return mass_ * static_cast<double>(velocities_.size()); }
    Energy energy(const Vec3& gravity) const override;
    Vec3 linear_momentum() const override;
    Vec3 angular_momentum(const Vec3& about) const override;

private:
    /// Each point is a part of its own.
    class EachAlone final : public MassParts {
    public:
        explicit EachAlone(std::size_t points);
        int count() const override { return static_cast<int>(numbers_.size()); }
        std::span<const int> moved_by(int vertex) const override
        {
            return std::span(numbers_).subspan(static_cast<std::size_t>(vertex), 1);
        }

    private:
        std::vector<int> numbers_;  ///< 0, 1, 2 ...
    };

    double mass_;
    std::vector<Vec3> velocities_;
    EachAlone parts_;
};

}  // namespace enduring
