#include "chapters/07_implicit_contact/rolling_friction.hpp"

#include "common/simulation/body_pose.hpp"
#include "common/simulation/make_joint.hpp"
#include "common/simulation/rigid_body.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace enduring {
namespace {

/// Turn rates of A against B: how they follow from the coordinates, and what a body that moves as given adds
/// [rad/s].
struct TurnRow {
    std::array<VertexMotion, 2> parts;
    std::size_t count = 0;
    Vec3 given = Vec3::Zero();
    bool is_of_rigid = true;  ///< whether neither of both is soft
};

void add_body(const World& world, const StepProblem& step, int number, double sign, TurnRow& row)
{
    const Body& body = *world.bodies[static_cast<std::size_t>(number)];
    if (body.is_static()) {
        row.given += sign * mean_turn_rate(body, step.problem.step.dt);
        return;
    }
    const auto* const rigid = dynamic_cast<const RigidBody*>(&body);
    const int first = rigid ? first_coordinate(step, number) : -1;
    if (first < 0) {
        row.is_of_rigid = false;
        return;
    }
    VertexMotion& part = row.parts[row.count++];
    part.first = first;
    part.rate = sign * rigid->motion_of_turn();
}

TurnRow turns_of(const World& world, const StepProblem& step, const Contact& contact)
{
    TurnRow row;
    add_body(world, step, contact.body_a, 1, row);
    if (!contact.on_plane())
        add_body(world, step, contact.body_b, -1, row);
    return row;
}

//! [rolling_law]
/// The bounds follow the pair's load, its axes the pair's normal.
void follow(const FrictionCoefficients& friction, const PairLaw& pair, ElementLaw& law)
{
    constexpr double of_equal_pressure = 2.0 / 3;
    const double load = pair.lagged_normal_impulse, rolling = friction.laws.rolling * load,
                 spinning = of_equal_pressure * friction.mu_d * friction.laws.patch * load;
    law.axes = axes_about(pair.normal);
    for (const auto& [line, most] : {std::pair(0, rolling), std::pair(1, rolling), std::pair(2, spinning)}) {
        law.lines[static_cast<std::size_t>(line)].low = -most;
        law.lines[static_cast<std::size_t>(line)].high = most;
    }
}
//! [rolling_law]

}  // namespace

void add_rolling_rows(const World& world, const FrictionCoefficients& friction, StepProblem& step)
{
    for (std::size_t i = 0; i < step.of_row.size(); ++i) {
        const Contact& contact = *step.of_row[i];
        const FrictionCoefficients& own = pair_friction(world, contact, friction);
        if (own.laws.rolling == 0 && own.laws.patch == 0)
            continue;
        const TurnRow turns = turns_of(world, step, contact);
        if (!turns.is_of_rigid || turns.count == 0)
            continue;
        ElementLaw law;
        law.pair = static_cast<int>(i);
        law.is_round = true;
        law.given = turns.given;
        add_element_row(step, law, std::span(turns.parts).first(turns.count), contact.turning);
        const Mat3 response = step.problem.rows.back().response(step.problem.blocks);
        const double inertia = 3 / std::max(response.trace(), 1e-300);
        ElementLaw& added = step.problem.elements.back();
        for (LineLaw& line : added.lines)
            line.slope = rolling_choice.k_dt2_over_inertia * inertia;
        follow(own, step.problem.rows[i].law, added);
    }
}

void follow_rolling(const World& world, const FrictionCoefficients& friction, StepProblem& step)
{
    if (std::none_of(step.problem.elements.begin(), step.problem.elements.end(),
                     [](const ElementLaw& law) { return law.pair >= 0; }))
        return;
    const Eigen::VectorXd velocities = velocities_of(world, step);
    for (std::size_t i = 0; i < step.problem.elements.size(); ++i) {
        ElementLaw& law = step.problem.elements[i];
        if (law.pair < 0)
            continue;
        const auto pair = static_cast<std::size_t>(law.pair);
        PairRow& row = step.problem.rows[step.of_row.size() + i];
        row.velocity = row.rate_of(velocities) + law.given;
        follow(pair_friction(world, *step.of_row[pair], friction), step.problem.rows[pair].law, law);
    }
}

}  // namespace enduring
