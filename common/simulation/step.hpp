#pragma once

#include "common/simulation/body.hpp"
#include "common/simulation/contact.hpp"
#include "common/simulation/joint.hpp"
#include "common/simulation/material_restitution.hpp"
#include "common/simulation/step_work.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace enduring {

/// An analytic half space: everything below the plane is inside.
struct Plane {
    std::string name;
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::UnitY();  ///< unit length, points out
    /// k of one vertex on it [N/m], positive; without it, that of all pairs
    std::optional<double> stiffness{};
    int material = MaterialFriction::none;  ///< by its place among the scene's
    Grain grain{};
};

/// Why a step is thrown away.
enum class StepTrouble : std::uint8_t {
    none,
    turns_too_far,
    unsolved,
    too_deep,
    unanswered,
    gains_energy,
    not_finite
};

/// An impulse on a vertex of a body [N s] that no other body has given.
struct OutsideImpulse {
    std::size_t body;
    int vertex;
    Vec3 impulse;
};

/// How the step goes that is being taken. A pass that sees trouble says so here.
struct StepAttempt {
    bool may_be_halved = false;  ///< trouble throws it away; else its end is taken as it is
    StepTrouble trouble = StepTrouble::none;
    bool is_kept_unsolved = false;  ///< a shorter one would not be solved either
    double springs = 0;             ///< energy that springs held when it began [J]
    /// energy that came in on purpose: by a rule that winds springs up, by bodies that move as given [J]
    double added_energy = 0;
    double behind = 0;                           ///< what of the whole step comes behind this part [s]
    int responses_left = 0;                      ///< that may still answer what passes of detection find
    std::vector<OutsideImpulse> from_outside{};  ///< in this step: their work counts as added_energy
    /// groups of bodies that joints hold together, in a part that is not halved any more: what pushes them is
    /// not found, so they do not move in it
    std::vector<std::vector<int>> held_up{};
    StepWork work{};  ///< what it has cost so far
};

/// The bodies and planes of a scene, and where time stands.
struct World {
    std::vector<std::unique_ptr<Body>> bodies;
    std::vector<Plane> planes;
    std::vector<Joint> joints;  ///< between bodies, or a body and the world; for a solver that has them
    std::vector<double> skins;  ///< of the bodies, as the run began [m]; a solver that has them writes them
    Vec3 gravity{0, -9.81, 0};  ///< [m/s^2]
    double time = 0;            ///< of the committed state [s]
    int step = 0;               ///< steps committed so far
    StepAttempt attempt;        ///< at the next one, or how the last one ended
    StepWork work;              ///< what the last step has cost, with the attempts that were thrown away
    long thrown_away = 0;       ///< attempts that were taken again in halves
    long ended_badly = 0;       ///< steps, or parts of steps, that could not be halved any more
    double whole_dt = 0;        ///< of the step that is taken, of which an attempt may be a part [s]
    int learned_halvings = 0;   ///< with which a step begins: longer parts were not solved before
    double driven = 0;          ///< work of all that drives bodies from outside but gravity, so far [J]
    MaterialFriction friction;  ///< between the materials of bodies and planes, if they have any
    MaterialRestitution restitution;
};

/// Pushes a vertex of a body, from a pass; the step's energy takes the work of the push for what was put in
/// on purpose.
void push_from_outside(World& world, std::size_t body, int vertex, const Vec3& impulse);

/// A layer of the course works as a pass: a plain function over the world and the one list of contacts.
struct Pass {
    using Function = std::function<void(World&, Contacts&, double dt)>;

    std::string name;  ///< names its row in the timing tables
    Function run;
};

/// When in a step a pass runs.
enum class StepStage {
    refresh,      ///< once, before any detection: resolve, dismiss or redefine the pairs that endure
    detect,       ///< append new crossings as waiting contacts
    respond,      ///< give every waiting contact its impulses; the step applies them, all together
    finish,       ///< once, from the last prediction, before it becomes the state: friction anchors move
    after_commit  ///< once, when the prediction is the state: velocities may change (Body::kick()), and
                  ///< nothing moves
};

/// A chapter's solver is its lists of passes, so "what did this chapter add?" reads as one more line: a
/// chapter takes the solver of the one before and adds, replaces or removes passes by name. No two passes
/// share a name, in all stages together.
///
/// Whatever names a pass throws std::invalid_argument, with the passes there are, if that name is not there;
/// and so does whatever brings one, if its name is taken.
class Solver {
public:
    std::string name;
    /// How often a step may be halved that does not end well (StepTrouble). None: every step is taken as it
    /// comes.
    int max_halvings = 0;
    /// How often a step answers what its own answers brought about (thesis 3.3, item 4).
    int max_responses = 5;
    /// The furthest that a body may turn in a step that may be halved [rad].
    double max_turn = 0.5;
    bool finds_stiffness = false;   ///< of each pair: a scene's has no effect
    bool can_resume = false;        ///< all that lasts from step to step stands in the world and its pairs
    bool has_joints = false;        ///< it holds the world's joints
    bool has_frames = false;        ///< its pairs need no inside: bodies may be points and edges alone
    bool has_surface_laws = false;  ///< it knows SurfaceLaws and Grain
    bool exact = false;             ///< its springs give nothing: a load is held at no depth

    Solver() = default;
    Solver(std::string of_solver, const std::vector<Pass>& refresh, const std::vector<Pass>& detect,
           const std::vector<Pass>& respond, const std::vector<Pass>& finish = {});

    /// In the order in which they run.
    const std::vector<Pass>& passes(StepStage stage) const { return lists_[static_cast<std::size_t>(stage)]; }
    const Pass& pass(const std::string& called) const;

    void append(StepStage stage, Pass pass);  ///< behind all others of its stage
    void insert_before(const std::string& called, Pass pass);
    void replace(const std::string& called, Pass pass);  ///< it may have the same name
    void remove(const std::string& called);
    /// Something around a pass, or in its place: `around` is given what the pass does.
    using Around = std::function<void(const Pass::Function& inner, World&, Contacts&, double dt)>;
    void wrap(const std::string& called, std::string pass, Around around);

    void append(StepStage stage, std::string pass, Pass::Function run);
    void insert_before(const std::string& called, std::string pass, Pass::Function run);
    void replace(const std::string& called, std::string pass, Pass::Function run);

private:
    using Place = std::pair<std::size_t, std::size_t>;  ///< list, and index into it

    Place place_of(const std::string& called) const;
    void require_free(const std::string& called) const;
    std::string all_names() const;

    std::array<std::vector<Pass>, 5> lists_;  ///< by stage
};

/// Told the name of each pass when it is done, to measure it or to look at what it changed.
using PassObserver = std::function<void(const std::string& pass)>;
inline void nobody_observes(const std::string&) {}

/// Applies the impulses of every waiting contact, normal and friction together, which is answered then:
/// vertex i receives its weight times their sum (thesis 5.10, 5.16). On a plane only the vertex does.
void apply_impulses(World& world, Contacts& contacts);

/// One step of the thesis' scheme (its section 3.3, made precise in the book's page on the step):
///   predict; refresh passes; at most Solver::max_responses x (detect, respond, apply
///   impulses, update the prediction) until nothing new
///   appears; finish; commit velocities, then positions; after_commit. Pairs found by the
///   last detection stay, waiting, for the next step.
/// A step that does not end well is thrown away and taken in halves, each of them a step of its own with half
/// of dt, as far as the solver's max_halvings goes; the pairs then tell their impulses of the last part.
///
/// @param world     bodies, changed in place
/// @param contacts  pairs that live on from the last step; on return those alive after this one
/// @param dt        length of the step [s], positive
/// @param done      is told of each pass, and of "predict", "apply
///     impulses", "update prediction" and "commit"
/// @throws std::runtime_error  a position or velocity became NaN or infinite: names step, body and vertex; or
///     a body turns a thousand times too far for a solver that takes halves: names step and body
void advance(World& world, Contacts& contacts, const Solver& solver, double dt,
             const PassObserver& done = nobody_observes);

}  // namespace enduring
