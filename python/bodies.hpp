#pragma once

#include <pybind11/pybind11.h>

namespace enduring::python {

void declare_body(pybind11::module_& module);

}  // namespace enduring::python
