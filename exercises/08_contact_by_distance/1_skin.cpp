#include "exercises/08_contact_by_distance/1_skin.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace enduring {

double predicted_speed()
{
    not_implemented_yet("8.1");
}

double compression_at(const SkinnedPair& pair, double distance)
{
    not_implemented_yet("8.1");
}

ComingSurfaces after_pressed_step(const SkinnedPair& pair, const ComingSurfaces& start)
{
    not_implemented_yet("8.1");
}

double fastest_held(const SkinnedPair& pair)
{
    not_implemented_yet("8.1");
}

int halvings_for(SkinnedPair pair, double speed, int most)
{
    not_implemented_yet("8.1");
}

Vec3 inset_of_vertex(const std::vector<Vec3>& normals, double skin)
{
    not_implemented_yet("8.1");
}

}  // namespace enduring
