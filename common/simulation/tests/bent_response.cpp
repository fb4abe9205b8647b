#include "common/geometry/quadratic.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/simulation/deformable_body.hpp"

#include <doctest/doctest.h>

using namespace enduring;

namespace {

constexpr double dt = 0.01;

std::unique_ptr<DeformableBody> soft_bar()
{
    DeformableSettings settings;
    settings.material = {5e4, 0.3, 100};
    settings.impulse_response = ImpulseResponse::implicit;
    return std::make_unique<DeformableBody>("bar", with_edge_midpoints(bar({1, 0.2, 0.2}, {4, 1, 1})),
                                            settings);
}

/// All over the bar.
std::vector<int> touched_of(const Body& body)
{
    std::vector<int> touched;
    for (int vertex = 0; vertex < body.surface().vertex_count(); vertex += 3)
        touched.push_back(vertex);
    return touched;
}

/// A step in which one end, at +x, is pushed up or down.
void bend(DeformableBody& body, const std::vector<int>& touched, double impulse)
{
    body.predict(Vec3::Zero(), dt);
    double end = 0;
    for (const Vec3& x : body.positions_t0())
        end = std::max(end, x.x());
    for (const int vertex : touched)
        if (body.positions_t0()[static_cast<std::size_t>(vertex)].x() > end - 0.2)
            body.apply_impulse(vertex, {0, impulse, 0});
    body.update_prediction(dt);
    body.commit(dt);
}

/// By how much the mass of a bar that was asked for it after some steps, and again after others, is another
/// one than that of a bar which moved alike and was asked at the end only.
double difference(const std::vector<double>& before, const std::vector<double>& after)
{
    const auto asked = soft_bar(), other = soft_bar();
    const std::vector<int> touched = touched_of(*asked);
    const auto move = [&](const std::vector<double>& impulses) {
        for (const double impulse : impulses)
            for (DeformableBody* body : {asked.get(), other.get()})
                bend(*body, touched, impulse);
    };
    move(before);
    asked->predict(Vec3::Zero(), dt);
    asked->contact_mass(touched);
    move(after);
    asked->predict(Vec3::Zero(), dt);
    other->predict(Vec3::Zero(), dt);
    const Eigen::MatrixXd expected = other->contact_mass(touched).mass;
    return (asked->contact_mass(touched).mass - expected).norm() / expected.norm();
}

}  // namespace

TEST_CASE("contact mass: where few vertices have bent against all others it is found anew, too")
{
    for (const std::size_t steps : {3U, 6U})
        CHECK(difference({}, std::vector<double>(steps, 0.4)) <= 1e-9);
}

TEST_CASE("contact mass: a bend counts from where the mass was found, not from rest")
{
    for (const std::size_t steps : {1U, 2U})  // from the one side of rest to the other
        CHECK(difference(std::vector<double>(steps, 0.05), std::vector<double>(2 * steps, -0.05)) < 4e-3);
}
