#include "exercises/09_deep_contacts/2_ties.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>

namespace enduring {
namespace {

int sign(std::int64_t number) { return (number > 0) - (number < 0); }

}  // namespace

int side_of_line(const LatticePoint& p, const LatticePoint& a, const LatticePoint& b, int shift)
{
    not_implemented_yet("9.2");
}

int crosses(const LatticePoint& p, const LatticePoint& q, const LatticePoint& a, const LatticePoint& b,
            int shift)
{
    not_implemented_yet("9.2");
}

int winding_number(const LatticePoint& point, const LatticePolygon& polygon, int shift)
{
    not_implemented_yet("9.2");
}

}  // namespace enduring
