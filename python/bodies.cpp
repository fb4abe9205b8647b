#include "python/bodies.hpp"

#include "common/simulation/deformable_body.hpp"
#include "common/simulation/rigid_body.hpp"
#include "python/arrays.hpp"

namespace enduring::python {

namespace py = pybind11;

namespace {

py::array velocities(const Body& body)
{
    std::vector<Vec3> rows;
    for (int v = 0; v < body.surface().vertex_count(); ++v)
        rows.push_back(body.velocity(v));
    return copy(rows);
}

py::object nodes(const py::object& self)
{
    const auto* const soft = dynamic_cast<const DeformableBody*>(&self.cast<const Body&>());
    if (!soft)
        return py::none();
    const NodalVectors& positions = soft->elastic().positions();
    return view(positions.data(), static_cast<std::size_t>(positions.cols()), 3, 3 * sizeof(double), self);
}

py::object pose(const Body& body)
{
    const auto* const rigid = dynamic_cast<const RigidBody*>(&body);
    if (!rigid)
        return py::none();
    const Quaternion& q = rigid->motion().pose().orientation;
    return py::make_tuple(copy(rigid->motion().centre()), py::make_tuple(q.w(), q.x(), q.y(), q.z()));
}

}  // namespace

void declare_body(py::module_& module)
{
    py::class_<Body, std::unique_ptr<Body, py::nodelete>>(module, "Body", "A body of a scene.")
        .def_property_readonly("name", &Body::name)
        .def_property_readonly("mass", &Body::mass, "[kg], 0 of a static body")
        .def_property_readonly("is_static", &Body::is_static)
        .def_property_readonly(
            "positions",
            [](const py::object& self) {
                const auto positions = self.cast<const Body&>().positions_t0();
                return view(positions.front().data(), positions.size(), 3, sizeof(Vec3), self);
            },
            "of the surface vertices [m], always those of the present state; no copy")
        .def_property_readonly(
            "faces",
            [](const py::object& self) {
                const std::span<const Face> faces = self.cast<const Body&>().surface().faces();
                return view(faces.front().data(), faces.size(), 3, sizeof(Face), self);
            },
            "three vertices each, counter-clockwise seen from outside; no copy")
        .def_property_readonly("nodes", nodes, "of a soft body's elements [m], else None; no copy")
        .def_property_readonly("pose", pose,
                               "of a rigid body: its centre of mass [m], and a quaternion (w, x, y, z)")
        .def_property_readonly("velocities", velocities, "of the surface vertices [m/s]")
        .def_property_readonly(
            "velocity", [](const Body& body) { return copy(body.mean_velocity()); },
            "of the centre of mass [m/s]")
        .def_property_readonly(
            "momentum", [](const Body& body) { return copy(body.linear_momentum()); }, "[kg m/s]")
        .def(
            "angular_momentum",
            [](const Body& body, const Numbers& about) { return copy(body.angular_momentum(vec3(about))); },
            py::arg("about") = Numbers{}, "[kg m^2/s]");
}

}  // namespace enduring::python
