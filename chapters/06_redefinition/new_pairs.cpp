#include "chapters/06_redefinition/new_pairs.hpp"

#include "chapters/06_redefinition/contact_index.hpp"

namespace enduring {
namespace {

/// Entries of one vertex into one body, one behind the other and the one to keep first: the earliest, and of
/// two at the same time the one that is not hooked.
bool comes_first(const Contact& one, const Contact& other)
{
    const auto key = [](const Contact& c) {
        return std::tuple(c.kind, c.body_a, c.body_b, c.feature_a,
                          c.kind == ContactKind::edge_edge ? c.feature_b : 0, c.start,
                          c.category == ContactCategory::hooked, c.feature_b);
    };
    return key(one) < key(other);
}

bool is_same_vertex(const Contact& one, const Contact& other)
{
    return one.kind == ContactKind::vertex_face && other.kind == ContactKind::vertex_face &&
           one.body_a == other.body_a && one.body_b == other.body_b && one.feature_a == other.feature_a;
}

}  // namespace

//! [admit]
void admit_new_pairs(const World& world, Contacts& contacts, std::size_t first_new,
                     Redefinitions& redefinitions)
{
    const auto first = contacts.begin() + static_cast<std::ptrdiff_t>(first_new);
    if (first == contacts.end())
        return;
    const VertexContacts in_contact(std::span<const Contact>(contacts).first(first_new));
    const auto superfluous = [&](const Contact& c) {
        return c.kind == ContactKind::vertex_face ? in_contact.find(c.body_a, c.feature_a, c.body_b) >= 0
                                                  : c.category != ContactCategory::regular;
    };
    contacts.erase(std::remove_if(first, contacts.end(), superfluous), contacts.end());
    std::sort(first, contacts.end(), comes_first);
    contacts.erase(std::unique(first, contacts.end(), is_same_vertex), contacts.end());

    for (auto pair = first; pair != contacts.end(); ++pair)
        if (pair->category == ContactCategory::hooked)
            redefine_hooked_entry(world, *pair, redefinitions);
}
//! [admit]

}  // namespace enduring
