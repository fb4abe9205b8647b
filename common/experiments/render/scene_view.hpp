#pragma once

#include "common/experiments/render/stage.hpp"
#include "common/scenes/scene.hpp"
#include "common/simulation/contact.hpp"

namespace enduring {

/// The bodies of a world at the committed state (positions_t0), its planes, and the scene's camera.
/// @param world  usually scene.world, or what became of it
/// @param scene  looks and camera; bodies it gives no look take the palette's colours in turn, static ones a
///               pale sand; open static surfaces show their triangles
Stage stage_of(const World& world, const Scene& scene);

/// Marks the features of contacts in the thesis' colours at
/// positions_t0: vertices red, faces blue, edges green.
void mark_contacts(Stage& stage, const World& world, const Contacts& contacts);

/// Surfaces with their triangles, and the pairs marked as above.
/// Held pairs, which take no impulse, are left out.
void mark_pairs(Stage& stage, const World& world, const Contacts& contacts);

/// Marks the same features in orange, for contacts that push as they should not.
void mark_artefacts(Stage& stage, const World& world, const Contacts& contacts);

}  // namespace enduring
