#include "common/simulation/body.hpp"

namespace enduring {
namespace {

/// What does not move does not answer.
class TrialOfAStaticBody final : public Trial {
public:
    explicit TrialOfAStaticBody(const Body& body) : body_(body) {}
    void push(int, const Vec3&) override {}
    Vec3 velocity(int vertex) override { return body_.velocity(vertex); }

private:
    const Body& body_;
};

}  // namespace

std::vector<double> state_of(Body& body)
{
    StateArchive writer;
    body.visit_state(writer);
    return writer.numbers();
}

void restore_state(Body& body, const std::vector<double>& numbers)
{
    StateArchive reader(numbers);
    body.visit_state(reader);
}

Vec3 Body::centre() const
{
    Vec3 sum = Vec3::Zero();
    for (const Vec3& x : positions_t0_)
        sum += x;
    return sum / static_cast<double>(std::max<std::size_t>(1, positions_t0_.size()));
}

std::unique_ptr<Trial> Body::begin_trial() const { return std::make_unique<TrialOfAStaticBody>(*this); }

const MassParts& Body::mass_parts() const
{
    static const MassParts one_part;
    return one_part;
}

ContactCoordinates& Body::contact_coordinates()
{
    static ContactCoordinates none;
    return none;
}

InnerForces& Body::inner_forces()
{
    static InnerForces none;
    return none;
}

}  // namespace enduring
