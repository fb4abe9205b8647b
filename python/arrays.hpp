#pragma once

#include "common/geometry/vector.hpp"
#include "common/input/input_error.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>  // Numbers, as arguments and as results, in each file alike

#include <array>
#include <string>
#include <vector>

/// NumPy's arrays over memory of the solver, which cannot be written, and copies in both directions.
namespace enduring::python {

namespace py = pybind11;

using Numbers = std::array<double, 3>;
template <class T>
using Rows = py::array_t<T, py::array::c_style | py::array::forcecast>;

inline Vec3 vec3(const Numbers& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

/// Rows of an array over memory of `owner`, which stays alive with it; `step` is from one row to the next
/// [bytes].
template <class T>
py::array view(const T* first, std::size_t rows, py::ssize_t columns, std::size_t step, py::handle owner)
{
    const auto stride = static_cast<py::ssize_t>(step);
    py::array_t<T> array({static_cast<py::ssize_t>(rows), columns},
                         {stride, static_cast<py::ssize_t>(sizeof(T))}, first, owner);
    array.attr("setflags")(py::arg("write") = false);
    return array;
}

inline py::array copy(const std::vector<Vec3>& rows)
{
    py::array_t<double> array({static_cast<py::ssize_t>(rows.size()), py::ssize_t{3}});
    auto to = array.mutable_unchecked<2>();
    for (py::ssize_t i = 0; i < to.shape(0); ++i)
        for (py::ssize_t c = 0; c < 3; ++c)
            to(i, c) = rows[static_cast<std::size_t>(i)][c];
    return array;
}

inline py::array copy(const Vec3& vector) { return py::array_t<double>(py::ssize_t{3}, vector.data()); }

template <class Row, std::size_t columns>
auto rows_of(const Rows<Row>& array, const std::string& what)
{
    if (array.ndim() != 2 || array.shape(1) != static_cast<py::ssize_t>(columns))
        throw InputError(what + ": expected an array of " + std::to_string(columns) + " columns");
    std::vector<std::array<Row, columns>> rows(static_cast<std::size_t>(array.shape(0)));
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t c = 0; c < columns; ++c)
            rows[i][c] = array.at(i, c);
    return rows;
}

inline std::vector<Vec3> points_of(const Rows<double>& array, const std::string& what)
{
    std::vector<Vec3> points;
    points.reserve(static_cast<std::size_t>(array.size() / 3));
    for (const Numbers& row : rows_of<double, 3>(array, what))
        points.push_back(vec3(row));
    return points;
}

}  // namespace enduring::python
