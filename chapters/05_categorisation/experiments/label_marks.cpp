#include "chapters/05_categorisation/experiments/label_marks.hpp"

namespace enduring::chapter05 {

void mark_by_label(Stage& stage, const World& world, const Contacts& contacts)
{
    for (Drawable& drawable : stage.bodies)
        drawable.wireframe = true;
    Contacts hooked, others;
    for (const Contact& contact : contacts)
        (contact.category == ContactCategory::hooked ? hooked : others).push_back(contact);
    mark_contacts(stage, world, others);
    mark_artefacts(stage, world, hooked);
}

}  // namespace enduring::chapter05
