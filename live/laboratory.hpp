#pragma once

#include "common/scenes/shown_scene.hpp"

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

/// What the book's laboratory does with the layers: a scene from its text, under the solver of a chapter or
/// under a method of chapter 13, step by step.
namespace enduring::laboratory {

/// A hand that pulls a body by one of its faces with a spring and a damper.
struct Hand {
    /// Of a body's own mass [1/s^2]: the spring brings it in a quarter of a second. A tenth: it hangs behind.
    /// Ten times: it presses the body through thin plates under the solvers of part I.
    static constexpr double stiffness = 40;
    static constexpr double damping = 10;  ///< of its own mass [1/s], a little below critical

    int body = -1;  ///< by its place; -1: nothing is held
    int face = 0;
    Vec3 target = Vec3::Zero();  ///< [m]
};

/// A scene under a solver.
class Laboratory {
public:
    /// @param text     a scene file
    /// @param file     how messages call it
    /// @param meshes   folders where its meshes are searched
    /// @param solver   a chapter, "1" to "12", or one of other_methods() by its name
    /// @throws InputError  a mistake in the text, with its place; no such solver
    Laboratory(const std::string& text, const std::string& file,
               const std::vector<std::filesystem::path>& meshes, const std::string& solver);
    Laboratory(const Laboratory&) = delete;  // the solver's passes know where it is
    Laboratory& operator=(const Laboratory&) = delete;

    const Scene& scene() const { return scene_; }
    const Solver& solver() const { return solver_; }
    /// @throws std::runtime_error  what advance() throws
    void step();
    StepNumbers numbers() const { return step_numbers(scene_.world, contacts_); }
    std::vector<PairNumbers> pairs() const;
    /// The hand's force acts in each step until it lets go.
    void hold(const Hand& hand) { hand_ = hand; }

private:
    using PairKey = std::tuple<ContactKind, int, int, int, int>;

    void pull(World& world, double dt) const;
    void note_pairs();

    Scene scene_;
    Solver solver_;
    Contacts contacts_;
    Hand hand_;
    std::map<PairKey, int> since_;
};

}  // namespace enduring::laboratory
