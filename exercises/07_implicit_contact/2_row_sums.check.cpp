#include "exercises/07_implicit_contact/2_row_sums.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <Eigen/Eigenvalues>

using namespace enduring;

namespace {

RandomInputs generator(7);

double random_number() { return generator.number(-1, 1); }

Eigen::VectorXd random_vector(Eigen::Index size)
{
    return Eigen::VectorXd::NullaryExpr(size, [](Eigen::Index) { return random_number(); });
}

/// J M^-1 J^T of some random bodies and pairs.
Eigen::MatrixXd random_delassus(Eigen::Index pairs)
{
    const Eigen::MatrixXd j = Eigen::MatrixXd::NullaryExpr(
        pairs, 4, [](Eigen::Index, Eigen::Index) { return random_number(); });
    return j * j.transpose() + 1e-3 * Eigen::MatrixXd::Identity(pairs, pairs);
}

std::vector<double> equal_cubes(int count)
{
    return std::vector<double>(static_cast<std::size_t>(count), 10);
}

/// All cubes fall with 0.1 m/s: only the lowest joint closes.
Eigen::VectorXd falling(Eigen::Index joints)
{
    Eigen::VectorXd free = Eigen::VectorXd::Zero(joints);
    free(0) = -0.1;
    return free;
}

int rounds_of_pile(int cubes)
{
    const Eigen::MatrixXd w = delassus_of_pile(equal_cubes(cubes));
    return rounds_until_answered(w, falling(cubes), row_sums(w), 1e-6, 100000);
}

/// What the impulses leave to be answered: 1/2 I^T W I + free^T I.
double objective(const Eigen::MatrixXd& w, const Eigen::VectorXd& free, const Eigen::VectorXd& impulses)
{
    return 0.5 * impulses.dot(w * impulses) + free.dot(impulses);
}

}  // namespace

TEST_CASE("pile: a cube alone answers an impulse with one over its mass")
{
    given("one cube of 4 kg");
    expect("W", delassus_of_pile({4})(0, 0), 0.25, 1e-15, "1/kg");
}

TEST_CASE("pile: an impulse between two cubes moves both, and closes the joint below")
{
    given("cubes of 2 kg and 5 kg, from below");
    const Eigen::MatrixXd w = delassus_of_pile({2, 5});
    expect("W(0, 0), which moves the lower cube only", w(0, 0), 0.5, 1e-15, "1/kg");
    expect("W(1, 1), which moves both apart", w(1, 1), 0.5 + 0.2, 1e-15, "1/kg");
    expect("W(0, 1), which pushes the lower cube onto the ground", w(0, 1), -0.5, 1e-15, "1/kg");
    expect("W(1, 0), which lifts the lower cube towards the upper", w(1, 0), -0.5, 1e-15, "1/kg");
}

TEST_CASE("pile: what W says is what cubes do that are pushed one by one")
{
    const std::vector<double> masses{3, 1, 8, 0.5, 20};
    given("cubes of 3, 1, 8, 0.5 and 20 kg");
    const Eigen::VectorXd impulses = random_vector(5);
    Eigen::VectorXd velocity = Eigen::VectorXd::Zero(5);
    for (Eigen::Index joint = 0; joint < 5; ++joint) {
        velocity(joint) += impulses(joint) / masses[static_cast<std::size_t>(joint)];
        if (joint > 0)
            velocity(joint - 1) -= impulses(joint) / masses[static_cast<std::size_t>(joint - 1)];
    }
    Eigen::VectorXd opening = velocity;
    opening.tail(4) -= velocity.head(4);
    expect("velocities of the joints", Eigen::VectorXd(delassus_of_pile(masses) * impulses), opening, 1e-12,
           "m/s");
}

TEST_CASE("row sums: they count what pushes against each other, too")
{
    const Eigen::MatrixXd w = delassus_of_pile(equal_cubes(4));
    given(
        "four cubes of 10 kg: a row has 1/10 for the cube above its joint, 1/10 for that below, and the joints beside");
    expect("row sums", row_sums(w), Eigen::Vector4d(0.2, 0.4, 0.4, 0.3), 1e-15, "1/kg");
}

TEST_CASE("row sums: n pairs under one block have a share of its mass each")
{
    given("5 pairs under 10 kg");
    expect("row sums", row_sums(delassus_of_sole(5, 10)), Eigen::VectorXd(Eigen::VectorXd::Constant(5, 0.5)),
           1e-15, "1/kg");
}

TEST_CASE("row sums: D - W has no negative eigenvalue, whatever the bodies and pairs")
{
    for (int trial = 0; trial < 200; ++trial) {
        const Eigen::MatrixXd w = random_delassus(2 + trial % 12);
        const Eigen::MatrixXd rest = Eigen::MatrixXd(row_sums(w).asDiagonal()) - w;
        const double smallest = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(rest).eigenvalues().minCoeff();
        given("a random W of ", w.rows(), " pairs");
        expect_that("the smallest eigenvalue of D - W (" + readable(smallest) + ") is not negative",
                    smallest > -1e-12);
    }
}

TEST_CASE("round: a pair alone is stopped at once")
{
    const Eigen::VectorXd one = Eigen::VectorXd::Constant(1, 1.0);
    given("one cube of 4 kg that falls with 3 m/s");
    expect("impulse", answered_at_once(0.25 * one, -3 * one, 0.25 * one, 0 * one)(0), 12.0, 1e-12, "N s");
}

TEST_CASE("round: all pairs answer the same velocities, those of the round before")
{
    const Eigen::MatrixXd w = delassus_of_pile({1, 1});
    given("two cubes of 1 kg, both joints close with 1 m/s, divisors 4 and 5 1/kg, impulses 1 and 2 N s");
    // Joint 0 closes with -1 + 1 - 2 = -2 m/s, and joint 1 opens with -1 - 1 + 4 = 2 m/s.
    expect("impulses",
           answered_at_once(w, Eigen::Vector2d(-1, -1), Eigen::Vector2d(4, 5), Eigen::Vector2d(1, 2)),
           Eigen::Vector2d(1.5, 1.6), 1e-12, "N s");
}

TEST_CASE("round: no pair pulls")
{
    const Eigen::MatrixXd w = delassus_of_pile({1, 1});
    given("two cubes of 1 kg, joint 1 opens with 5 m/s, divisors 2 1/kg, no impulses");
    expect("impulses",
           answered_at_once(w, Eigen::Vector2d(0, 5), Eigen::Vector2d(2, 2), Eigen::Vector2d(0, 0)),
           Eigen::Vector2d(0, 0), 0, "N s");
}

TEST_CASE("round: with the row sums no round goes too far, whatever the bodies and pairs")
{
    for (int trial = 0; trial < 100; ++trial) {
        const Eigen::MatrixXd w = random_delassus(2 + trial % 9);
        const Eigen::VectorXd free = random_vector(w.rows());
        Eigen::VectorXd impulses = Eigen::VectorXd::Zero(w.rows());
        for (int round = 0; round < 20; ++round) {
            const double before = objective(w, free, impulses);
            impulses = answered_at_once(w, free, row_sums(w), impulses);
            given("a random W of ", w.rows(), " pairs, round ", round);
            expect_that("1/2 I W I + free I does not rise",
                        objective(w, free, impulses) <= before + 1e-12 * (1 + std::abs(before)));
        }
    }
}

TEST_CASE("rounds: what is answered already takes none")
{
    const Eigen::MatrixXd w = delassus_of_pile({1, 1});
    given("two cubes of 1 kg, joint 0 rests, joint 1 opens with 2 m/s");
    expect("rounds", rounds_until_answered(w, Eigen::Vector2d(0, 2), row_sums(w), 1e-6, 100), 0, 0);
}

TEST_CASE("rounds: pairs side by side under one block share it and need a single round")
{
    for (const int pairs : {1, 4, 25}) {
        const Eigen::MatrixXd w = delassus_of_sole(pairs, 3);
        given(pairs, " pairs under 3 kg, which falls with 1 m/s");
        expect("rounds",
               rounds_until_answered(w, Eigen::VectorXd(Eigen::VectorXd::Constant(pairs, -1)), row_sums(w),
                                     1e-9, 100),
               1, 0);
    }
}

TEST_CASE(
    "rounds: with twice its own entry as divisor a pair keeps half of its velocity, down to the tolerance")
{
    const auto rounds = [](double tolerance, int most) {
        const Eigen::MatrixXd one = Eigen::MatrixXd::Constant(1, 1, 1.0);
        return rounds_until_answered(one, Eigen::VectorXd::Constant(1, -1.0),
                                     Eigen::VectorXd::Constant(1, 2.0), tolerance, most);
    };
    for (const auto& [tolerance, expected] :
         {std::pair{0.2, 3}, {0.125, 4}, {0.01, 7}, {1e-3, 10}, {1e-9, 30}}) {
        given("1 kg that falls with 1 m/s, divisor 2 1/kg, tolerance ", tolerance, " m/s");
        expect("rounds", rounds(tolerance, 100), expected, 0);
    }
    for (const int most : {0, 2, 3, 4}) {
        given("the same, tolerance 0.2 m/s, at most ", most, " rounds");
        expect("rounds", rounds(0.2, most), std::min(most, 3), 0);
    }
}

TEST_CASE("rounds: the last pair counts as much as the first one, and no mean hides it")
{
    for (Eigen::Index slow = 0; slow < 4; ++slow) {
        Eigen::VectorXd divisors = Eigen::VectorXd::Ones(4), free = Eigen::VectorXd::Constant(4, -1);
        divisors(slow) = 2;
        given("4 pairs that do not touch each other, all of 1 kg and falling with 1 m/s; pair ", slow,
              " has the divisor 2 1/kg, the others 1 1/kg; tolerance 0.01 m/s");
        expect("rounds", rounds_until_answered(Eigen::MatrixXd::Identity(4, 4), free, divisors, 0.01, 100), 7,
               0);
    }
}

TEST_CASE("rounds: a pair that opens is answered only when it pushes no more, however little it pushed")
{
    const Eigen::MatrixXd w = delassus_of_sole(2, 3);
    given(
        "2 pairs under 3 kg, velocities -1 and -0.25 m/s, divisors 1/3 and 1e9 1/kg, tolerance 1e-6 m/s: "
        "after a round the second one opens with 0.75 m/s and pushes with 2.5e-10 N s");
    expect("rounds",
           rounds_until_answered(w, Eigen::Vector2d(-1, -0.25), Eigen::Vector2d(1.0 / 3, 1e9), 1e-6, 100), 2,
           0);
}

TEST_CASE("rounds: pairs that each take the whole block for themselves never agree")
{
    const Eigen::MatrixXd w = delassus_of_sole(4, 3);
    given("4 pairs under 3 kg, divisors 1/3 1/kg");
    const Eigen::VectorXd whole = w.diagonal();
    expect("rounds",
           rounds_until_answered(w, Eigen::VectorXd(Eigen::VectorXd::Constant(4, -1)), whole, 1e-9, 100), 100,
           0);
    say("4 pairs under one block: with the row sums 1 round, with all of its mass for each never");
}

TEST_CASE("rounds: two cubes are answered in as many rounds as their slower part needs")
{
    // D^-1 W = [[1/2 .. -1/2], [-1/3 .. 2/3]] has the eigenvalues 1
    // and 1/6: the error shrinks by 5/6 a round.
    const int rounds = rounds_of_pile(2);
    given("two cubes of 10 kg that fall with 0.1 m/s, until a millionth is left");
    expect("rounds", rounds, std::log(1e-6 / 0.1) / std::log(5.0 / 6), 4);
}

TEST_CASE("rounds: a pile twice as high needs about four times as many")
{
    const int ten = rounds_of_pile(10), twenty = rounds_of_pile(20);
    given("10 and 20 cubes of 10 kg that fall with 0.1 m/s");
    expect("rounds of 20 over rounds of 10", static_cast<double>(twenty) / ten, 4.0, 0.6);
    say("10 cubes: ", ten, " rounds, 20 cubes: ", twenty);
}
