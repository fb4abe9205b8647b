#pragma once

#include "chapters/solvers/chapter_solver.hpp"
#include "common/scenes/scene.hpp"
#include "common/simulation/contact.hpp"
#include "python/arrays.hpp"

#include <memory>
#include <string>

namespace enduring::python {

namespace py = pybind11;

/// A scene that runs: its world, the pairs that live on from step to step, and a chapter's solver.
class Run {
public:
    Scene scene;
    std::shared_ptr<Contacts> contacts = std::make_shared<Contacts>();

    Run(Scene of, int chapter) : scene(std::move(of)) { choose(chapter); }

    void choose(int chapter);
    int chapter() const { return chapter_; }

    void step(int steps);

    /// Throws InputError unless a body or plane of this name may still be added.
    void require_new(const std::string& name) const;
    Body& add(std::unique_ptr<Body> body);

private:
    Solver solver_;
    int chapter_ = solvers::chapters;
};

/// A scene without bodies.
Scene empty_scene(double dt, const Numbers& gravity, double mu_s, double mu_d);

void add_plane(Run& run, const std::string& name, const Numbers& point, const Numbers& normal);
Body& add_static(Run& run, const std::string& name, const Rows<double>& vertices, const Rows<int>& faces);
Body& add_rigid(Run& run, const std::string& name, const Rows<double>& vertices, const Rows<int>& faces,
                double density, const Numbers& velocity, const Numbers& angular_velocity);
/// With linear elements.
Body& add_deformable(Run& run, const std::string& name, const Rows<double>& nodes,
                     const Rows<int>& tetrahedra, double young, double poisson, double density,
                     const Numbers& velocity);

}  // namespace enduring::python
