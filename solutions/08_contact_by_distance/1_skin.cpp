#include "exercises/08_contact_by_distance/1_skin.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace enduring {

double predicted_speed() { return 10; }

double compression_at(const SkinnedPair& pair, double distance)
{
    return std::max(0.0, pair.skin_a + pair.skin_b - distance);
}

ComingSurfaces after_pressed_step(const SkinnedPair& pair, const ComingSurfaces& start)
{
    const double skins = pair.skin_a + pair.skin_b, free_end = start.distance - pair.dt * start.speed;
    const bool has_pair = start.distance < skins || free_end < 0;
    if (!has_pair || free_end >= skins)
        return {free_end, start.speed};
    const double end = skins - compression_at(pair, free_end) / (1 + pair.h);
    return {end, (start.distance - end) / pair.dt};
}

double fastest_held(const SkinnedPair& pair) { return pair.h * (pair.skin_a + pair.skin_b) / pair.dt; }

int halvings_for(SkinnedPair pair, double speed, int most)
{
    int halvings = 0;
    while (halvings < most && speed > fastest_held(pair)) {
        pair.dt /= 2;
        ++halvings;
    }
    return halvings;
}

Vec3 inset_of_vertex(const std::vector<Vec3>& normals, double skin)
{
    Mat3 planes = Mat3::Zero();
    Vec3 inwards = Vec3::Zero();
    for (const Vec3& normal : normals) {
        planes += normal * normal.transpose();
        inwards -= skin * normal;
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> own(planes);
    Vec3 move = Vec3::Zero();
    for (int i = 0; i < 3; ++i)
        if (own.eigenvalues()[i] > 0.01 * own.eigenvalues()[2])
            move += own.eigenvectors().col(i).dot(inwards) / own.eigenvalues()[i] * own.eigenvectors().col(i);
    return move;
}

}  // namespace enduring
