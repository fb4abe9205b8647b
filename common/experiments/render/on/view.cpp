#include "common/experiments/render/on/view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring {

Ball ball_around(const Stage& stage)
{
    std::vector<Vec3> points;
    for (const Drawable& body : stage.bodies)
        if (body.casts_shadow)
            points.insert(points.end(), body.positions.begin(), body.positions.end());
    if (points.empty())
        points = points_of(stage);
    Eigen::AlignedBox3d box;
    for (const Vec3& point : points)
        box.extend(point);
    Ball ball;
    if (points.empty())
        return ball;
    ball.centre = box.center();
    ball.radius = 0;
    for (const Vec3& point : points)
        ball.radius = std::max(ball.radius, 1.01 * (point - ball.centre).norm());
    if (ball.radius == 0)
        ball.radius = 0.1 * (stage.camera.eye - ball.centre).norm();
    return ball;
}

Eigen::Matrix4d view_projection(const Camera& camera, const Ball& ball, double aspect)
{
    Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
    view.row(0).head<3>() = camera.right();
    view.row(1).head<3>() = camera.true_up();
    view.row(2).head<3>() = -camera.forward();
    view.topRightCorner<3, 1>() = -view.topLeftCorner<3, 3>() * (camera.eye - ball.centre);

    const double distance = (camera.eye - ball.centre).norm();
    const double near = std::max(0.02 * distance, 0.5 * (distance - 4 * ball.radius)),
                 far = distance + 100 * ball.radius;
    const double cotangent = 1 / std::tan(camera.field_of_view_deg * std::numbers::pi / 360);
    Eigen::Matrix4d projection = Eigen::Matrix4d::Zero();
    projection(0, 0) = cotangent / aspect;
    projection(1, 1) = cotangent;
    projection(2, 2) = -(far + near) / (far - near);
    projection(2, 3) = -2 * far * near / (far - near);
    projection(3, 2) = -1;
    return projection * view;
}

double pleasant_spacing(double about)
{
    const double power = std::pow(10, std::floor(std::log10(about)));
    const double leading = about / power;
    return power * (leading < 1.5 ? 1 : leading < 3.5 ? 2 : leading < 7.5 ? 5 : 10);
}

TriangleSoup ground_soup(const Ground& ground, const Ball& ball)
{
    const Vec3 x = 90 * ball.radius * ground.normal.unitOrthogonal(), y = ground.normal.cross(x);
    const Vec3 foot = ground.point - ball.centre - (ground.point - ball.centre).dot(x) / x.squaredNorm() * x -
                      (ground.point - ball.centre).dot(y) / y.squaredNorm() * y;
    TriangleSoup soup;
    for (const Vec3& corner : {Vec3(x), Vec3(y), Vec3(-x), Vec3(x), Vec3(-x), Vec3(-y)})
        soup.push_back({(foot + 1.4 * corner).cast<float>(), ground.normal.cast<float>(),
                        Eigen::Vector3f::Ones(), Eigen::Vector3f::Ones()});
    return soup;
}

}  // namespace enduring
