#pragma once

#include "chapters/motivating_scenes/motivating_scene.hpp"

namespace enduring::solvers {

using namespace motivating;

/// One cell of the failure ledger: a scene under one chapter's solver.
struct LedgerCell {
    const MotivatingScene* scene;
    int chapter;  ///< 1 to 7
    Outcome outcome;

    bool passed() const { return passes(*scene, outcome.value); }
    bool expected_to_pass() const { return scene->expected[chapter - 1] == 'p'; }
};

/// Whether a scene's expectation changes between this chapter and a neighbour: what is worth a picture. Where
/// all agree, the first and the last are.
bool at_border(const MotivatingScene& scene, int chapter);

/// The cells that came out differently than expected, one line each: "hooked under chapter 5
/// passes with 1.5 m/s (at least 1.49 m/s), and was expected to fail". A cell that is
/// expected to fail and passes is as wrong as the other way round.
std::vector<std::string> surprises(const std::vector<LedgerCell>& cells);

/// A scene under one chapter's solver.
Outcome try_chapter(const MotivatingScene& scene, int chapter, bool with_picture = false);

/// Runs scenes under all solvers.
/// @param borders_only   only those at_border
/// @param with_pictures  of those
std::vector<LedgerCell> fill_ledger(const std::vector<MotivatingScene>& scenes, bool borders_only,
                                    bool with_pictures);

}  // namespace enduring::solvers
