#pragma once

#include "common/simulation/step.hpp"

#include <pybind11/pybind11.h>

#include <memory>
#include <vector>

namespace enduring::python {

/// The pairs of one moment. A later step leaves them and the arrays over them as they are.
struct Pairs {
    std::shared_ptr<const Contacts> contacts;
    std::vector<Vec3> p, q, normals;
    std::vector<double> depths;
    double part = 0;

    Pairs(const World& world, std::shared_ptr<const Contacts> of_moment, double dt);
};

void declare_pairs(pybind11::module_& module);

}  // namespace enduring::python
