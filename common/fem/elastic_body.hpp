#pragma once

#include "common/fem/corotated_elasticity.hpp"
#include "common/fem/implicit_solver.hpp"
#include "common/fem/mass_matrix.hpp"
#include "common/fem/whole_matrix.hpp"
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

/// Imbalance (ElasticBody::approach_end()) up to which a change is taken whole, and is the last one: it
/// leaves about the square. A tenth: a third more time where soft bodies meet, and the same motion. Ten
/// times: nothing is cut, and a pressed block gains energy.
inline constexpr double small_imbalance = 0.1;

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
    /// Before the last predict(), so without gravity and inner forces of its step [m/s].
    const NodalVectors& start_velocities() const { return start_velocities_; }
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
    /// A law at points then reaches its end (reach_end()), so that it gains no energy.
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

    /// One step of Newton's method on the equation of the step with elastic forces where it *ends*,
    ///   (M + dt alpha M + dt beta K) v_new = M v + dt (f_ext + M g + f_el(x + dt v_new)) + impulses,
    /// from the present velocities, with all impulses since the prediction. Later responses take frames and K
    /// of where it began. Without fixed nodes what f_el turns the body as a whole is left out, so angular
    /// momentum is kept to rounding. Call after predict(.., dt).
    /// @return  the imbalance that there was [1]: the change of the velocities, in the norm of the matrix,
    ///          over what the step has changed them, or gravity could
    double approach_end(double dt);
    /// Does so until there was a small_imbalance, or thirty times.
    /// @return  the last imbalance
    double reach_end(double dt);
    /// Whether one of both was called since the last predict(): only then do elastic forces follow the end of
    /// the step.
    bool approaches_end() const { return approaches_; }

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
    /// The matrix of a step of dt [s] over all nodes, with K as respond() has it. It belongs to
    /// velocities_at_nodes().
    WholeMatrix whole_matrix(double dt) const;
    NodalVectors velocities_at_nodes() const { return whole_assembly().values(velocities_); }
    /// Additions and multiplications of a factor of it, about; 0 before the first predict().
    double factor_operations() const { return solver_.factor_operations(); }
    bool is_fixed(int node) const { return fixed_[node] != 0; }
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

    /// All that the next step depends on but what the linear solver keeps; `visit` is given each field in
    /// turn.
    template <class Visit>
    void visit_state(Visit& visit)
    {
        for (NodalVectors* field :
             {&positions_, &velocities_, &external_forces_, &last_prediction_, &last_response_})
            visit(*field);
        for (Mat3& rotation : rotations_)
            visit(rotation);
    }

    /// What the linear solver keeps is made anew in the next step, as in a body that has just been placed in
    /// this state.
    void forget_factor() { solver_.forget_factor(); }

    const ElementRotations& rotations() const { return rotations_; }  ///< of the last predict()
    int solver_iterations() const { return solver_.iterations(); }    ///< of the last prediction
    int factorisations() const { return solver_.factorisations(); }   ///< since the beginning

private:
    bool has_point_law() const { return material_.law != ElasticLaw::corotated; }
    const WholeTurn* turn() const { return whole_turn_ ? &*whole_turn_ : nullptr; }
    void linearise(const NodalVectors& positions);
    void take_out_turn();
    WholeAssembly& whole_assembly() const;
    double mass_scale(double dt) const { return 1 + dt * material_.mass_damping; }
    double stiffness_scale(double dt) const { return dt * (dt + material_.stiffness_damping); }
    /// What is missing in the equation of the step at the present velocities.
    struct Missing {
        NodalVectors impulses;  ///< [N s]
        double potential;       ///< that is least where nothing is missing, but for damping and turns [J]
    };
    Missing find_missing(double dt);
    NodalVectors free_velocities() const;
    void cut_change(const NodalVectors& start, const NodalVectors& change, double potential, double slope,
                    double dt);
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
    /// since the last predict(): velocities when it began [m/s]; momenta then, with all that acts but elastic
    /// forces [N s]
    NodalVectors start_velocities_, loads_;
    bool approaches_ = false;  ///< since the last predict()
    double least_change_ = 0;  ///< of the velocities, that counts at all [sqrt(kg) m/s]
    ElementRotations rotations_;
    std::unique_ptr<Elasticity> elasticity_;  ///< linear about the start of the last prediction
    std::optional<WholeTurn> whole_turn_;     ///< at that start, where K is taken without it
    double length_;                           ///< diagonal of the box around the rest shape [m]
    ImplicitSolver solver_;
    mutable std::optional<WholeAssembly>
        whole_assembly_;  ///< of the nodes that are fixed now; made when asked for
};

}  // namespace enduring
