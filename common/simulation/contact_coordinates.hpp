#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <span>

namespace enduring {

/// Mass matrix A of a body's coordinates in contact, and how they answer: an impulse P on them changes them
/// by A^-1 P. Who asks needs both, and each body knows one of them best.
struct ContactMass {
    Eigen::MatrixXd mass;      ///< A
    Eigen::MatrixXd response;  ///< A^-1
};

/// How a surface vertex moves with its body's coordinates in contact: its
/// velocity is `rate` times those from `first` on.
struct VertexMotion {
    int first = 0;
    Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 6> rate{3, 0};
};

/// The velocities of a body that contact can change, as a few coordinates. A rigid body's are the velocity of
/// its centre and its angular velocity; what does not move has none, as here.
///
/// They belong to `touched`, the vertices in contact, each once.
class ContactCoordinates {
public:
    ContactCoordinates() = default;
    virtual ~ContactCoordinates() = default;
    ContactCoordinates(const ContactCoordinates&) = delete;
    ContactCoordinates& operator=(const ContactCoordinates&) = delete;

    virtual ContactMass contact_mass(std::span<const int> /*touched*/) const { return {}; }
    /// How touched[index] moves with them. The last argument is the moment
    /// of the step whose lever counts, in [0, 1].
    virtual VertexMotion contact_motion(std::span<const int> /*touched*/, std::size_t /*index*/,
                                        double /*tau*/) const
    {
        return {};
    }
    /// Where the predicted end of the step is turned by more than `least_turn` [rad] from the one whose
    /// levers contact_motion() takes, it takes those of the predicted end from now on. Impulses that act keep
    /// the levers with which they were applied.
    /// @return  whether it did; never for a body whose vertices move for themselves
    virtual bool follow_levers(double /*least_turn*/, double /*dt*/) { return false; }
    /// Adds an impulse on the coordinates to the predicted velocities, as Body::apply_impulse() does.
    virtual void apply_contact_impulse(std::span<const int> /*touched*/, const Eigen::VectorXd& /*impulse*/)
    {}
    /// Their values in the state.
    virtual Eigen::VectorXd contact_velocity(std::span<const int> /*touched*/) const { return {}; }
};

}  // namespace enduring
