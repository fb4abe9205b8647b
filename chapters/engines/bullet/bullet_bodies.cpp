#include "chapters/engines/bullet/bullet_bodies.hpp"

#include "chapters/engines/bullet/bullet_shapes.hpp"
#include "chapters/engines/bullet/bullet_vectors.hpp"

#include <algorithm>
#include <stdexcept>

namespace enduring::bullet {
namespace {

/// The corners of all elements, ascending.
std::vector<int> corners_of(const ElasticMesh& mesh)
{
    std::vector<int> corners;
    for (const ElasticElement& element : mesh.elements())
        corners.insert(corners.end(), element.nodes.begin(), element.nodes.begin() + 4);
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

/// A quarter of each element's mass to each of its corners [kg]; 0,
/// which Bullet takes for fixed, for fixed nodes.
std::vector<double> corner_masses(const ElasticBody& body)
{
    std::vector<double> masses(static_cast<std::size_t>(body.node_count()), 0);
    for (const ElasticElement& element : body.mesh().elements())
        for (std::size_t i = 0; i < 4; ++i)
            masses[static_cast<std::size_t>(element.nodes[i])] += body.material().density * element.volume /
                                                                  4;
    for (int node = 0; node < body.node_count(); ++node)
        if (body.inverse_masses()[node] == 0)
            masses[static_cast<std::size_t>(node)] = 0;
    return masses;
}

/// A tenth of half the smallest extent of the shape at rest, or Bullet's 4 cm.
double soft_margin(const ElasticMesh& mesh)
{
    const NodalVectors& rest = mesh.rest();
    return collision_margin(0.5 * (rest.rowwise().maxCoeff() - rest.rowwise().minCoeff()).minCoeff());
}

btSoftBody::TetraScratch undeformed()
{
    const btMatrix3x3& identity = btMatrix3x3::getIdentity();
    btSoftBody::TetraScratch scratch{identity, 3, 1, identity, identity};
    return scratch;
}

std::unique_ptr<btSoftBody> soft_body(const ElasticBody& elastic, const std::vector<int>& corners,
                                      btSoftBodyWorldInfo& world)
{
    const std::vector<double> masses = corner_masses(elastic);
    std::vector<int> number(masses.size(), -1);  // Bullet's of each of our nodes
    std::vector<btVector3> places;
    std::vector<double> mass_of;
    for (const int corner : corners) {
        number[static_cast<std::size_t>(corner)] = static_cast<int>(places.size());
        places.push_back(to_bullet(elastic.positions().col(corner)));
        mass_of.push_back(masses[static_cast<std::size_t>(corner)]);
    }
    auto soft = std::make_unique<btSoftBody>(&world, static_cast<int>(places.size()), places.data(),
                                             mass_of.data());
    soft->getCollisionShape()->setMargin(soft_margin(elastic.mesh()));
    for (int i = 0; i < soft->m_nodes.size(); ++i)
        soft->m_nodes[i].m_v = to_bullet(elastic.velocities().col(corners[static_cast<std::size_t>(i)]));
    for (const ElasticElement& element : elastic.mesh().elements()) {
        const auto node = [&](std::size_t i) { return number[static_cast<std::size_t>(element.nodes[i])]; };
        soft->appendTetra(node(0), node(1), node(2), node(3));
        for (const auto& [a, b] :
             tetrahedron_edges)  // Bullet's trees follow links; they pull only if a force is added
            soft->appendLink(node(static_cast<std::size_t>(a)), node(static_cast<std::size_t>(b)), nullptr,
                             true);
    }
    soft->initializeDmInverse();
    soft->m_tetraScratches.resize(soft->m_tetras.size(), undeformed());
    soft->m_tetraScratchesTn.resize(soft->m_tetras.size(), undeformed());
    return soft;
}

}  // namespace

void BulletBody::apply_impulse(int, const Vec3&)
{
    throw std::logic_error("Bullet alone moves '" + name() + "'");
}

Mat3 BulletBody::inverse_mass(int) const { throw std::logic_error("Bullet alone moves '" + name() + "'"); }

BulletRigidBody::BulletRigidBody(const RigidBody& body, btCollisionShape& shape)
    : BulletBody(body.name(), body.surface()), mass_(body.mass())
{
    const RigidMotion& motion = body.motion();
    const Mat3 axes = motion.pose().orientation.toRotationMatrix();
    inertia_ = (axes.transpose() * motion.inverse_inertia() * axes).diagonal().cwiseInverse();
    for (const Vec3& x : body.positions_t0())
        body_points_.push_back(motion.pose().to_body(x));

    btRigidBody::btRigidBodyConstructionInfo info(mass_, nullptr, &shape, to_bullet(inertia_));
    info.m_startWorldTransform = btTransform(to_bullet(motion.pose().orientation),
                                             to_bullet(motion.centre()));
    body_ = std::make_shared<btRigidBody>(info);
    body_->setLinearVelocity(to_bullet(motion.velocity()));
    body_->setAngularVelocity(to_bullet(motion.angular_velocity()));
    positions_t0_.assign(body.positions_t0().begin(), body.positions_t0().end());
    positions_t1_ = positions_t0_;
    measure();
}

void BulletRigidBody::read_back()
{
    for (std::size_t i = 0; i < body_points_.size(); ++i)
        positions_t1_[i] = from_bullet(body_->getWorldTransform() * to_bullet(body_points_[i]));
}

Vec3 BulletRigidBody::velocity(int vertex) const
{
    const btVector3 lever = body_->getWorldTransform().getBasis() *
                            to_bullet(body_points_[static_cast<std::size_t>(vertex)]);
    return from_bullet(body_->getVelocityInLocalPoint(lever));
}

Vec3 BulletRigidBody::spin_momentum() const
{
    const btMatrix3x3& axes = body_->getWorldTransform().getBasis();
    return from_bullet(axes *
                       (to_bullet(inertia_) * (body_->getAngularVelocity() * axes)));  // row times matrix
}

Energy BulletRigidBody::energy(const Vec3& gravity) const
{
    Energy energy;
    energy.kinetic = 0.5 * mass_ * body_->getLinearVelocity().length2() +
                     0.5 * from_bullet(body_->getAngularVelocity()).dot(spin_momentum());
    energy.gravitational = -mass_ * gravity.dot(from_bullet(body_->getWorldTransform().getOrigin()));
    return energy;
}

Vec3 BulletRigidBody::linear_momentum() const { return mass_ * from_bullet(body_->getLinearVelocity()); }

Vec3 BulletRigidBody::angular_momentum(const Vec3& about) const
{
    return (from_bullet(body_->getWorldTransform().getOrigin()) - about).cross(linear_momentum()) +
           spin_momentum();
}

BulletSoftBody::BulletSoftBody(const DeformableBody& body, btSoftBodyWorldInfo& world)
    : BulletBody(body.name(), body.surface()), elastic_(body.elastic().mesh(), body.elastic().material()),
      embedding_(body.embedding()), corners_(corners_of(elastic_.mesh())),
      body_(soft_body(body.elastic(), corners_, world))
{
    positions_t0_.resize(static_cast<std::size_t>(embedding_.vertex_count()));
    read_back();
    positions_t0_ = positions_t1_;
    measure();
}

void BulletSoftBody::read_back()
{
    for (int i = 0; i < body_->m_nodes.size(); ++i) {
        const int corner = corners_[static_cast<std::size_t>(i)];
        elastic_.positions().col(corner) = from_bullet(body_->m_nodes[i].m_x);
        elastic_.velocities().col(corner) = from_bullet(body_->m_nodes[i].m_v);
    }
    if (elastic_.mesh().basis() == Basis::quadratic)
        for (const ElasticElement& element : elastic_.mesh().elements())
            for (std::size_t i = 0; i < tetrahedron_edges.size(); ++i) {
                const auto& [a, b] = tetrahedron_edges[i];
                for (NodalVectors* field : {&elastic_.positions(), &elastic_.velocities()})
                    field->col(element.nodes[4 + i]) =
                        0.5 * (field->col(element.nodes[static_cast<std::size_t>(a)]) +
                               field->col(element.nodes[static_cast<std::size_t>(b)]));
            }
    positions_t1_.resize(positions_t0_.size());
    embedding_.evaluate(elastic_.positions(), positions_t1_);
}

}  // namespace enduring::bullet
