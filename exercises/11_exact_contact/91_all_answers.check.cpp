#include "exercises/11_exact_contact/91_all_answers.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <algorithm>
#include <cmath>

using namespace enduring;

namespace {

/// How far an impulse is from the rules: of Signorini, of the cone, and of friction against the slip.
double off_the_rules(const OneContact& contact, const Vec2& r)
{
    const Vec2 u = contact.W * r + contact.q;
    const double limit = contact.mu * r.y(), left = limit - std::abs(r.x());
    return std::max({-u.y(), -r.y(), std::abs(u.y() * r.y()), -left, std::abs(left * u.x()), r.x() * u.x()});
}

/// A rod of two metres whose lower end touches the ground; it leans by an angle whose tangent is given, its
/// lower end to the left.
OneContact rod(double mass, double tangent, double mu, const Vec2& q)
{
    const double angle = std::atan(tangent), x = -std::cos(angle), y = -std::sin(angle), inertia = mass / 3;
    Mat2 W;
    W << 1 / mass + y * y / inertia, -x * y / inertia, -x * y / inertia, 1 / mass + x * x / inertia;
    return {W, q, mu};
}

OneContact any(RandomInputs& random)
{
    const double coupling = random.number(-0.9, 0.9), tall = random.number(0.5, 2);
    Mat2 W;
    W << 1, coupling * std::sqrt(tall), coupling * std::sqrt(tall), tall;
    return {W, Vec2(random.number(-1, 1), random.number(-1, 1)), random.number(0, 2)};
}

}  // namespace

TEST_CASE("stopping and slipping: the velocities are those that were asked for")
{
    RandomInputs random(111);
    double stops = 0, leaves = 0, border = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const OneContact contact = any(random);
        stops = std::max(stops,
                         (contact.W * stopping(contact) + contact.q).norm() / stopping(contact).norm());
        for (const int side : {1, -1}) {
            const Vec2 r = slipping(contact, side);
            leaves = std::max(leaves, std::abs((contact.W * r + contact.q).y()) / r.norm());
            border = std::max(border, std::abs(r.x() + side * contact.mu * r.y()) / r.norm());
        }
    }
    given("200 contacts");
    expect("velocity that is left, over the impulse", stops, 0, 1e-12);
    expect("velocity away from the ground while it slips, over the impulse", leaves, 0, 1e-12);
    expect("friction off - side x mu x push, over the impulse", border, 0, 1e-12);
}

TEST_CASE("answers: each obeys the rules, and what leaves the ground has one of zero")
{
    RandomInputs random(112);
    double worst = 0;
    int without = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const OneContact contact = any(random);
        const auto answers = exact_answers(contact);
        for (const Vec2& r : answers)
            worst = std::max(worst, off_the_rules(contact, r));
        without += answers.empty() || (contact.q.y() > 0 && answers[0].norm() > 0) ? 1 : 0;
    }
    given("500 contacts; the worst of them");
    expect("off the rules", worst, 0, 1e-9);
    expect("contacts without an answer, or that leave and have none of zero", without, 0, 0);
}

TEST_CASE("answers: a block has one, which holds below the cone's border and slips beyond")
{
    const double mass = 2.0;
    const double mu = 0.4;
    const double down = 3.0;
    const auto block = [&](double along) {
        return exact_answers({Mat2::Identity() / mass, Vec2(along, -down), mu});
    };
    given("a block of ", mass, " kg that comes down with ", down, " m/s; mu is ", mu);
    for (const double part : {0.0, 0.5, 0.99, -0.7}) {
        const auto answers = block(part * mu * down);
        expect(in_words("answers with ", part, " of the speed at the border"), answers.size(), 1, 0);
        if (answers.size() == 1)
            expect("impulse", answers[0], Vec2(-part * mu * down * mass, down * mass), 1e-12, "N s");
    }
    for (const double part : {1.5, -4.0}) {
        const auto answers = block(part * mu * down);
        expect(in_words("answers with ", part, " of the speed at the border"), answers.size(), 1, 0);
        if (answers.size() == 1)
            expect("impulse", answers[0], Vec2(part > 0 ? -mu * down * mass : mu * down * mass, down * mass),
                   1e-12, "N s");
    }
}

TEST_CASE(
    "answers: a rod beyond Painleve's friction jams where it slides, and may fly or jam where it leaves")
{
    const double mass = 1.5;
    const double tangent = 2.0;
    const double angle = std::atan(tangent);
    const double critical = (1 + 3 * std::cos(angle) * std::cos(angle)) /
                            (3 * std::sin(angle) * std::cos(angle));
    const double slow = 0.02, slide = -1.0;
    given("a rod of ", mass, " kg and 2 m that leans with a tangent of ", tangent,
          " and slides with its lower end ahead");
    const auto answers = [&](double part, double away) {
        return exact_answers(rod(mass, tangent, part * critical, Vec2(slide, away)));
    };
    const auto slides = answers(0.8, -slow);
    expect("answers below the critical friction", slides.size(), 1, 0);
    say("below the critical friction a rod that slides has ", slides.size(), " answer");
    const auto jams = answers(1.2, -slow);
    expect("answers beyond it", jams.size(), 1, 0);
    if (jams.size() == 1 && slides.size() == 1) {
        expect_that(
            "there it stops",
            (rod(mass, tangent, 1.2 * critical, Vec2(slide, -slow)).W * jams[0] + Vec2(slide, -slow)).norm() <
                1e-9);
    }
    expect("answers where its end leaves the ground, beyond it", answers(1.2, slow).size(), 3, 0);
    expect("and below", answers(0.8, slow).size(), 1, 0);
}
