#include "exercises/11_exact_contact/91_all_answers.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <Eigen/LU>

#include <cmath>

namespace enduring {

Vec2 stopping(const OneContact& contact)
{
    not_implemented_yet("11.91");
}

Vec2 slipping(const OneContact& contact, int side)
{
    not_implemented_yet("11.91");
}

std::vector<Vec2> exact_answers(const OneContact& contact)
{
    not_implemented_yet("11.91");
}

}  // namespace enduring
