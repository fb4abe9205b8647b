#pragma once

#include "common/experiments/report/chapter_program.hpp"
#include "common/scenes/scene.hpp"

#include <functional>
#include <string>
#include <vector>

namespace enduring::chapter13 {

using MakeMethod = std::function<Solver(const ContactParameters&)>;

/// A column: a method of this chapter with its paper's defaults, or chapter 10 beside them.
struct Answering {
    std::string title;
    MakeMethod make;
};
const std::vector<Answering>& all_answering();
/// Chapter 10 in one thread, which reports nothing.
Solver quiet_chapter10(const ContactParameters& parameters);

/// What a scene is asked: a number, and whether it is right as physics.
struct Answer {
    double value = 0;
    bool right = false;
};

/// A row of a table: a question that each method answers.
struct Question {
    std::string scene, quantity;
    /// @throws InputError  the method has no answer; says why
    std::function<Answer(const MakeMethod&)> ask;
};

/// "drift [µm/s]" for drift_um_per_s, as a reader reads it.
std::string with_unit(std::string quantity);
/// A number with a mark for right or wrong; "lost" if it is none.
std::string cell_of(double value, bool right);

/// A scene that a method refuses: the page lists each reason once.
struct Refusal {
    std::string scene, method, reason;
};
/// NAME_not_defined: reasons, with the scenes and methods to which each applies.
void report_refusals(Report& report, const std::string& name, const std::vector<Refusal>& refusals);

/// Asks all of them all questions: tables NAME and NAME_not_defined, and facts scene_method. A part of the
/// runs leaves no table.
/// @return  whether the tables are there
bool report_answers(const RunOptions& options, Report& report, const std::string& name,
                    const std::vector<Question>& questions);

}  // namespace enduring::chapter13
