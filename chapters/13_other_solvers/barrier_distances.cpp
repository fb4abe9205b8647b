#include "chapters/13_other_solvers/barrier_distances.hpp"

#include "common/geometry/closest_points.hpp"

#include <Eigen/LU>

#include <vector>

namespace enduring {
namespace {

/// Sine of two edges, below which nearest points inside both mean nothing. A tenth: the Hessian is wrong in
/// the sixth digit.
constexpr double least_sine = 1e-5;

Vec3 sum_of(const std::array<double, 4>& weights, const FourPoints& x)
{
    return weights[0] * x[0] + weights[1] * x[1] + weights[2] * x[2] + weights[3] * x[3];
}

/// A direction beta along a feature: how the weights change.
using WeightChange = Eigen::Vector4d;

/// The free directions along both features: from the first corner that has a part to each further one.
std::vector<WeightChange> directions_of(const std::array<double, 4>& weights)
{
    std::vector<WeightChange> directions;
    for (const double sign : {1.0, -1.0}) {
        int first = -1;
        for (int i = 0; i < 4; ++i) {
            if (sign * weights[static_cast<std::size_t>(i)] <= 0)
                continue;
            if (first < 0)
                first = i;
            else
                directions.emplace_back(WeightChange::Unit(i) - WeightChange::Unit(first));
        }
    }
    return directions;
}

}  // namespace

NearestPoints nearest_of_point_triangle(const FourPoints& x)
{
    const auto [w0, w1, w2] = closest_on_triangle(x[0], x[1], x[2], x[3]).weights;
    NearestPoints nearest{{1, -w0, -w1, -w2}, {}};
    nearest.difference = sum_of(nearest.weights, x);
    return nearest;
}

NearestPoints nearest_of_edges(const FourPoints& x)
{
    if (const auto inside = closest_inside_edges(x[0], x[1], x[2], x[3], least_sine))
        return {{1 - inside->s, inside->s, inside->t - 1, -inside->t}, inside->difference};
    NearestPoints nearest;
    for (std::size_t end = 0; end < 4; ++end) {
        const std::size_t first = end < 2 ? 2 : 0;  // of the other edge
        const auto [w0, w1, w2] = closest_on_triangle(x[end], x[first], x[first + 1], x[first + 1]).weights;
        const double sign = end < 2 ? 1 : -1;
        NearestPoints at_end;
        at_end.weights[end] = sign;
        at_end.weights[first] = -sign * w0;
        at_end.weights[first + 1] = -sign * (w1 + w2);
        at_end.difference = sum_of(at_end.weights, x);
        if (end == 0 || at_end.difference.squaredNorm() < nearest.difference.squaredNorm())
            nearest = at_end;
    }
    return nearest;
}

//! [squared_distance]
Derivatives squared_distance(const FourPoints& x, const NearestPoints& nearest)
{
    const Vec3& v = nearest.difference;
    const Eigen::Map<const Eigen::Vector4d> w(nearest.weights.data());
    Derivatives d;
    d.value = v.squaredNorm();
    for (int i = 0; i < 4; ++i) {
        d.gradient.segment<3>(3 * i) = 2 * w[i] * v;
        for (int j = 0; j < 4; ++j)
            d.hessian.block<3, 3>(3 * i, 3 * j).diagonal().setConstant(2 * w[i] * w[j]);
    }
    const std::vector<WeightChange> directions = directions_of(nearest.weights);
    const int count = static_cast<int>(directions.size());
    using Along = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 2>;
    Along along(3, count);  // how p - q moves with beta
    Eigen::Matrix<double, 12, Eigen::Dynamic, 0, 12, 2> mixed(12, count);
    for (int k = 0; k < count; ++k) {
        const WeightChange& by = directions[static_cast<std::size_t>(k)];
        along.col(k) = by[0] * x[0] + by[1] * x[1] + by[2] * x[2] + by[3] * x[3];
        for (int i = 0; i < 4; ++i)
            mixed.block<3, 1>(3 * i, k) = 2 * (w[i] * along.col(k) + by[i] * v);
    }
    if (count > 0) {
        const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 2, 2> inner = 2 * along.transpose() *
                                                                                     along;
        d.hessian -= mixed * inner.inverse() * mixed.transpose();
    }
    return d;
}
//! [squared_distance]

Derivatives edge_mollifier(const FourPoints& x, double least)
{
    const Vec3 u = x[1] - x[0], w = x[3] - x[2];
    const double c = u.cross(w).squaredNorm(), uw = u.dot(w);
    if (c >= least)
        return {1, Vector12::Zero(), Matrix12::Zero()};
    Eigen::Matrix<double, 6, 1> gradient;  // of c = u^2 w^2 - (u w)^2
    gradient << 2 * (w.squaredNorm() * u - uw * w), 2 * (u.squaredNorm() * w - uw * u);
    Eigen::Matrix<double, 6, 6> hessian;
    hessian.topLeftCorner<3, 3>() = 2 * (w.squaredNorm() * Mat3::Identity() - w * w.transpose());
    hessian.bottomRightCorner<3, 3>() = 2 * (u.squaredNorm() * Mat3::Identity() - u * u.transpose());
    hessian.topRightCorner<3, 3>() = 4 * u * w.transpose() - 2 * w * u.transpose() -
                                     2 * uw * Mat3::Identity();
    hessian.bottomLeftCorner<3, 3>() = hessian.topRightCorner<3, 3>().transpose();
    const double slope = 2 / least * (1 - c / least), bend = -2 / (least * least);
    const Eigen::Matrix<double, 6, 1> by_u_w = slope * gradient;
    const Eigen::Matrix<double, 6, 6> twice = bend * gradient * gradient.transpose() + slope * hessian;
    Eigen::Matrix<double, 6, 12> ends = Eigen::Matrix<double, 6, 12>::Zero();  // u and w by the four ends
    for (int edge = 0; edge < 2; ++edge) {
        ends.block<3, 3>(3 * edge, 6 * edge) = -Mat3::Identity();
        ends.block<3, 3>(3 * edge, 6 * edge + 3) = Mat3::Identity();
    }
    const double part = c / least;
    return {part * (2 - part), ends.transpose() * by_u_w, ends.transpose() * twice * ends};
}

}  // namespace enduring
