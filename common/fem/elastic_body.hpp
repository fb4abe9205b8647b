#pragma once

#include "common/fem/corotated_elasticity.hpp"
#include "common/fem/implicit_solver.hpp"
#include "common/fem/mass_matrix.hpp"
#include "common/fem/whole_turn.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace enduring {

struct ElasticOptions {
    /// Linear elasticity about the placed shape, for small rotations and for proofs; otherwise every
    /// element's rotation is found once a step, at its start. Of the corotated law only.
    bool freeze_rotations = false;
    double solver_tolerance = 1e-10;  ///< relative error of the velocities in the norm of the system's matrix
    LinearSolverKind linear_solver = LinearSolverKind::supernodal;
};

/// A deformable body: a mass that is spread over elements as their basis says, held together by their
/// corotated stiffness. It knows nothing of surfaces or contact.
///
/// One step is predict (new velocities, positions unchanged), then whatever changes velocities(), then
/// commit. Positions and velocities may be written at any time in between. The hidden state is the rotations
/// of the last prediction, and what the last solves changed, from which the next ones start: it decides how
/// long they take, and their result only within the tolerance.
class ElasticBody {
public:
    /// @throws InputError  a material constant outside its range; rotations that another law cannot freeze
    ElasticBody(ElasticMesh mesh, const ElasticMaterial& material, const ElasticOptions& options = {});
    ElasticBody(const ElasticBody&) = delete;
    ElasticBody& operator=(const ElasticBody&) = delete;

    const ElasticMesh& mesh() const { return mesh_; }
    const ElasticMaterial& material() const { return material_; }
    int node_count() const { return mesh_.node_count(); }

    NodalVectors& positions() { return positions_; }  ///< [m], one a node (control point)
    const NodalVectors& positions() const { return positions_; }
    NodalVectors& velocities() { return velocities_; }  ///< [m/s]
    const NodalVectors& velocities() const { return velocities_; }
    /// [N], besides gravity; stay until changed
    NodalVectors& external_forces() { return external_forces_; }
    const NodalVectors& external_forces() const { return external_forces_; }

    /// Turns about the origin, then moves; velocities turn along. Rotations start from the placed shape.
    void place(const Mat3& rotation, const Vec3& translation);
    /// The node stays where it is from now on.
    /// @throws InputError  no such node
    void fix(int node);
    /// What was fixed is free from now on, with the position and velocity that it has.
    void release(int node);

    const Eigen::SparseMatrix<double>& mass_matrix() const { return mass_matrix_; }  ///< M [kg], of all nodes
    /// row sums of M [kg], all positive
    const Eigen::VectorXd& masses() const { return masses_; }
    /// of those [1/kg], zero for fixed nodes
    const Eigen::VectorXd& inverse_masses() const { return inverse_masses_; }

    /// New velocities by implicit Euler, linearised about the start of the step:
    ///   (M + dt C + dt^2 K_R) v_new = M v + dt (f_ext + M g + f_el(x)),  C = alpha M + beta K_R.
    /// A law at points has its own stiffness in place of K_R; of a body without fixed nodes, without what it
    /// holds against turning as a whole, so that angular momentum is kept.
    /// Where this would gain energy, Newton's method goes on to the forces at the end of the step.
    /// @param gravity  [m/s^2]
    /// @param dt       [s]
    /// @throws InputError  dt is not positive and finite
    void predict(const Vec3& gravity, double dt);
    /// Impulses [N s] on the nodes that act during the step: the velocities change by what the
    /// system of the last predict gives for them, so that the elements pass them on to their
    /// neighbours within the step. Call after predict(.., dt).
    void respond(const NodalVectors& impulses, double dt);
    /// The same where a step gives impulses again and again, each time to mend those before: an error that is
    /// small for all of them together is small enough, so the last ones cost little.
    void mend_response(const NodalVectors& impulses, double dt);
    /// What respond() would add to the velocities, up to what the elements have turned against each other
    /// since the system was last factored: one pass through that factor. Zero before the first predict().
    NodalVectors near_response(const NodalVectors& impulses) const
    {
        return solver_.nearly_solved(fixed_, impulses, turn());
    }
    /// The same for each of these, in place and in one passage through the factor.
    void near_responses(std::span<NodalVectors> impulses) const
    {
        solver_.nearly_solve(fixed_, impulses, turn());
    }
    /// positions += dt velocities.
    void commit(double dt);

    /// Elastic forces on the nodes at the present positions [N].
    NodalVectors elastic_forces() const;
    double mass() const { return masses_.sum(); }
    /// What each node has of the linear momentum, M v [kg m/s].
    NodalVectors momenta() const { return velocities_ * mass_matrix_; }
    double kinetic_energy() const;  ///< [J]
    /// With the rotations that fit the present positions (or the frozen ones) [J].
    double elastic_energy() const;
    Vec3 centre_of_mass() const;
    Vec3 linear_momentum() const;                    ///< [kg m/s]
    Vec3 angular_momentum(const Vec3& about) const;  ///< [kg m^2/s]
    int inverted_elements() const { return enduring::inverted_elements(mesh_, positions_); }

    /// All that the next step depends on but what the linear solver keeps; `visit` is given each field in turn.
    template <class Visit>
    void visit_state(Visit& visit)
    {
        for (NodalVectors* field :
             {&positions_, &velocities_, &external_forces_, &last_prediction_, &last_response_})
            visit(*field);
        for (Mat3& rotation : rotations_)
            visit(rotation);
    }

    const ElementRotations& rotations() const { return rotations_; }  ///< of the last predict()
    int solver_iterations() const { return solver_.iterations(); }    ///< of the last prediction
    int factorisations() const { return solver_.factorisations(); }   ///< since the beginning

private:
    bool has_point_law() const { return material_.law != ElasticLaw::corotated; }
    const WholeTurn* turn() const { return whole_turn_ ? &*whole_turn_ : nullptr; }
    void linearise(const NodalVectors& positions);
    void follow_forces(const NodalVectors& before, const NodalVectors& outside, double dt);
    template <class Work>
    auto with_present_elasticity(const Work& work) const;

    ElasticMesh mesh_;
    ElasticMaterial material_;
    ElasticOptions options_;
    LameConstants lame_;
    Eigen::SparseMatrix<double> mass_matrix_;
    Eigen::VectorXd masses_, inverse_masses_;
    std::vector<char> fixed_;
    NodalVectors positions_, velocities_, external_forces_;
    NodalVectors last_prediction_, last_response_;  ///< changes of the velocities [m/s]
    /// since the last predict(), by mend_response(): impulses [N s], and what they changed [m/s]
    NodalVectors mended_impulses_, mended_response_;
    ElementRotations rotations_;
    std::unique_ptr<Elasticity> elasticity_;  ///< linear about the start of the last prediction
    std::optional<WholeTurn> whole_turn_;     ///< at that start, where K is taken without it
    ImplicitSolver solver_;
};

}  // namespace enduring
