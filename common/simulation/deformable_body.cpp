#include "common/simulation/deformable_body.hpp"

#include "common/geometry/surface_extraction.hpp"

#include <algorithm>
#include <utility>

namespace enduring {
namespace {

SurfaceTopology topology_of(const ExtractedSurface& surface)
{
    return SurfaceTopology(static_cast<int>(surface.mesh.vertices.size()), surface.mesh.faces);
}

/// The velocities of a rigid motion, so that nothing is strained at first.
void set_motion(ElasticBody& elastic, const Vec3& velocity, const Vec3& angular_velocity)
{
    const Vec3 centre = elastic.centre_of_mass();
    for (Eigen::Index node = 0; node < elastic.positions().cols(); ++node)
        elastic.velocities().col(node) = velocity +
                                         angular_velocity.cross(elastic.positions().col(node) - centre);
}

class LumpedTrial final : public Trial {
public:
    LumpedTrial(const ElasticBody& elastic, const SurfaceEmbedding& embedding)
        : embedding_(embedding), inverse_masses_(elastic.inverse_masses()), velocities_(elastic.velocities())
    {}
    void push(int vertex, const Vec3& impulse) override
    {
        embedding_.apply_impulse(vertex, impulse, inverse_masses_, velocities_);
    }
    Vec3 velocity(int vertex) override { return embedding_.at(vertex, velocities_); }

private:
    const SurfaceEmbedding& embedding_;
    const Eigen::VectorXd& inverse_masses_;
    NodalVectors velocities_;  ///< of the nodes
};

class ImplicitTrial final : public Trial {
public:
    ImplicitTrial(const Body& body, VertexResponse& response) : body_(body), response_(response) {}
    void push(int vertex, const Vec3& impulse) override { response_.push(vertex, impulse); }
    Vec3 velocity(int vertex) override { return body_.velocity(vertex) + response_.change(vertex); }

private:
    const Body& body_;
    ResponseTrial response_;
};

/// Each node answers alone.
class LumpedParts final : public MassParts {
public:
    LumpedParts(const ElasticBody& elastic, const SurfaceEmbedding& embedding)
        : elastic_(elastic), embedding_(embedding)
    {}
    int count() const override { return elastic_.node_count(); }
    std::span<const int> moved_by(int vertex) const override { return embedding_.node_numbers_of(vertex); }

private:
    const ElasticBody& elastic_;
    const SurfaceEmbedding& embedding_;
};

/// One part, which the elements hold together.
class ImplicitParts final : public MassParts {
public:
    explicit ImplicitParts(VertexResponse& response) : response_(response) {}
    double response_bound(int vertex, std::span<const Push> pushes) const override
    {
        return response_.response_bound(vertex, pushes);
    }

private:
    VertexResponse& response_;
};

/// The nodes without strain, the surface's vertices first, and the edges of the elements.
RestNeighbours neighbours_in(const SurfaceTopology& surface, const ElasticMesh& mesh,
                             const SurfaceEmbedding& embedding)
{
    std::vector<int> number(static_cast<std::size_t>(mesh.node_count()), -1);
    std::vector<Vec3> rest;
    const auto append = [&](int node) {
        number[node] = static_cast<int>(rest.size());
        rest.push_back(mesh.rest().col(node));
    };
    for (int vertex = 0; vertex < embedding.vertex_count(); ++vertex)
        append(embedding.own_node(vertex));
    for (int node = 0; node < mesh.node_count(); ++node)
        if (number[node] < 0)
            append(node);
    std::vector<std::pair<int, int>> bonds;
    const std::size_t used = mesh.basis() == Basis::linear ? 4 : 10;
    for (const ElasticElement& element : mesh.elements())
        for (std::size_t i = 0; i < used; ++i)
            for (std::size_t j = 0; j < i; ++j)
                bonds.push_back(std::minmax(number[element.nodes[i]], number[element.nodes[j]]));
    std::sort(bonds.begin(), bonds.end());
    bonds.erase(std::unique(bonds.begin(), bonds.end()), bonds.end());
    return {surface, rest, bonds};
}

}  // namespace

DeformableBody::DeformableBody(std::string name, const TetrahedralMesh& mesh,
                               const DeformableSettings& settings)
    : DeformableBody(std::move(name), topology_of(surface_of(mesh)), ElasticMesh(mesh),
                     SurfaceEmbedding(mesh, surface_of(mesh).nodes), settings)
{}

DeformableBody::DeformableBody(std::string name, const QuadraticTetrahedralMesh& mesh,
                               const DeformableSettings& settings)
    : DeformableBody(std::move(name), topology_of(surface_of(mesh)), ElasticMesh(mesh),
                     SurfaceEmbedding(mesh, surface_of(mesh).nodes), settings)
{}

DeformableBody::DeformableBody(std::string name, SurfaceTopology surface, ElasticMesh mesh,
                               SurfaceEmbedding embedding, const DeformableSettings& settings)
    : Body(std::move(name), std::move(surface)),
      elastic_(std::move(mesh), settings.material, settings.options), embedding_(std::move(embedding)),
      impulse_response_(settings.impulse_response),
      waiting_impulses_(NodalVectors::Zero(3, elastic_.node_count())), vertex_response_(elastic_, embedding_)
{
    if (impulse_response_ == ImpulseResponse::implicit)
        parts_ = std::make_unique<ImplicitParts>(vertex_response_);
    else
        parts_ = std::make_unique<LumpedParts>(elastic_, embedding_);
    elastic_.place(settings.rotation, settings.position);
    set_motion(elastic_, settings.velocity, settings.angular_velocity);
    for (const int node : settings.fixed_nodes)
        elastic_.fix(node);
    for (const DrivenNodes& driven : settings.driven_nodes) {
        grips_.push_back({driven.nodes, elastic_.positions()(Eigen::all, driven.nodes), driven.motion,
                          driven.centre, driven.until});
        for (const int node : driven.nodes)
            elastic_.fix(node);
    }
    put_grips(0);
    grip_velocity_ = NodalVectors::Zero(3, elastic_.node_count());
    positions_t0_.resize(static_cast<std::size_t>(embedding_.vertex_count()));
    embedding_.evaluate(elastic_.positions(), positions_t0_);
    positions_t1_ = positions_t0_;
    measure();
    if (settings.self_contact)
        rest_neighbours_ =
            std::make_unique<RestNeighbours>(neighbours_in(this->surface(), elastic_.mesh(), embedding_));
}

NodalVectors DeformableBody::Grip::places(double time) const
{
    const GivenPlace now = motion.at(time);
    const Mat3 turn = now.rotation().toRotationMatrix();
    return (turn * (placed.colwise() - centre)).colwise() + (centre + now.displacement);
}

void DeformableBody::put_grips(double time)
{
    for (const Grip& grip : grips_)
        if (grip.holds)
            elastic_.positions()(Eigen::all, grip.nodes) = grip.places(time);
}

/// Freed nodes go on as they move. By the time alone, so that a step that is thrown away may have freed them.
void DeformableBody::hold(Grip& grip, bool holds)
{
    if (grip.holds == holds)
        return;
    grip.holds = holds;
    for (const int node : grip.nodes)
        if (holds)
            elastic_.fix(node);
        else
            elastic_.release(node);
    vertex_response_.forget();
}

void DeformableBody::add_force(const TimedVector& force, std::vector<NodeWeight> shares)
{
    if (shares.empty()) {
        shares.reserve(static_cast<std::size_t>(elastic_.node_count()));
        for (int node = 0; node < elastic_.node_count(); ++node)
            shares.push_back({node, elastic_.masses()[node] / mass()});
    }
    forces_.push_back({force, std::move(shares)});
}

//! [move_grips]
/// Nodes that are gripped stand at the end of the step when the elements are asked for their forces, and
/// count as at rest there. The pairs see them move. What both changes give to the body is the work of what
/// grips.
void DeformableBody::move_grips(const Vec3& weight, double dt)
{
    const double before = energy_of(elastic_, weight).total();
    grip_velocity_ = NodalVectors::Zero(3, elastic_.node_count());
    for (Grip& grip : grips_) {
        constexpr double rounding = 1e-6;  // of the sum of all steps, in parts of one
        hold(grip, time_ + rounding * dt < grip.until);
        if (!grip.holds)
            continue;
        grip_velocity_(Eigen::all, grip.nodes) = (grip.places(time_ + dt) - grip.places(time_)) / dt;
        elastic_.velocities()(Eigen::all, grip.nodes).setZero();
    }
    put_grips(time_ + dt);
    grip_work_ = energy_of(elastic_, weight).total() - before;
}
//! [move_grips]

//! [spread_forces]
/// Their means over the step. What holds a node takes what pulls there, so that does no work on the body.
void DeformableBody::spread_forces(double dt)
{
    NodalVectors& outside = elastic_.external_forces();
    outside.setZero();
    for (const auto& [force, shares] : forces_) {
        const Vec3 mean = force.integral(time_, time_ + dt) / dt;
        for (const auto& [node, weight] : shares)
            outside.col(node) += weight * mean;
    }
    for (const Grip& grip : grips_)
        if (grip.holds)
            outside(Eigen::all, grip.nodes).setZero();
}
//! [spread_forces]

void DeformableBody::predict(const Vec3& gravity, double dt)
{
    const Vec3 weight = gravity_on(gravity);
    if (!grips_.empty())
        move_grips(weight, dt);
    if (!forces_.empty())
        spread_forces(dt);
    elastic_.predict(weight, dt);
    if (!grips_.empty()) {
        grip_work_ -= elastic_.kinetic_energy();
        elastic_.velocities() += grip_velocity_;
        grip_work_ += elastic_.kinetic_energy();
    }
    mends_ = false;
    vertex_response_.begin_step(dt);
    update_prediction(dt);
}

/// Changes the velocities by `work`. What grips a node meets the momentum that this gives to its neighbours.
template <class Work>
void DeformableBody::change_velocities(const Work& work)
{
    const auto momentum_met = [&] { return grip_velocity_.cwiseProduct(elastic_.momenta()).sum(); };
    const double before = grips_.empty() ? 0 : momentum_met();
    work();
    if (!grips_.empty())
        grip_work_ += momentum_met() - before;
}

void DeformableBody::update_prediction(double dt)
{
    if (!waiting_impulses_.isZero(0)) {
        change_velocities([&] {
            if (mends_)
                elastic_.mend_response(waiting_impulses_, dt);
            else
                elastic_.respond(waiting_impulses_, dt);
        });
        waiting_impulses_.setZero();
    }
    update_positions(dt);
}

void DeformableBody::update_positions(double dt)
{
    for (std::size_t vertex = 0; vertex < positions_t1_.size(); ++vertex)
        positions_t1_[vertex] = positions_t0_[vertex] + dt * velocity(static_cast<int>(vertex));
}

void DeformableBody::take_velocities(const NodalVectors& velocities, double dt)
{
    elastic_.velocities() = velocities;
    waiting_impulses_.setZero();
    update_positions(dt);
}

void DeformableBody::commit(double dt)
{
    if (!waiting_impulses_.isZero(0))
        update_prediction(dt);
    elastic_.commit(dt);
    put_grips(time_ + dt);
    embedding_.evaluate(elastic_.positions(), positions_t1_);
    positions_t0_ = positions_t1_;
}

Eigen::VectorXd DeformableBody::contact_velocity(std::span<const int> touched) const
{
    Eigen::VectorXd velocities(3 * static_cast<Eigen::Index>(touched.size()));
    for (std::size_t i = 0; i < touched.size(); ++i)
        velocities.segment<3>(static_cast<Eigen::Index>(3 * i)) = velocity(touched[i]);
    return velocities;
}

double DeformableBody::pressing_force(double) const
{
    return elastic_.external_forces().colwise().norm().sum() +
           elastic_.elastic_forces().colwise().norm().sum();
}

double DeformableBody::approach_end(double dt)
{
    double missing = 0;
    change_velocities([&] { missing = elastic_.approach_end(dt); });
    update_positions(dt);
    return missing;
}

double DeformableBody::reach_end(double dt)
{
    impulse_response_ = ImpulseResponse::implicit;
    double missing = 0;
    change_velocities([&] { missing = elastic_.reach_end(dt); });
    update_positions(dt);
    return missing;
}

/// What holds a node takes its share of an impulse.
void DeformableBody::push_grips(int vertex, const Vec3& impulse)
{
    if (!grips_.empty())
        grip_work_ -= impulse.dot(embedding_.at(vertex, grip_velocity_));
}

void DeformableBody::push_elements(int vertex, const Vec3& impulse)
{
    push_grips(vertex, impulse);
    embedding_.apply_impulse(vertex, impulse, Eigen::VectorXd::Ones(elastic_.node_count()),
                             waiting_impulses_);
}

void DeformableBody::apply_impulse(int vertex, const Vec3& impulse)
{
    if (impulse_response_ == ImpulseResponse::implicit) {
        push_elements(vertex, impulse);
        return;
    }
    push_grips(vertex, impulse);
    embedding_.apply_impulse(vertex, impulse, elastic_.inverse_masses(), elastic_.velocities());
}

Mat3 DeformableBody::inverse_mass(int vertex) const
{
    if (impulse_response_ == ImpulseResponse::implicit && elastic_.factorisations() > 0)
        return vertex_response_.block(vertex, vertex);
    return embedding_.inverse_mass(vertex, elastic_.inverse_masses()) * Mat3::Identity();
}

ContactMass DeformableBody::contact_mass(std::span<const int> touched) const
{
    return vertex_response_.mass_of(touched);
}

VertexMotion DeformableBody::contact_motion(std::span<const int>, std::size_t index, double) const
{
    VertexMotion motion;
    motion.first = static_cast<int>(3 * index);
    motion.rate = Mat3::Identity();
    return motion;
}

void DeformableBody::apply_contact_impulse(std::span<const int> touched, const Eigen::VectorXd& impulse)
{
    for (std::size_t i = 0; i < touched.size(); ++i)
        push_elements(touched[i], impulse.segment<3>(static_cast<Eigen::Index>(3 * i)));
    mends_ = true;
}

void DeformableBody::visit_state(StateArchive& archive)
{
    Body::visit_state(archive);
    elastic_.visit_state(archive);
    archive(waiting_impulses_);
}

std::unique_ptr<Trial> DeformableBody::begin_trial() const
{
    if (impulse_response_ == ImpulseResponse::implicit)
        return std::make_unique<ImplicitTrial>(*this, vertex_response_);
    return std::make_unique<LumpedTrial>(elastic_, embedding_);
}

const RestNeighbours* rest_neighbours(const Body& body)
{
    const auto* soft = dynamic_cast<const DeformableBody*>(&body);
    return soft ? soft->rest_neighbours() : nullptr;
}

Energy energy_of(const ElasticBody& elastic, const Vec3& gravity)
{
    Energy energy;
    energy.kinetic = elastic.kinetic_energy();
    energy.gravitational = -elastic.mass() * gravity.dot(elastic.centre_of_mass());
    energy.elastic = elastic.elastic_energy();
    return energy;
}

}  // namespace enduring
