#pragma once

#include "chapters/engines/engine.hpp"

#include <string>
#include <vector>

namespace enduring::engines {

/// What a run is asked, and whether the answer is right as physics, not as a matter of taste.
struct Measure {
    std::string quantity;  ///< with its unit: "depth_um"
    double value = 0;
    bool right = false;
};

/// A scene, or some of a kind, that every engine can take.
struct Case {
    std::string name;  ///< a word: "stack"
    std::string asks;  ///< in words
    int runs = 1;
    std::function<Scene(int run)> make;
    std::function<std::vector<Measure>(int run, const EngineScene&, const Trajectory&)> judge;
};

/// Scene::duration says how long each is run.
std::vector<Case> all_cases(bool quick);
/// One of them. @throws std::out_of_range
const Case& case_named(const std::vector<Case>& cases, const std::string& name);

/// What came of a case: of several runs the largest values; of counts the sum.
struct Verdict {
    std::vector<Measure> measures;
    double ms = 0;  ///< processor time of a frame at rest [ms]
};
/// An engine that fails, or whose bodies are nowhere, is wrong in everything, by infinity.
Verdict try_case(const Case& asked, const Engine& engine, const Way& way);

}  // namespace enduring::engines
