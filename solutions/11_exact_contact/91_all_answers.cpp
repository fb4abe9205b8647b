#include "exercises/11_exact_contact/91_all_answers.hpp"

#include <Eigen/LU>

#include <cmath>

namespace enduring {

Vec2 stopping(const OneContact& contact) { return -(contact.W.inverse() * contact.q); }

Vec2 slipping(const OneContact& contact, int side)
{
    const Vec2 border(-side * contact.mu, 1);
    const double stiff = contact.W.row(1).dot(border);
    return -contact.q.y() / stiff * border;
}

std::vector<Vec2> exact_answers(const OneContact& contact)
{
    std::vector<Vec2> answers;
    if (contact.q.y() >= 0)
        answers.push_back(Vec2::Zero());
    const Vec2 stop = stopping(contact);
    if (stop.y() > 0 && std::abs(stop.x()) <= contact.mu * stop.y())
        answers.push_back(stop);
    for (const int side : {1, -1}) {
        const Vec2 slip = slipping(contact, side);
        const double speed = contact.W.row(0).dot(slip) + contact.q.x();
        if (slip.y() > 0 && side * speed > 0)
            answers.push_back(slip);
    }
    return answers;
}

}  // namespace enduring
