#include "exercises/05_categorisation/3_share_of_directions.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <cmath>
#include <numbers>

namespace enduring::chapter05 {

double predicted_share()
{
    not_implemented_yet("5.3");
}

std::vector<Vec3> even_directions(int count)
{
    not_implemented_yet("5.3");
}

double measured_share(const Corner& corner, int count)
{
    not_implemented_yet("5.3");
}

double law_of_share(const std::array<Vec3, 3>& normals)
{
    not_implemented_yet("5.3");
}

}  // namespace enduring::chapter05
