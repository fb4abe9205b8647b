#pragma once

#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/run/probes.hpp"
#include "common/experiments/run/run.hpp"
#include "common/scenes/scene.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace enduring::motivating {

/// Watches a run and ends with one number. None where there is nothing to measure: a body that nothing holds
/// has no speed along the floor to keep.
class Gauge final : public Probe {
public:
    using Reading =
        std::function<void(std::optional<double>& value, const World&, const Contacts&, double dt)>;
    explicit Gauge(Reading reading) : reading_(std::move(reading)) {}
    void observe(const World& world, const Contacts& contacts, double dt) override
    {
        reading_(value_, world, contacts, dt);
    }
    std::optional<double> value() const { return value_; }

private:
    Reading reading_;
    std::optional<double> value_;
};

enum class Bound { at_least, at_most };

/// A scene that one chapter's solver fails and a later one passes: what
/// is measured on it, and where the line is.
struct MotivatingScene {
    std::string name;      ///< of the row
    std::string file;      ///< common/scenes/FILE.json
    std::string patch;     ///< change to it, as text
    std::string quantity;  ///< what the number is
    std::string unit;
    Bound bound;
    double limit;
    std::string reason;    ///< why the line is there
    std::string expected;  ///< of the chapters in order: 'p' passes, 'f' fails
    char with_bullet;      ///< the same of the Bullet library; '-': the question does not apply to it
    Gauge::Reading reading;
    std::vector<double> moments;  ///< worth a picture [s], ascending; the ledger shows the last
};

/// All of them, in the order of the chapters that they call for.
const std::vector<MotivatingScene>& motivating_scenes();

/// One of them.
/// @throws InputError  there is none of that name; lists those there are
const MotivatingScene& motivating_scene(const std::string& name);

bool passes(const MotivatingScene& scene, const std::optional<double>& value);

/// Where a chapter's solver is expected to fail it does so on purpose: its energy may grow.
RunLimits limits_of(const MotivatingScene& scene, int chapter);

/// "at most 10 mm"
std::string bound_text(const MotivatingScene& scene);

/// What came of a scene under one solver.
struct Outcome {
    std::optional<double> value;  ///< none if there was nothing to measure, or the run broke
    std::optional<Picture> picture;
    std::string broken;  ///< what stopped the run, empty if nothing did
};

using MakeSolver = std::function<Solver(const ContactParameters&)>;
/// A solver that takes over more of a scene than its contact parameters.
using PrepareScene = std::function<Solver(Scene&)>;

/// Runs a scene under a solver; one that has no joints runs it without them.
/// @param limits        see limits_of
/// @param with_picture  takes one at the last of the scene's moments, the pairs marked
Outcome try_scene(const MotivatingScene& scene, const MakeSolver& make, const RunLimits& limits = {},
                  bool with_picture = false);
Outcome try_scene(const MotivatingScene& scene, const PrepareScene& prepare, const RunLimits& limits = {},
                  bool with_picture = false);

}  // namespace enduring::motivating
