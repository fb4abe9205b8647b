#pragma once

#include "common/experiments/run/probes.hpp"
#include "common/experiments/run/timings.hpp"
#include "common/geometry/meshes.hpp"
#include "common/scenes/scene.hpp"

#include <functional>
#include <string>
#include <vector>

namespace enduring::chapter10 {

/// What soft bodies are made of, and how they are stepped.
struct SoftVariant {
    double young;  ///< [Pa]
    int cells;     ///< for each 5 cm of a body's length
    double dt;     ///< [s]
    double mu;     ///< that holds; four fifths of it rub
    bool self_contact = true;
};

/// Forces that act on one body while a run lasts, each on a surface vertex.
struct Pull {
    int body = 0;
    std::vector<int> vertices{};
    Vec3 force = Vec3::Zero();  ///< on all of them together [N]
    double until = 0;           ///< [s]
    double halved = 0;          ///< so long it takes the force to fall by half [s]; 0: it stays
};

struct SoftRun {
    Scene scene;
    std::vector<Pull> pulls;
};

/// A scene without bodies and planes, with gravity; nothing pulls.
SoftRun soft_run(const SoftVariant& variant);

/// Adds a body of linear tetrahedra, 1000 kg/m^3.
void add_soft(Scene& scene, const std::string& name, const TetrahedralMesh& mesh, const SoftVariant& variant,
              const Vec3& position = Vec3::Zero(), const Vec3& velocity = Vec3::Zero(),
              const std::vector<int>& fixed_nodes = {});

/// The solver with steady forces: they act before anything is looked for.
Solver pulling(Solver solver, std::vector<Pull> pulls);

/// What a run took to look for pairs [s], of bodies with others and with themselves.
double search_time(const Timings& timings);

/// What a run showed, the most after any step if nothing else is said.
struct Folded {
    long pairs = 0;               ///< of a body with itself
    long crossings = 0;           ///< edges through faces of their own body
    double depth = 0;             ///< of a crossing [m], see crossing_depth()
    long crossings_at_end = 0;    ///< after the last step
    double depth_at_end = 0;      ///< [m]
    long inverted = 0;            ///< elements
    double first = 0, most = 0;   ///< energy when nothing pulls any more, and the most from then on [J]
    double impact = 0, rest = 0;  ///< kinetic energy, the most and at the end [J]
    double impulse = 0;           ///< sum over the bodies of the momentum that their energy could be [kg m/s]
    double momentum = 0;          ///< most that the sum of momenta changes [kg m/s]
    double search_share = 0;  ///< of a step's time: looking for a body's contact with itself, and with others
    double answer_share = 0;  ///< of a step's time: answering pairs of a body with itself
    long solves = 0, unconverged = 0;
    int steps = 0;
};

/// Runs a scene with this chapter's solver and looks at every body after every step.
/// @param probes  further ones
/// @param stop    asked after every step; true ends the run
Folded fold(SoftRun& run, int steps, std::vector<Probe*> probes = {},
            std::function<bool(const World&, const Contacts&)> stop = {});

}  // namespace enduring::chapter10
