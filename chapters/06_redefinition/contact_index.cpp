#include "chapters/06_redefinition/contact_index.hpp"

#include <algorithm>

namespace enduring {

void VertexContacts::fill(std::span<const Contact> contacts)
{
    entries_.clear();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const Contact& contact = contacts[i];
        if (contact.kind == ContactKind::vertex_face && !contact.resolved)
            entries_.push_back({contact.body_a, contact.feature_a, contact.body_b, static_cast<int>(i)});
    }
    // Of several, which only a list made by hand has, the first counts.
    std::sort(entries_.begin(), entries_.end(), [](const Entry& x, const Entry& y) {
        return std::tie(x.body_a, x.vertex, x.body_b, x.index) <
               std::tie(y.body_a, y.vertex, y.body_b, y.index);
    });
}

int VertexContacts::find(int body_a, int vertex, int body_b) const
{
    const auto key = std::tie(body_a, vertex, body_b);
    const auto found = std::lower_bound(
        entries_.begin(), entries_.end(), key,
        [](const Entry& entry, const auto& wanted) { return entry.key() < wanted; });
    return found != entries_.end() && found->key() == key ? found->index : -1;
}

}  // namespace enduring
