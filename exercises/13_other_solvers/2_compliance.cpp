#include "exercises/13_other_solvers/2_compliance.hpp"
#include "exercises/not_implemented_yet.hpp"

namespace enduring {

double multiplier_change(double error, double multiplier, double response, double compliance, double dt)
{
    not_implemented_yet("13.2");
}

BlockOnFloor substep(const BlockOnFloor& block, double compliance, double dt, int iterations)
{
    not_implemented_yet("13.2");
}

double implicit_velocity(const BlockOnFloor& block, double compliance, double dt)
{
    not_implemented_yet("13.2");
}

double rest_depth(double mass, double compliance)
{
    not_implemented_yet("13.2");
}

double compliance_for(double mass, int contacts, double depth)
{
    not_implemented_yet("13.2");
}

}  // namespace enduring
