#include "common/simulation/energy.hpp"

namespace enduring {

Energy total_energy(const World& world)
{
    Energy sum;
    for (const std::unique_ptr<Body>& body : world.bodies) {
        const Energy energy = body->energy(world.gravity);
        sum.kinetic += energy.kinetic;
        sum.gravitational += energy.gravitational;
        sum.elastic += energy.elastic;
    }
    sum.elastic += joint_energy(world);
    return sum;
}

double friction_spring_energy(const Contacts& contacts, const FrictionParameters& friction)
{
    const auto spring_of = [](const auto& model) {
        if constexpr (requires { model.spring; })
            return model.spring;
        else
            return 0.0;
    };
    const double spring = std::visit(spring_of, friction);
    double sum = 0;
    for (const Contact& contact : contacts)
        sum += 0.5 * spring * contact.spring.stretch.squaredNorm();
    return sum;
}

double spring_energy(const Contacts& contacts)
{
    double sum = 0;
    for (const Contact& contact : contacts)
        if (const double k = contact.spring.stiffness; k > 0)
            sum += 0.5 *
                   (contact.spring.load * contact.spring.load / k + k * contact.spring.stretch.squaredNorm());
    return sum;
}

}  // namespace enduring
