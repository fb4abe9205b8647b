#include "exercises/08_contact_by_distance/1_skin.hpp"

#include <Eigen/SVD>

namespace enduring {

double predicted_speed() { return 10; }

double compression_at(const SkinnedPair& pair, double distance)
{
    const double gap = distance - pair.skin_a - pair.skin_b;
    return gap < 0 ? -gap : 0;
}

ComingSurfaces after_pressed_step(const SkinnedPair& pair, const ComingSurfaces& start)
{
    const ComingSurfaces free{start.distance - pair.dt * start.speed, start.speed};
    if (compression_at(pair, start.distance) == 0 && free.distance >= 0)
        return free;
    // (1 + h) v' = v + h gap / dt, from the impulse k dt (dt v' - gap) on the mass m
    const double gap = start.distance - pair.skin_a - pair.skin_b;
    const double pressed = (start.speed + pair.h * gap / pair.dt) / (1 + pair.h);
    const double speed = compression_at(pair, free.distance) > 0 ? pressed : start.speed;
    return {start.distance - pair.dt * speed, speed};
}

double fastest_held(const SkinnedPair& pair)
{
    return (pair.skin_a + pair.skin_b) * ((1 + pair.h) / pair.dt - 1 / pair.dt);
}

int halvings_for(SkinnedPair pair, double speed, int most)
{
    if (most == 0 || speed <= fastest_held(pair))
        return 0;
    pair.dt *= 0.5;
    return 1 + halvings_for(pair, speed, most - 1);
}

Vec3 inset_of_vertex(const std::vector<Vec3>& normals, double skin)
{
    const auto count = static_cast<Eigen::Index>(normals.size());
    Eigen::MatrixXd planes(count, 3);
    for (Eigen::Index i = 0; i < count; ++i)
        planes.row(i) = normals[static_cast<std::size_t>(i)];
    Eigen::JacobiSVD<Eigen::MatrixXd> svd(planes, Eigen::ComputeThinU | Eigen::ComputeThinV);
    svd.setThreshold(0.1);
    return svd.solve(Eigen::VectorXd::Constant(count, -skin));
}

}  // namespace enduring
