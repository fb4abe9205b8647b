#pragma once

#include "chapters/motivating_scenes/motivating_scene.hpp"
#include "chapters/solvers/chapter_solver.hpp"

namespace enduring::solvers {

using namespace motivating;

/// The ledger's column behind those of the chapters: the Bullet library, to compare with.
constexpr int bullet_column = last_chapter + 1;

/// What is expected of a scene in a column: 'p' passes, 'f' fails, '-' the question does not apply.
char expectation(const MotivatingScene& scene, int column);

/// "chapter 3", or "Bullet"
std::string solver_name(int column);

/// One cell of the failure ledger: a scene under one solver.
struct LedgerCell {
    const MotivatingScene* scene;
    int column;  ///< the chapter, from 1 on, or bullet_column
    Outcome outcome;

    bool passed() const { return passes(*scene, outcome.value); }
    bool expected_to_pass() const { return expectation(*scene, column) == 'p'; }
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

/// A scene under Bullet.
Outcome try_bullet(const MotivatingScene& scene, bool with_picture = false);

/// Runs scenes under all solvers, and under Bullet where the question applies.
/// @param borders_only   of the chapters only those at_border
/// @param with_pictures  of those, and of Bullet
std::vector<LedgerCell> fill_ledger(const std::vector<MotivatingScene>& scenes, bool borders_only,
                                    bool with_pictures);

}  // namespace enduring::solvers
