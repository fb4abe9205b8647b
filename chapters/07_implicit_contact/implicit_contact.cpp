#include "chapters/07_implicit_contact/implicit_contact.hpp"

#include "chapters/04_friction/surface_turn.hpp"
#include "chapters/07_implicit_contact/contact_problem.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace enduring {
namespace {

bool takes_part(const Contact& contact) { return !contact.held() && !contact.resolved; }

/// The vertices of each body that are in touch, each once and in their
/// order, and where each body's coordinates begin.
struct Touched {
    std::vector<std::vector<int>> vertices;  ///< by body
    std::vector<int> block;                  ///< of each body among the problem's, -1 without coordinates
};

std::vector<std::vector<int>> touched_vertices(const World& world, const Contacts& contacts)
{
    std::vector<std::vector<int>> vertices(world.bodies.size());
    for (const Contact& contact : contacts)
        for (int i = 0; takes_part(contact) && i < contact.vertex_count(); ++i)
            vertices[static_cast<std::size_t>(i < contact.vertices_of_a() ? contact.body_a : contact.body_b)]
                .push_back(contact.vertices[static_cast<std::size_t>(i)]);
    for (std::vector<int>& of_body : vertices) {
        std::sort(of_body.begin(), of_body.end());
        of_body.erase(std::unique(of_body.begin(), of_body.end()), of_body.end());
    }
    return vertices;
}

Touched add_blocks(const World& world, const Contacts& contacts, ContactProblem& problem)
{
    Touched touched{touched_vertices(world, contacts), std::vector<int>(world.bodies.size(), -1)};
    for (std::size_t body = 0; body < world.bodies.size(); ++body) {
        if (touched.vertices[body].empty())
            continue;
        BodyBlock block{problem.size, world.bodies[body]->contact_mass(touched.vertices[body])};
        if (block.mass.rows() == 0)
            continue;
        block.factor.compute(block.mass);
        touched.block[body] = static_cast<int>(problem.blocks.size());
        problem.size += static_cast<int>(block.mass.rows());
        problem.blocks.push_back(std::move(block));
    }
    return touched;
}

//! [row]
/// A pair's normal where its force acts; none where its features have none.
std::optional<Vec3> normal_of(const PairStep& step, double tau)
{
    if (step.plane_normal)
        return step.plane_normal;
    const Vec3 area =
        lerp(step.t0.side_1, step.t1.side_1, tau).cross(lerp(step.t0.side_2, step.t1.side_2, tau));
    const double length = area.norm();
    return length > 0 ? std::optional<Vec3>(area / length) : std::nullopt;
}

/// p - q at tau, for a plane from any of its points [m].
Vec3 apart(const World& world, const Contact& contact, double tau)
{
    if (contact.kind == ContactKind::vertex_plane)
        return contact_vertex(world, contact, 0, tau) -
               world.planes[static_cast<std::size_t>(contact.body_b)].point;
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < contact.vertex_count(); ++i)
        sum += contact.weights[static_cast<std::size_t>(i)] * contact_vertex(world, contact, i, tau);
    return sum;
}

void add_parts(const World& world, const Contact& contact, const Touched& touched,
               const ContactProblem& problem, PairRow& row)
{
    for (int i = 0; i < contact.vertex_count(); ++i) {
        const auto body = static_cast<std::size_t>(i < contact.vertices_of_a() ? contact.body_a
                                                                               : contact.body_b);
        if (touched.block[body] < 0)
            continue;
        const std::vector<int>& vertices = touched.vertices[body];
        const int vertex = contact.vertices[static_cast<std::size_t>(i)];
        const auto index = static_cast<std::size_t>(
            std::lower_bound(vertices.begin(), vertices.end(), vertex) - vertices.begin());
        VertexMotion part = world.bodies[body]->contact_motion(vertices, index, problem.step.centre);
        part.rate *= contact.weights[static_cast<std::size_t>(i)];
        part.first += problem.blocks[static_cast<std::size_t>(touched.block[body])].first;
        row.parts[static_cast<std::size_t>(row.part_count++)] = part;
    }
}
//! [row]

double mass_of(const PairRow& row, const Vec3& normal, const ContactProblem& problem)
{
    const double response = normal.dot(row.response(problem.blocks, problem.size) * normal);
    return response > 0 ? 1 / response : 0;
}

/// All pairs as rows; `of_row` names the contact of each.
ContactProblem set_up(const World& world, Contacts& contacts, const ImplicitSettings& settings, double dt,
                      bool first_round, std::vector<Contact*>& of_row, Touched& touched)
{
    ContactProblem problem;
    problem.step = {settings.centre, dt};
    touched = add_blocks(world, contacts, problem);
    of_row.clear();
    for (Contact& contact : contacts) {
        if (!takes_part(contact))
            continue;
        const auto normal = normal_of(pair_step(world, contact), settings.centre);
        PairRow row;
        add_parts(world, contact, touched, problem, row);
        if (!normal || row.part_count == 0)
            continue;
        const Vec3 start = apart(world, contact, 0), end = apart(world, contact, 1);
        const double depth_t0 = normal->dot(start);
        if (first_round && (contact.waiting() || contact.stiffness == 0))
            adapt_stiffness(contact, depth_t0, mass_of(row, *normal, problem), settings.stiffness, dt);
        const double mu = contact.slip > 0 ? settings.mu_d : settings.mu_s;
        const double pressing = contact.impulse.isZero(0) ? contact.load * dt : contact.impulse.norm();
        row.law = {*normal, depth_t0 - contact.slack, contact.stiffness, contact.stretch, mu * pressing};
        row.velocity = (end - start) / dt;
        row.acting = contact.impulse + contact.friction;
        problem.rows.push_back(row);
        of_row.push_back(&contact);
    }
    return problem;
}

/// What the pairs answer to the change now acts on the bodies.
void apply(World& world, const ContactProblem& problem, const Eigen::VectorXd& change,
           const std::vector<Contact*>& of_row, const Touched& touched, double dt)
{
    Eigen::VectorXd momentum = Eigen::VectorXd::Zero(problem.size);
    for (std::size_t i = 0; i < problem.rows.size(); ++i) {
        const PairRow& row = problem.rows[i];
        const PairAnswer made = answer(row.law, row.velocity_after(change), problem.step);
        row.add_impulse(made.normal_impulse + made.friction - row.acting, momentum);
        of_row[i]->impulse = made.normal_impulse;
        of_row[i]->friction = made.friction;
    }
    for (std::size_t body = 0; body < world.bodies.size(); ++body) {
        if (touched.block[body] < 0)
            continue;
        const BodyBlock& block = problem.blocks[static_cast<std::size_t>(touched.block[body])];
        world.bodies[body]->apply_contact_impulse(touched.vertices[body],
                                                  momentum.segment(block.first, block.mass.rows()));
        world.bodies[body]->update_prediction(dt);
    }
}

/// What counts as a momentum at all: that which gravity gives to all bodies in a step.
double least_speed(const World& world, double dt)
{
    double mass = 0;
    for (const auto& body : world.bodies)
        mass += body->mass();
    return std::sqrt(mass) * std::max(1e-3, world.gravity.norm()) * dt;
}

}  // namespace

//! [answer_all_pairs]
void answer_all_pairs(World& world, Contacts& contacts, const ImplicitSettings& settings, double dt)
{
    SolveRecord record{world.step};
    const double least = least_speed(world, dt);
    std::vector<Contact*> of_row;
    Touched touched;
    for (;; ++record.rounds) {
        const ContactProblem problem = set_up(world, contacts, settings, dt, record.rounds == 0, of_row,
                                              touched);
        record.pairs = static_cast<int>(problem.rows.size());
        record.residual = residual_of(problem, Eigen::VectorXd::Zero(problem.size), least);
        record.converged = record.residual <= settings.tolerance;
        if (record.converged || record.rounds == settings.most_rounds)
            break;
        const ProblemSolution solution = solve(problem, 0.1 * settings.tolerance, least);
        record.newton_steps += solution.newton_steps;
        apply(world, problem, solution.change, of_row, touched, dt);
    }
    for (Contact& contact : contacts)
        if (contact.waiting())
            contact.state = ContactState::answered;
    settings.record(record);
}
//! [answer_all_pairs]

//! [remember_pairs]
void remember_pairs(const World& world, Contacts& contacts, double dt)
{
    for (Contact& contact : contacts) {
        if (contact.held()) {
            contact.stretch = surface_turn(world, contact) * contact.stretch;
            continue;
        }
        const double pressing = contact.impulse.norm();
        contact.load = pressing / dt;
        contact.stretch = contact.stiffness > 0 ? Vec3(surface_turn(world, contact) *
                                                       (contact.friction / (-contact.stiffness * dt)))
                                                : Vec3(Vec3::Zero());
    }
}
//! [remember_pairs]

}  // namespace enduring
