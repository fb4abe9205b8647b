#pragma once

#include "chapters/06_redefinition/experiments/motivating_scene.hpp"

namespace enduring::chapter06 {

/// One cell of the failure ledger: a scene under one chapter's solver.
struct LedgerCell {
    const MotivatingScene* scene;
    int chapter;  ///< 1 to 6
    Outcome outcome;

    bool passed() const { return passes(*scene, outcome.value); }
    bool expected_to_pass() const { return scene->expected[static_cast<std::size_t>(chapter - 1)] == 'p'; }
};

/// Whether a scene's expectation changes between this chapter and a neighbour: what is worth a picture. Where all agree,
/// the first and the last are.
bool at_border(const MotivatingScene& scene, int chapter);

/// The cells that came out differently than expected, one line each: "hooked under chapter 5 passes with 1.5 m/s (at least
/// 1.49 m/s), and was expected to fail". A cell that is expected to fail and passes is as wrong as the other way round.
std::vector<std::string> surprises(const std::vector<LedgerCell>& cells);

/// Runs scenes under all solvers.
/// @param borders_only   only those at_border
/// @param with_pictures  of those
std::vector<LedgerCell> fill_ledger(const std::vector<MotivatingScene>& scenes, bool borders_only, bool with_pictures);

}  // namespace enduring::chapter06
