#pragma once

#include "common/fem/elastic_body.hpp"
#include "common/fem/surface_embedding.hpp"
#include "common/geometry/meshes.hpp"
#include "common/simulation/body.hpp"
#include "common/simulation/given_motion.hpp"
#include "common/simulation/outside_load.hpp"
#include "common/simulation/rest_neighbours.hpp"
#include "common/simulation/vertex_response.hpp"

#include <limits>

namespace enduring {

/// How contact impulses change a deformable body's velocities, for a solver that gives them pair by pair. One
/// that solves for the velocities of all vertices in touch (contact_mass()) always takes the implicit
/// response.
enum class ImpulseResponse {
    /// At once, each node by its row sum of the mass matrix alone, as the thesis does. The linear momentum is
    /// exact. The body between the nodes lags behind them, though: it gains less than the lever's angular
    /// momentum, and another energy than the work.
    lumped,
    /// At the next update_prediction, through the elasticity's system: light nodes move with their
    /// neighbours. Momenta and work are exact up to the strain there is.
    implicit
};

/// Nodes of a deformable body that move as given, whatever pulls.
struct DrivenNodes {
    std::vector<int> nodes;
    GivenMotion motion;
    Vec3 centre = Vec3::Zero();  ///< what the motion displaces and turns about, where the body is placed [m]
    /// [s]; from the first step on that begins then, they are free, with the velocity that they have
    double until = std::numeric_limits<double>::infinity();
};

/// What a deformable body is made of, and where it starts.
struct DeformableSettings {
    ElasticMaterial material;
    Mat3 rotation = Mat3::Identity();       ///< turns the mesh about its origin, then ...
    Vec3 position = Vec3::Zero();           ///< ... moves it [m]; the shape stays unstrained
    Vec3 velocity = Vec3::Zero();           ///< of the centre of mass [m/s]
    Vec3 angular_velocity = Vec3::Zero();   ///< about it, in world axes [rad/s]
    std::vector<int> fixed_nodes;           ///< nodes of the mesh that never move
    std::vector<DrivenNodes> driven_nodes;  ///< no node twice, nor one that is fixed
    ImpulseResponse impulse_response = ImpulseResponse::lumped;
    bool self_contact = false;  ///< whether its surface is looked at for contact with itself, too
    ElasticOptions options;
};

/// What the elements carry, by the consistent mass matrix; for whatever moves them.
Energy energy_of(const ElasticBody& elastic, const Vec3& gravity);

/// An elastic body as the contact code sees it; it moves, and its energy and momenta are, by the consistent
/// mass matrix. Each surface vertex is a fixed combination of nodes, x = sum_i w_i c_i; an impulse on it goes
/// back through the transpose, w_i of it to node i.
class DeformableBody final : public Body, public ContactCoordinates, public InnerForces {
public:
    /// @throws InputError  a mesh, material constant or fixed node that cannot be
    DeformableBody(std::string name, const TetrahedralMesh& mesh, const DeformableSettings& settings);
    DeformableBody(std::string name, const QuadraticTetrahedralMesh& mesh,
                   const DeformableSettings& settings);

    /// A force from now on [N]; any number of them. On nodes that are held it does nothing.
    /// @param shares  of nodes in it, together 1; if none, it is spread over the body by its mass as gravity
    ///     is
    void add_force(const TimedVector& force, std::vector<NodeWeight> shares = {});

    void predict(const Vec3& gravity, double dt) override;
    void update_prediction(double dt) override;
    void commit(double dt) override;

    void apply_impulse(int vertex, const Vec3& impulse) override;
    Vec3 velocity(int vertex) const override { return embedding_.at(vertex, elastic_.velocities()); }
    /// With the implicit response and after the first predict(), of the whole body as its elements tie it
    /// together; else of the vertex's nodes alone.
    Mat3 inverse_mass(int vertex) const override;

    ContactCoordinates& contact_coordinates() override { return *this; }
    /// One coordinate for each component of the velocity of each touched vertex. The
    /// blocks are the learned ones, turned with their elements, so the mass is an approximation, made stiffer
    /// than it is nowhere: a solver has to look at what its impulses really did.
    ContactMass contact_mass(std::span<const int> touched) const override;
    /// What contact_mass() is made of, for a body that is solved for with all its nodes
    /// (ElasticBody::whole_matrix()): block (u, v) of the learned response, kept for as long as the step has
    /// the same length.
    Mat3 learned_response(int u, int v) const { return vertex_response_.block(u, v); }
    void learn_responses(std::span<const int> touched) const { vertex_response_.learn(touched); }
    VertexMotion contact_motion(std::span<const int> touched, std::size_t index, double tau) const override;
    void apply_contact_impulse(std::span<const int> touched, const Eigen::VectorXd& impulse) override;
    Eigen::VectorXd contact_velocity(std::span<const int> touched) const override;

    std::unique_ptr<Trial> begin_trial() const override;
    const MassParts& mass_parts() const override { return *parts_; }

    bool is_driven() const override { return Body::is_driven() || !forces_.empty() || !grips_.empty(); }
    double pressing_force(double dt) const override;
    double driven_work(double dt) const override
    {
        return dt * elastic_.external_forces().cwiseProduct(elastic_.velocities()).sum() + grip_work_;
    }
    void visit_state(StateArchive& archive) override;
    /// What solves have learned, which is no part of the state: the next step then has the same bytes as that
    /// of a body whose state was restored.
    void forget_learned()
    {
        elastic_.forget_factor();
        vertex_response_.forget();
    }

    double mass() const override { return elastic_.mass(); }
    Energy energy(const Vec3& gravity) const override { return energy_of(elastic_, gravity_on(gravity)); }
    Vec3 linear_momentum() const override { return elastic_.linear_momentum(); }
    Vec3 angular_momentum(const Vec3& about) const override { return elastic_.angular_momentum(about); }
    int inverted_elements() const override { return elastic_.inverted_elements(); }

    InnerForces& inner_forces() override { return *this; }
    /// See ElasticBody::approach_end().
    double approach_end(double dt) override;
    /// Approaches until the imbalance is small (ElasticBody::reach_end()). All impulses take the implicit
    /// response from here on.
    double reach_end(double dt) override;
    bool approaches_end() const override { return elastic_.approaches_end(); }

    /// For a solver that finds the whole motion itself: predicted velocities of all nodes in place of those
    /// there are, and positions_t1 from them. Behind a commit it takes stand_still() after it, and only
    /// velocities change.
    /// @param velocities  one a node (control point), zero where a node is fixed [m/s]
    void take_velocities(const NodalVectors& velocities, double dt);

    const ElasticBody& elastic() const { return elastic_; }
    const SurfaceEmbedding& embedding() const { return embedding_; }
    const RestNeighbours* rest_neighbours() const { return rest_neighbours_.get(); }

private:
    DeformableBody(std::string name, SurfaceTopology surface, ElasticMesh mesh, SurfaceEmbedding embedding,
                   const DeformableSettings& settings);

    /// Nodes that move as given.
    struct Grip {
        std::vector<int> nodes;
        NodalVectors placed;  ///< without the motion [m]
        GivenMotion motion;
        Vec3 centre;
        double until;
        bool holds = true;

        NodalVectors places(double time) const;
    };
    void put_grips(double time);
    void hold(Grip& grip, bool holds);
    void spread_forces(double dt);
    void move_grips(const Vec3& weight, double dt);

    void push_grips(int vertex, const Vec3& impulse);
    void push_elements(int vertex, const Vec3& impulse);
    void update_positions(double dt);
    template <class Work>
    void change_velocities(const Work& work);

    struct SharedForce {
        TimedVector force;
        std::vector<NodeWeight> shares;
    };
    std::vector<SharedForce> forces_;
    std::vector<Grip> grips_;
    double grip_work_ = 0;        ///< of what moves them, in the step that is predicted [J]
    NodalVectors grip_velocity_;  ///< in that step, of all nodes, zero where nothing grips [m/s]
    ElasticBody elastic_;
    SurfaceEmbedding embedding_;
    ImpulseResponse impulse_response_;
    /// on the nodes, until the next update_prediction; of the implicit response
    NodalVectors waiting_impulses_;
    bool mends_ = false;  ///< whether the step's impulses mend each other (apply_contact_impulse)
    mutable VertexResponse vertex_response_;  ///< filled when asked; of the implicit response
    std::unique_ptr<const MassParts> parts_;
    std::unique_ptr<const RestNeighbours> rest_neighbours_;  ///< only if it meets itself
};

}  // namespace enduring
