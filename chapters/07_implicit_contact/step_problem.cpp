#include "chapters/07_implicit_contact/step_problem.hpp"

#include "chapters/07_implicit_contact/viscous_friction.hpp"
#include "chapters/07_implicit_contact/whole_bodies.hpp"

#include <algorithm>

namespace enduring {
namespace {

/// Where a number stands among ascending ones, if it is there.
std::optional<std::size_t> place_among(const std::vector<int>& numbers, int number)
{
    const auto place = std::lower_bound(numbers.begin(), numbers.end(), number);
    if (place == numbers.end() || *place != number)
        return std::nullopt;
    return static_cast<std::size_t>(place - numbers.begin());
}

/// The vertices of each body of an island that are in touch, each once and in their order.
std::vector<std::vector<int>> touched_vertices(const Island& island)
{
    std::vector<std::vector<int>> vertices(island.bodies.size());
    for (const Contact* contact : island.contacts)
        for (int i = 0; i < contact->vertex_count(); ++i)
            if (const auto place = place_among(island.bodies, static_cast<int>(body_index(*contact, i))))
                vertices[*place].push_back(contact->vertices[static_cast<std::size_t>(i)]);
    for (const VertexShare& share : island.element_vertices)
        if (const auto place = place_among(island.bodies, share.body))
            vertices[*place].push_back(share.vertex);
    for (std::vector<int>& of_body : vertices) {
        std::sort(of_body.begin(), of_body.end());
        of_body.erase(std::unique(of_body.begin(), of_body.end()), of_body.end());
    }
    return vertices;
}

/// Change of a pair's velocity per impulse on p [1/kg].
Mat3 response_of(const World& world, const Contact& contact, const StepProblem& step, const PairRow& row)
{
    std::array<VertexShare, 4> shares;
    const auto count = static_cast<std::size_t>(contact.vertex_count());
    for (std::size_t i = 0; i < count; ++i)
        shares[i] = {static_cast<int>(body_index(contact, static_cast<int>(i))), contact.vertices[i],
                     contact.weights[i]};
    return row.response(step.problem.blocks) + response_of_whole(world, std::span(shares).first(count), step);
}

void add_blocks(const World& world, StepProblem& step, double sparse_operation)
{
    for (std::size_t place = 0; place < step.bodies.size(); ++place) {
        Body& body = *world.bodies[static_cast<std::size_t>(step.bodies[place])];
        step.nodes.push_back(nodes_if_whole(body, step.vertices[place], sparse_operation));
        if (!step.nodes.back().empty()) {
            step.problem.blocks.push_back({step.problem.size, {}, {}, whole_of(world, step, place)});
            step.problem.size += step.problem.blocks.back().size();
            continue;
        }
        ContactMass of = body.contact_coordinates().contact_mass(step.vertices[place]);
        step.problem.blocks.push_back({step.problem.size, std::move(of.mass), std::move(of.response)});
        step.problem.size += step.problem.blocks.back().size();
    }
}

void add_parts(const World& world, const Contact& contact, const StepProblem& step, PairRow& row)
{
    for (int i = 0; i < contact.vertex_count(); ++i) {
        const auto vertex = static_cast<std::size_t>(i);
        // the lever of a path is that of its middle, or a push at right angles to the path would do work
        const double tau = contact.sliding_normal.isZero(0) ? step.problem.step.centre : 0.5;
        std::optional<VertexMotion> part = motion_of_vertex(
            world, step, static_cast<int>(body_index(contact, i)), contact.vertices[vertex], tau);
        if (!part)
            continue;
        part->rate *= contact.weights[vertex];
        // all vertices of a rigid body move with the same coordinates
        if (row.part_count > 0 &&
            row.parts[static_cast<std::size_t>(row.part_count - 1)].first == part->first) {
            row.parts[static_cast<std::size_t>(row.part_count - 1)].rate += part->rate;
            continue;
        }
        row.parts[static_cast<std::size_t>(row.part_count++)] = *part;
    }
}

//! [slides_on]
/// Whether a pair slips too fast for friction to stop it in this step; else it may hold again.
bool slides_on(const Contact& contact, double mass, const FrictionCoefficients& friction, double dt)
{
    return contact.spring.slip > 0 && contact.spring.slip * mass > friction.mu_s * contact.spring.load * dt;
}
//! [slides_on]

//! [can_move]
/// Whether any coordinate moves a pair's vertices along its normal. If all are held in this direction, a lock
/// carries the load, and the pair's part of it is undefined.
bool can_move(const PairRow& row)
{
    constexpr double rounding = 1e-12;  // of a direction, and of a lever in metres
    bool gives = false;
    for (const VertexMotion& part : row.moving())
        with_fixed_size(part, [&](int, const auto& motion) {
            gives = gives || (motion.transpose() * row.law.normal).norm() > rounding;
        });
    return gives;
}
//! [can_move]

//! [has_friction]
/// A pair that began inside has no friction until it is nearly out. Its rest offset tells it from a loaded
/// spring that was made stiffer: the offset of such a spring is no deeper than the depth to which its load
/// pressed it at its first stiffness.
bool has_friction(const Contact& contact, double mass, const StiffnessChoice& choice, double dt)
{
    if (contact.spring.rest_offset >= -choice.friction_offset * choice.depth())
        return true;
    const double first = wanted_stiffness(mass, 0, choice, dt);
    return -contact.spring.rest_offset * first <= contact.spring.load;
}
//! [has_friction]

}  // namespace

double depth_at_start(const World& world, const Contact& contact)
{
    return contact.endures() ? contact_geometry(world, contact, 0).depth : 0;
}

double mass_along(const Vec3& normal, const Mat3& response)
{
    const double along = normal.dot(response * normal);
    return along > 0 ? 1 / along : 0;
}

//! [max_load]
namespace {

constexpr double lever_of_load = 10;

double load_of(const Body& body, const Vec3& gravity, double dt)
{
    return lever_of_load * (body.mass() * gravity.norm() + body.pressing_force(dt)) +
           body.mass() * body.mean_velocity().norm() / dt;
}

/// The fastest at which a body that moves as given moves a vertex in touch [m/s].
double fastest_drive(const World& world, const Island& island)
{
    double fastest = 0;
    for (const Contact* contact : island.contacts)
        for (int i = 0; i < contact->vertex_count(); ++i)
            if (const Body& body = body_of_vertex(world, *contact, i); body.is_static())
                fastest = std::max(fastest,
                                   body.velocity(contact->vertices[static_cast<std::size_t>(i)]).norm());
    return fastest;
}

}  // namespace

double max_load(const World& world, const Island& island, double dt)
{
    double load = 0, mass = 0;
    for (const int place : island.bodies) {
        const Body& body = *world.bodies[static_cast<std::size_t>(place)];
        load += load_of(body, world.gravity, dt);
        mass += body.mass();
    }
    // A drive goes on whatever it meets: in a part of a step it stops nothing sooner, or halves would make
    // what it squeezes stiffer.
    load += lever_of_load * island.element_force;
    return load + mass * fastest_drive(world, island) / std::max(dt, world.whole_dt);
}
//! [max_load]

StepProblem set_up(const World& world, const Island& island, const StiffnessChoice& choice,
                   const FrictionCoefficients& friction, const StepLaw& step_law, bool first,
                   double sparse_operation)
{
    StepProblem step;
    step.problem.step = step_law;
    step.bodies = island.bodies;
    step.elements = island.elements;
    step.vertices = touched_vertices(island);
    add_blocks(world, step, sparse_operation);
    step.problem.rows.reserve(island.contacts.size());
    const double most = step.max_load = max_load(world, island, step_law.dt);
    for (Contact* const of_row : island.contacts) {
        Contact& contact = *of_row;
        PairRow row;
        add_parts(world, contact, step, row);
        update_row(world, contact, step_law, row);
        const double depth_t0 = depth_at_start(world, contact);
        if (row.law.normal.isZero(0) || !can_move(row))
            continue;
        step.responses.push_back(response_of(world, contact, step, row));
        const double mass = mass_along(row.law.normal, step.responses.back());
        const StiffnessChoice own = choice.of_pair(natural_units(world, contact, step_law.dt));
        if (first || contact.spring.stiffness == 0)
            adapt_stiffness(contact, depth_t0, mass, own, step_law.dt, most);
        row.law.stiffness = contact.spring.stiffness;
        row.law.stretch = contact.spring.stretch;
        const FrictionCoefficients& of_pair = pair_friction(world, contact, friction);
        if (row.law.viscous = of_pair.laws.viscous; row.law.viscous > 0)
            row.law.stretch = stretch_without_film(
                contact.spring.stretch, of_pair.mu_s * contact.spring.load / contact.spring.stiffness);
        row.law.mu = !has_friction(contact, mass, own, step_law.dt)   ? 0
                     : slides_on(contact, mass, of_pair, step_law.dt) ? of_pair.mu_d
                                                                      : of_pair.mu_s;
        step.problem.rows.push_back(std::move(row));
        step.of_row.push_back(&contact);
    }
    return step;
}

std::optional<std::size_t> place_of(const StepProblem& step, int body)
{
    return place_among(step.bodies, body);
}

int first_coordinate(const StepProblem& step, int body)
{
    const auto place = place_of(step, body);
    return place && step.problem.blocks[*place].size() > 0 ? step.problem.blocks[*place].first : -1;
}

std::optional<VertexMotion> motion_of_vertex(const World& world, const StepProblem& step, int body,
                                             int vertex, double tau)
{
    const auto place = place_of(step, body);
    if (!place || step.problem.blocks[*place].size() == 0)
        return std::nullopt;
    const BodyBlock& block = step.problem.blocks[*place];
    const std::vector<int>& vertices = step.vertices[*place];
    const std::size_t index = *place_among(vertices, vertex);
    VertexMotion motion = world.bodies[static_cast<std::size_t>(body)]->contact_coordinates().contact_motion(
        vertices, index, tau);
    if (block.whole) {
        const int node = step.nodes[*place][index];
        if (node < 0)
            return std::nullopt;
        motion.first = 3 * node;
    }
    motion.first += block.first;
    return motion;
}

void add_element_row(StepProblem& step, ElementLaw law, std::span<const VertexMotion> parts,
                     const Vec3& acting)
{
    PairRow row;
    row.element = static_cast<int>(step.problem.elements.size());
    row.acting = acting;
    for (const VertexMotion& part : parts)
        row.parts[static_cast<std::size_t>(row.part_count++)] = part;
    step.problem.elements.push_back(std::move(law));
    step.problem.rows.push_back(std::move(row));
}

namespace {

/// Calls visit(body, its vertices in touch, its part of a momentum of the coordinates) for each body that has
/// coordinates.
template <class Visit>
void visit_bodies(World& world, const StepProblem& step, const Eigen::VectorXd& momentum, const Visit& visit)
{
    for (std::size_t place = 0; place < step.bodies.size(); ++place)
        if (const BodyBlock& block = step.problem.blocks[place]; block.size() > 0)
            visit(*world.bodies[static_cast<std::size_t>(step.bodies[place])], step.vertices[place],
                  block.whole ? at_nodes(momentum, block.first, step.nodes[place])
                              : Eigen::VectorXd(momentum.segment(block.first, block.size())));
}

/// Brings a momentum of the coordinates to the bodies and their prediction.
void apply_momentum(World& world, const StepProblem& step, const Eigen::VectorXd& momentum)
{
    visit_bodies(world, step, momentum,
                 [&](Body& body, const std::vector<int>& vertices, const Eigen::VectorXd& own) {
                     body.contact_coordinates().apply_contact_impulse(vertices, own);
                     body.update_prediction(step.problem.step.dt);
                 });
}

}  // namespace

//! [follow_levers]
bool follow_levers(World& world, StepProblem& step, double least_turn)
{
    const double dt = step.problem.step.dt;
    bool any = false;
    for (const int place : step.bodies)
        any |= world.bodies[static_cast<std::size_t>(place)]->contact_coordinates().follow_levers(least_turn,
                                                                                                  dt);
    if (!any)
        return false;
    Eigen::VectorXd missing = Eigen::VectorXd::Zero(step.problem.size);
    for (std::size_t i = 0; i < step.of_row.size(); ++i) {
        PairRow& row = step.problem.rows[i];
        const Vec3 acting = step.of_row[i]->impulse + step.of_row[i]->friction;
        row.add_impulse(-acting, missing);
        row.part_count = 0;
        add_parts(world, *step.of_row[i], step, row);
        row.add_impulse(acting, missing);
        step.responses[i] = response_of(world, *step.of_row[i], step, row);
    }
    apply_momentum(world, step, missing);
    return true;
}
//! [follow_levers]

void update_kinematics(const World& world, StepProblem& step)
{
    for (std::size_t i = 0; i < step.of_row.size(); ++i) {
        update_row(world, *step.of_row[i], step.problem.step, step.problem.rows[i]);
        step.problem.rows[i].law.lagged_normal_impulse = std::max(
            0.0, step.problem.rows[i].law.normal.dot(step.of_row[i]->impulse));
    }
}

Eigen::VectorXd last_impulses(const World& world, const StepProblem& step)
{
    Eigen::VectorXd impulses(3 * step.problem.rows.size());
    const std::size_t pairs = step.of_row.size();
    for (std::size_t i = 0; i < step.problem.elements.size(); ++i)
        impulses.segment<3>(static_cast<Eigen::Index>(3 * (pairs + i))) = step.problem.elements[i].begin;
    for (std::size_t i = 0; i < pairs; ++i) {
        const Contact& contact = *step.of_row[i];
        // along the normal of the start, which is that of the last step's end
        const Vec3 normal = normal_of(pair_step(world, contact), 0);
        impulses.segment<3>(static_cast<Eigen::Index>(3 * i)) =
            step.problem.step.dt *
            (contact.spring.load * normal - contact.spring.stiffness * contact.spring.stretch);
    }
    return impulses;
}

Eigen::VectorXd velocities_of(const World& world, const StepProblem& step)
{
    Eigen::VectorXd velocities(step.problem.size);
    for (std::size_t place = 0; place < step.bodies.size(); ++place)
        if (const BodyBlock& block = step.problem.blocks[place]; block.size() > 0)
            velocities.segment(block.first, block.size()) =
                block.whole ? velocities_at_nodes(world, step, place)
                            : world.bodies[static_cast<std::size_t>(step.bodies[place])]
                                  ->contact_coordinates()
                                  .contact_velocity(step.vertices[place]);
    return velocities;
}

Eigen::VectorXd momentum_of(const StepProblem& step)
{
    Eigen::VectorXd momentum = Eigen::VectorXd::Zero(step.problem.size);
    for (std::size_t i = 0; i < step.of_row.size(); ++i)
        step.problem.rows[i].add_impulse(step.of_row[i]->impulse + step.of_row[i]->friction, momentum);
    return momentum;
}

//! [apply_impulses]
void apply_impulses(World& world, StepProblem& step, const Eigen::VectorXd& impulses)
{
    Eigen::VectorXd momentum = Eigen::VectorXd::Zero(step.problem.size);
    for (std::size_t i = 0; i < step.problem.rows.size(); ++i) {
        const PairRow& row = step.problem.rows[i];
        const Vec3 impulse = impulses.segment<3>(static_cast<Eigen::Index>(3 * i));
        row.add_impulse(impulse - row.acting, momentum);
        step.problem.rows[i].acting = impulse;
        if (i >= step.of_row.size()) {  // of an element
            if (const int pair = step.problem.element_of(row).pair; pair >= 0)
                step.of_row[static_cast<std::size_t>(pair)]->turning = impulse;
            continue;
        }
        Contact& contact = *step.of_row[i];
        contact.impulse = row.law.normal.dot(impulse) * row.law.normal;
        contact.friction = impulse - contact.impulse;
    }
    apply_momentum(world, step, momentum);
}
//! [apply_impulses]

void kick(World& world, const StepProblem& step, const Eigen::VectorXd& momentum)
{
    const auto push = [&](Body& body, const std::vector<int>& vertices, const Eigen::VectorXd& own) {
        body.kick(vertices, own, step.problem.step.dt);
    };
    visit_bodies(world, step, momentum, push);
}

void find_slip(StepProblem& step)
{
    for (std::size_t i = 0; i < step.of_row.size(); ++i) {
        const PairRow& row = step.problem.rows[i];
        const Vec3 along = row.velocity - row.law.normal.dot(row.velocity) * row.law.normal;
        step.of_row[i]->spring.slip = pushed(row.law, row.velocity, step.problem.step).slips ? along.norm()
                                                                                             : 0;
    }
}

}  // namespace enduring
