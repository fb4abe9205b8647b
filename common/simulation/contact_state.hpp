#pragma once

#include "common/simulation/contact.hpp"
#include "common/simulation/state_archive.hpp"

namespace enduring {

/// All that a pair holds, written or read.
inline void visit_state(StateArchive& archive, Contact& contact)
{
    archive.whole(contact.kind);
    for (int* index : {&contact.body_a, &contact.body_b, &contact.feature_a, &contact.feature_b})
        archive.whole(*index);
    for (int& vertex : contact.vertices)
        archive.whole(vertex);
    for (double& weight : contact.weights)
        archive(weight);
    archive(contact.orientation);
    archive(contact.start);
    archive(contact.impulse);
    archive(contact.friction);
    archive(contact.turning);
    archive(contact.spring.stretch);
    archive(contact.spring.slip);
    archive(contact.spring.stiffness);
    archive(contact.spring.rest_offset);
    archive(contact.spring.load);
    archive(contact.outward);
    archive(contact.sliding_normal);
    archive(contact.normal_t0);
    archive(contact.gap);
    archive.whole(contact.category);
    archive.whole(contact.state);
    archive.whole(contact.resolved);
    archive.whole(contact.began_open);
    static_assert(sizeof(Contact) == 288, "a field that is new in Contact has its line here, too");
}

}  // namespace enduring
