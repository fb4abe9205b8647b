// The course as a Python module: `import enduring`. Build it with `./course python`; docs/python.md shows how
// it is used.
//
// Positions, faces, nodes and what pairs hold are arrays over the solver's own memory, which cannot be
// written. What is computed when it is asked for (velocities, energies, forces, the points and normals of
// pairs) is a copy.
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/input/source_directory.hpp"
#include "common/scenes/scene_reader.hpp"
#include "common/simulation/contact_forces.hpp"
#include "common/simulation/energy.hpp"
#include "python/bodies.hpp"
#include "python/pairs.hpp"
#include "python/run.hpp"

#include <pybind11/stl/filesystem.h>

namespace enduring::python {
namespace {

py::tuple arrays_of(const SurfaceMesh& mesh)
{
    return py::make_tuple(copy(mesh.vertices), py::array(py::cast(mesh.faces)));
}

/// A dictionary becomes the text of a scene file, arrays and numbers of NumPy in it too; text stays.
std::string json_text(const py::object& value)
{
    if (value.is_none())
        return "";
    if (py::isinstance<py::str>(value))
        return value.cast<std::string>();
    const py::cpp_function plain([](const py::object& array) { return array.attr("tolist")(); });
    return py::module_::import("json").attr("dumps")(value, py::arg("default") = plain).cast<std::string>();
}

py::array energies(const Run& run)
{
    std::vector<Vec3> rows;
    for (const auto& body : run.scene.world.bodies) {
        const Energy energy = body->energy(run.scene.world.gravity);
        rows.emplace_back(energy.kinetic, energy.gravitational, energy.elastic);
    }
    return copy(rows);
}

/// A dictionary of each joint, by name.
py::dict joints(const Run& run)
{
    const auto array = [](const Vec3& vector) { return py::array_t<double>(3, vector.data()); };
    py::dict all;
    for (const Joint& joint : run.scene.world.joints) {
        py::dict one;
        one["force"] = array(joint.force);
        one["torque"] = array(joint.torque);
        one["turn"] = turn_of(run.scene.world, joint);
        one["way"] = way_of(run.scene.world, joint);
        one["broken"] = joint.broken;
        all[py::str(joint.name)] = one;
    }
    return all;
}

void declare_scene(py::module_& module)
{
    const auto inside = py::return_value_policy::reference_internal;
    const Numbers zero{}, up{0, 1, 0};
    py::class_<Run>(module, "Scene", "A scene that runs under a chapter's solver.")
        .def(py::init([](double dt, const Numbers& gravity, double mu_s, double mu_d, int chapter) {
                 return std::make_unique<Run>(empty_scene(dt, gravity, mu_s, mu_d), chapter);
             }),
             py::arg("dt") = 0.01, py::arg("gravity") = Numbers{0, -9.81, 0}, py::arg("mu_s") = 0,
             py::arg("mu_d") = 0, py::arg("chapter") = solvers::chapters, "Empty, for bodies that are added.")
        .def("step", &Run::step, py::arg("steps") = 1, "Steps of `dt` each, with the solver of `chapter`.")
        .def_property("chapter", &Run::chapter, &Run::choose, "whose solver runs it; before the first step")
        .def("add_plane", add_plane, py::arg("name"), py::arg("point") = zero, py::arg("normal") = up,
             "A half space; the normal points out of it and has any length.")
        .def(
            "add_static", add_static, inside, py::arg("name"), py::arg("vertices"), py::arg("faces"),
            "A surface that stands, closed or with a border, from an array of vertices [m] in the world and one of faces.")
        .def(
            "add_rigid", add_rigid, inside, py::arg("name"), py::arg("vertices"), py::arg("faces"),
            py::arg("density") = 1000, py::arg("velocity") = zero, py::arg("angular_velocity") = zero,
            "A rigid body with a closed surface; density [kg/m^3], velocity of its centre of mass [m/s], world axes [rad/s].")
        .def(
            "add_deformable", add_deformable, inside, py::arg("name"), py::arg("nodes"),
            py::arg("tetrahedra"), py::arg("young"), py::arg("poisson"), py::arg("density") = 1000,
            py::arg("velocity") = zero,
            "A soft body of linear elements, four nodes a row; young [Pa], density [kg/m^3], velocity [m/s].")
        .def_property_readonly("name", [](const Run& run) { return run.scene.name; })
        .def_property_readonly(
            "dt", [](const Run& run) { return run.scene.dt; }, "[s]")
        .def_property_readonly(
            "duration", [](const Run& run) { return run.scene.duration; }, "[s]")
        .def_property_readonly(
            "time", [](const Run& run) { return run.scene.world.time; }, "[s]")
        .def_property_readonly(
            "warnings", [](const Run& run) { return run.scene.warnings; },
            "what the reader doubts in the scene, a sentence each")
        .def_property_readonly(
            "bodies",
            [](const py::object& self) {
                py::dict bodies;
                for (const auto& body : self.cast<Run&>().scene.world.bodies)
                    bodies[py::str(body->name())] = py::cast(
                        body.get(), py::return_value_policy::reference_internal, self);
                return bodies;
            },
            "by name, in the scene's order")
        .def_property_readonly(
            "pairs", [](const Run& run) { return Pairs(run.scene.world, run.contacts, run.scene.dt); },
            "in contact after the last step")
        .def_property_readonly(
            "work",
            [](const Run& run) {
                py::dict numbers;
                visit_work(run.scene.world.work,
                           [&](const char* name, auto value) { numbers[name] = value; });
                return numbers;
            },
            "what the last step cost, by name: counts, and the worst residual; attempts that were thrown away are counted")
        .def_property_readonly(
            "joints", joints,
            "by name, in the scene's order: what each of them does on its body a (force [N], torque [N m] "
            "about its point), turn [rad], way [m], and whether it is broken")
        .def_property_readonly("energies", energies, "of each body: kinetic, gravitational, elastic [J]")
        .def_property_readonly(
            "spring_energy", [](const Run& run) { return spring_energy(*run.contacts); },
            "of the pairs that are given a stiffness of their own [J]")
        .def_property_readonly(
            "forces",
            [](const Run& run) { return copy(body_forces(run.scene.world, *run.contacts, run.scene.dt)); },
            "of contact, on each body [N]")
        .def_property_readonly(
            "vertex_forces",
            [](const Run& run) {
                py::list all;
                for (const auto& forces : vertex_forces(run.scene.world, *run.contacts, run.scene.dt))
                    all.append(copy(forces));
                return all;
            },
            "of contact, on the surface vertices of each body [N]");
}

}  // namespace
}  // namespace enduring::python

using namespace enduring;
using namespace enduring::python;

PYBIND11_MODULE(enduring, module)
{
    module.doc() =
        "Contact between rigid and deformable bodies: scenes, the solvers of all chapters, and what they compute.";
    py::register_exception<InputError>(module, "SceneError", PyExc_ValueError);
    declare_body(module);
    declare_pairs(module);
    declare_scene(module);
    module.attr("chapters") = solvers::chapters;
    module.def(
        "load",
        [](const std::filesystem::path& file, int chapter, const py::object& patch) {
            return std::make_unique<Run>(load_scene(file, json_text(patch)), chapter);
        },
        py::arg("file"), py::arg("chapter") = solvers::chapters, py::arg("patch") = py::none(),
        "A scene file; `patch`, a dictionary, changes it as the scene format says.");
    module.def(
        "read",
        [](const py::object& scene, int chapter, const py::object& patch) {
            const SceneSurroundings around{{".", source_directory() / "common" / "meshes"}};
            return std::make_unique<Run>(read_scene(json_text(scene), json_text(patch), "scene", around),
                                         chapter);
        },
        py::arg("scene"), py::arg("chapter") = solvers::chapters, py::arg("patch") = py::none(),
        "A scene as text or as a dictionary.");
    module.def("scene_file", scene_file, py::arg("name"), "Where a scene of the course lies.");
    module.def(
        "box",
        [](const Numbers& size, std::array<int, 3> cells) { return arrays_of(box(vec3(size), cells)); },
        py::arg("size"), py::arg("cells") = std::array<int, 3>{1, 1, 1},
        "Vertices and faces about the origin.");
    module.def(
        "sphere", [](double radius, int subdivisions) { return arrays_of(sphere(radius, subdivisions)); },
        py::arg("radius"), py::arg("subdivisions") = 2, "Vertices and faces about the origin.");
}
