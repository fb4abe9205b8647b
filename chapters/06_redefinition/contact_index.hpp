#pragma once

#include "common/simulation/contact.hpp"

#include <span>
#include <tuple>

namespace enduring {

/// Finds the vertex-face contact of a vertex with a body: there is at most one that is not resolved. Looks
/// things up in logarithmic time, among the contacts there were when it was filled.
class VertexContacts {
public:
    VertexContacts() = default;
    explicit VertexContacts(std::span<const Contact> contacts) { fill(contacts); }

    /// Keeps its memory from one filling to the next.
    void fill(std::span<const Contact> contacts);

    /// Index into the list, -1 if the vertex has no pair with the body.
    int find(int body_a, int vertex, int body_b) const;

private:
    struct Entry {
        int body_a, vertex, body_b, index;
        auto key() const { return std::tie(body_a, vertex, body_b); }
    };
    std::vector<Entry> entries_;
};

}  // namespace enduring
