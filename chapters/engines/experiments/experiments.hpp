#pragma once

#include "common/experiments/report/chapter_program.hpp"

namespace enduring::engines {

/// Every case under every engine that is here, with its default settings and with its documented best.
void rows(const RunOptions& options, Report& report);
/// Error over processor time, as each engine's steps and iterations are varied.
void curves(const RunOptions& options, Report& report);
/// A pyramid of 105 to 5,050 cubes under every engine that is here: how far it moves, and how long a frame
/// takes.
void growth(const RunOptions& options, Report& report);
/// The tables of the book: what rows, curves and growth measured where all engines are installed, kept in
/// chapters/engines/measured.
void measured(const RunOptions& options, Report& report);

}  // namespace enduring::engines
