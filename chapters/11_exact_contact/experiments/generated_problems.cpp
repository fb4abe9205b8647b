#include "chapters/11_exact_contact/experiments/generated_problems.hpp"

#include "chapters/11_exact_contact/problem_of_step.hpp"

#include <cmath>
#include <optional>
#include <random>
#include <string>

namespace enduring::chapter11 {
namespace {

using Eigen::MatrixXd;
using Matrix = Eigen::SparseMatrix<double>;
using Eigen::VectorXd;

/// Numbers that are the same on every machine: the distributions of the standard library are not.
class Numbers {
public:
    explicit Numbers(unsigned seed) : engine_(seed) {}
    double from_to(double least, double most)
    {
        return least + (most - least) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
    int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }
    /// The sum of twelve, which is nearly normal.
    double normal()
    {
        double sum = 0;
        for (int i = 0; i < 12; ++i)
            sum += from_to(-0.5, 0.5);
        return sum;
    }
    Vec3 vector()
    {
        const double x = normal(), y = normal(), z = normal();
        return {x, y, z};
    }

private:
    std::mt19937_64 engine_;
};

struct Ball {
    Vec3 centre;
    double mass, inertia;
    Vec3 velocity, spin;  ///< without contact
};
struct Touch {
    int body, other;  ///< -1: what does not move
    Vec3 point, normal;
};

/// W and q, with the root of M in the levers, so that no mass is divided by.
FrictionProblem problem_from(const Matrix& levers, const VectorXd& motion, double mu)
{
    FrictionProblem problem;
    problem.response = levers.transpose() * levers;
    problem.free_velocity = levers.transpose() * motion;
    problem.mu = VectorXd::Constant(levers.cols() / 3, mu);
    return problem;
}

//! [problem_of]
FrictionProblem problem_of(const std::vector<Ball>& bodies, const std::vector<Touch>& touches, double mu)
{
    const auto count = static_cast<Eigen::Index>(bodies.size()),
               contacts = static_cast<Eigen::Index>(touches.size());
    std::vector<Eigen::Triplet<double>> levers;
    VectorXd motion(6 * count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const Ball& body = bodies[static_cast<std::size_t>(i)];
        motion.segment<3>(6 * i) = std::sqrt(body.mass) * body.velocity;
        motion.segment<3>(6 * i + 3) = std::sqrt(body.inertia) * body.spin;
    }
    for (Eigen::Index i = 0; i < contacts; ++i) {
        const Touch& touch = touches[static_cast<std::size_t>(i)];
        const Mat3 frame = contact_frame(touch.normal);
        const auto column = static_cast<int>(3 * i);
        for (const auto& [number, sign] : {std::pair{touch.body, 1.0}, std::pair{touch.other, -1.0}}) {
            if (number < 0)
                continue;
            const Ball& body = bodies[static_cast<std::size_t>(number)];
            const Vec3 arm = touch.point - body.centre;
            for (int k = 0; k < 3; ++k) {
                const Vec3 axis = sign * frame.row(k).transpose();
                const Vec3 shift = axis / std::sqrt(body.mass),
                           turn = arm.cross(axis) / std::sqrt(body.inertia);
                for (int j = 0; j < 3; ++j) {
                    levers.emplace_back(6 * number + j, column + k, shift[j]);
                    levers.emplace_back(6 * number + 3 + j, column + k, turn[j]);
                }
            }
        }
    }
    Matrix all(6 * count, 3 * contacts);
    all.setFromTriplets(levers.begin(), levers.end());
    return problem_from(all, motion, mu);
}
//! [problem_of]

/// @param shift  of each second cube to the side [m]
FrictionProblem tower(const std::vector<double>& masses, double shift = 0.03)
{
    std::vector<Ball> cubes;
    std::vector<Touch> touches;
    for (int i = 0; i < static_cast<int>(masses.size()); ++i) {
        const double mass = masses[static_cast<std::size_t>(i)];
        cubes.push_back({Vec3(i % 2 == 0 ? -shift * i : shift * i, 0.5 + i, 0.02 * i), mass, mass / 6,
                         Vec3(0.001 * i, -0.0981, 0), Vec3::Zero()});
        for (int corner = 0; corner < 4; ++corner)
            touches.push_back(
                {i, i - 1, Vec3(corner & 1 ? 0.45 : -0.45, i, corner & 2 ? 0.45 : -0.45), Vec3::UnitY()});
    }
    return problem_of(cubes, touches, 0.5);
}

/// Spheres at the places of a grid, moved by up to 0.15 of its width, that are pressed together.
FrictionProblem packing(int side, double spread, double mu, unsigned seed)
{
    Numbers numbers(seed);
    std::vector<Ball> spheres;
    for (int i = 0; i < side * side * side; ++i) {
        const Vec3 place(i % side, i / side % side, i / side / side);
        const double x = numbers.from_to(-0.15, 0.15), y = numbers.from_to(-0.15, 0.15),
                     z = numbers.from_to(-0.15, 0.15), mass = std::pow(10, numbers.from_to(-spread, spread));
        spheres.push_back({place + Vec3(x, y, z), mass, 0.1 * mass, Vec3::Zero(), Vec3::Zero()});
    }
    std::vector<Touch> touches;
    for (int i = 0; i < static_cast<int>(spheres.size()); ++i) {
        Ball& sphere = spheres[static_cast<std::size_t>(i)];
        for (int j = 0; j < i; ++j) {
            const Vec3 other = spheres[static_cast<std::size_t>(j)].centre;
            if ((sphere.centre - other).norm() < 1.12)
                touches.push_back(
                    {i, j, 0.5 * (sphere.centre + other), (sphere.centre - other).normalized()});
        }
        if (i / side % side == 0)
            touches.push_back({i, -1, sphere.centre - 0.5 * Vec3::UnitY(), Vec3::UnitY()});
        if (i % side == 0)
            touches.push_back({i, -1, sphere.centre - 0.5 * Vec3::UnitX(), Vec3::UnitX()});
        if (i % side == side - 1)
            touches.push_back({i, -1, sphere.centre + 0.5 * Vec3::UnitX(), -Vec3::UnitX()});
        sphere.velocity = Vec3(0, -0.0981, 0) + 0.02 * numbers.vector();
        sphere.spin = 0.02 * numbers.vector();
    }
    return problem_of(spheres, touches, mu);
}

FrictionProblem graph(int count, int contacts, double spread, double mu, unsigned seed)
{
    Numbers numbers(seed);
    std::vector<Ball> bodies;
    for (int i = 0; i < count; ++i) {
        const Vec3 centre = numbers.vector(), velocity = numbers.vector(), spin = numbers.vector();
        const double mass = std::pow(10, numbers.from_to(-spread, spread));
        bodies.push_back({centre, mass, mass * numbers.from_to(0.05, 0.3), velocity, spin});
    }
    std::vector<Touch> touches;
    for (int i = 0; i < contacts; ++i) {
        const int body = numbers.below(count), any = numbers.below(count + 1) - 1;
        const Vec3 arm = numbers.vector(), normal = numbers.vector();
        touches.push_back({body, any == body ? -1 : any,
                           bodies[static_cast<std::size_t>(body)].centre + 0.5 * arm, normal.normalized()});
    }
    return problem_of(bodies, touches, mu);
}

FrictionProblem dense(int contacts, int rank, double mu, unsigned seed)
{
    Numbers numbers(seed);
    MatrixXd levers(rank, 3 * contacts);
    for (double& x : levers.reshaped())
        x = numbers.normal() / std::sqrt(rank);
    VectorXd motion(rank);
    for (double& x : motion)
        x = numbers.normal();
    return problem_from(levers.sparseView(), motion, mu);
}

FrictionProblem scaled(FrictionProblem problem, unsigned seed)
{
    Numbers numbers(seed);
    VectorXd scale(problem.free_velocity.size());
    for (int i = 0; i < problem.contacts(); ++i)
        scale.segment<3>(3 * i).setConstant(numbers.below(2) == 0 ? 1e-3 : 1e3);
    problem.response =
        MatrixXd(scale.asDiagonal() * MatrixXd(problem.response) * scale.asDiagonal()).sparseView(0, 0);
    problem.free_velocity = scale.cwiseProduct(problem.free_velocity).eval();
    return problem;
}

/// Gives each problem its kind and a number.
class List {
public:
    void add(const std::string& kind, FrictionProblem problem)
    {
        std::string name = std::to_string(101 + all.size()).substr(1);
        name += '_';
        name += kind;
        all.push_back({kind, {std::move(name), std::move(problem)}});
    }
    std::vector<GeneratedProblem> all;
};

/// One heavy cube on top, heavy and light by turns, or each heavier than the one below it.
/// @param others  gives other ratios and other towers; none: 1e4 and 1e6
void add_towers(List& list, std::optional<Numbers> others)
{
    for (const int count : {2, 5, 10})
        for (const double exponent : {4.0, 6.0}) {
            const double ratio = std::pow(10, others ? exponent + others->from_to(-1, 0.3) : exponent),
                         shift = others ? others->from_to(0, 0.04) : 0.03;
            const auto size = static_cast<std::size_t>(count);
            std::vector<double> top(size, 1), turns(size, 1), rising(size);
            top.back() = ratio;
            for (std::size_t i = 0; i < size; ++i) {
                turns[i] = i % 2 == 0 ? ratio : 1;
                rising[i] = std::pow(ratio, static_cast<double>(i) / (count - 1));
            }
            list.add("tower", tower(top, shift));
            list.add("tower", tower(turns, shift));
            if (count > 2)
                list.add("tower", tower(rising, shift));
        }
}

}  // namespace

std::vector<GeneratedProblem> generated_problems(unsigned set)
{
    List list;
    add_towers(list, set == 0 ? std::nullopt : std::optional(Numbers(1000 * set)));
    unsigned seed = 1000 * set;
    for (const int side : {2, 3, 4})
        for (const double mu : {0.3, 0.8})
            for (const double spread : {0.0, 1.5})
                list.add("packing", packing(side, spread, mu, ++seed));
    for (const int count : {4, 10, 25})
        for (const int factor : {2, 4})
            for (const double spread : {0.0, 1.5})
                list.add("graph", graph(count, factor * count, spread, spread > 0 ? 0.4 : 0.9, ++seed));
    for (const int contacts : {10, 30, 60})
        for (const double part : {0.5, 1.5, 3.2})
            list.add("dense", dense(contacts, static_cast<int>(part * contacts), 0.6, ++seed));
    const unsigned of_set = 1000 * set;
    list.add("scaled", scaled(dense(10, 20, 0.5, of_set + 101), of_set + 1));
    list.add("scaled", scaled(dense(20, 70, 0.5, of_set + 102), of_set + 2));
    list.add("scaled", scaled(graph(10, 30, 0, 0.5, of_set + 103), of_set + 3));
    list.add("scaled", scaled(packing(3, 0, 0.5, of_set + 104), of_set + 4));
    list.add("scaled", scaled(tower({1, 100}), of_set + 5));
    return list.all;
}

}  // namespace enduring::chapter11
