// The course as a Python module: `import enduring`. Build it with `./course python`; docs/python.md shows how it is used.
//
// Positions, faces, nodes and what pairs hold are arrays over the solver's own memory, which cannot be written. What is
// computed when it is asked for (velocities, energies, forces, the points and normals of pairs) is a copy.
#include "chapters/solvers/chapter_solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/geometry/solid_checks.hpp"
#include "common/geometry/surface_checks.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/input/input_error.hpp"
#include "common/input/source_directory.hpp"
#include "common/scenes/scene_reader.hpp"
#include "common/simulation/contact_forces.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace py = pybind11;
using namespace enduring;

namespace {

using Numbers = std::array<double, 3>;
template <class T>
using Rows = py::array_t<T, py::array::c_style | py::array::forcecast>;

Vec3 vec3(const Numbers& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

/// Rows of an array over memory of `owner`, which stays alive with it; `step` is from one row to the next [bytes].
template <class T>
py::array view(const T* first, std::size_t rows, py::ssize_t columns, std::size_t step, py::handle owner)
{
    const auto stride = static_cast<py::ssize_t>(step);
    py::array_t<T> array({static_cast<py::ssize_t>(rows), columns},
                         {stride, static_cast<py::ssize_t>(sizeof(T))}, first, owner);
    array.attr("setflags")(py::arg("write") = false);
    return array;
}

py::array copy(const std::vector<Vec3>& rows)
{
    py::array_t<double> array({static_cast<py::ssize_t>(rows.size()), py::ssize_t{3}});
    auto to = array.mutable_unchecked<2>();
    for (py::ssize_t i = 0; i < to.shape(0); ++i)
        for (py::ssize_t c = 0; c < 3; ++c)
            to(i, c) = rows[static_cast<std::size_t>(i)][c];
    return array;
}

py::array copy(const Vec3& vector) { return py::array_t<double>(py::ssize_t{3}, vector.data()); }

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

std::vector<Vec3> points_of(const Rows<double>& array, const std::string& what)
{
    std::vector<Vec3> points;
    points.reserve(static_cast<std::size_t>(array.size() / 3));
    for (const Numbers& row : rows_of<double, 3>(array, what))
        points.push_back(vec3(row));
    return points;
}

SurfaceMesh surface_from(const Rows<double>& vertices, const Rows<int>& faces, Border border)
{
    SurfaceMesh mesh{points_of(vertices, "vertices"), rows_of<int, 3>(faces, "faces")};
    check_surface(mesh, "the surface", border);
    return mesh;
}

py::tuple arrays_of(const SurfaceMesh& mesh)
{
    return py::make_tuple(copy(mesh.vertices), py::array(py::cast(mesh.faces)));
}

/// The pairs of one moment. A later step leaves them and the arrays over them as they are.
struct Pairs {
    std::shared_ptr<const Contacts> contacts;
    std::vector<Vec3> p, q, normals;
    std::vector<double> depths;
    double part = 0;

    Pairs(const World& world, std::shared_ptr<const Contacts> of_moment, double dt)
        : contacts(std::move(of_moment)), part(last_part(world, dt))
    {
        for (const Contact& contact : *contacts) {
            const ContactGeometry geometry = contact_geometry(world, contact, 1);
            p.push_back(geometry.p);
            q.push_back(geometry.q);
            normals.push_back(geometry.normal);
            depths.push_back(geometry.depth);
        }
    }
};

/// A member of every pair, as an array over the pairs' own memory.
template <auto member, class T, py::ssize_t columns>
py::array column(const py::object& self)
{
    const Contacts& contacts = *self.cast<const Pairs&>().contacts;
    const T* first = contacts.empty() ? nullptr : reinterpret_cast<const T*>(&(contacts.front().*member));
    return view(first, contacts.size(), columns, sizeof(Contact), self);
}

/// A scene that runs: its world, the pairs that live on from step to step, and a chapter's solver.
class Run {
public:
    Scene scene;
    std::shared_ptr<Contacts> contacts = std::make_shared<Contacts>();

    Run(Scene of, int chapter) : scene(std::move(of)) { choose(chapter); }

    void choose(int chapter)
    {
        if (scene.world.step > 0)
            throw InputError("a solver is chosen before the first step: it remembers what it needs");
        solver_ = solvers::chapter_solver(chapter, scene.contact);
        chapter_ = chapter;
    }
    int chapter() const { return chapter_; }

    void step(int steps)
    {
        if (contacts.use_count() > 1)  // somebody looks at the pairs of this moment
            contacts = std::make_shared<Contacts>(*contacts);
        for (int i = 0; i < steps; ++i)
            advance(scene.world, *contacts, solver_, scene.dt);
    }

    template <class Made>
    Body& add(std::unique_ptr<Made> body)
    {
        const auto& bodies = scene.world.bodies;
        if (std::any_of(bodies.begin(), bodies.end(),
                        [&](const auto& other) { return other->name() == body->name(); }))
            throw InputError("there is a body '" + body->name() + "' already");
        scene.world.bodies.push_back(std::move(body));
        choose(chapter_);
        return *scene.world.bodies.back();
    }

private:
    Solver solver_;
    int chapter_ = solvers::chapters;
};

/// A dictionary becomes the text of a scene file; text stays.
std::string json_text(const py::object& value)
{
    if (value.is_none())
        return "";
    if (py::isinstance<py::str>(value))
        return value.cast<std::string>();
    return py::module_::import("json").attr("dumps")(value).cast<std::string>();
}

Scene empty_scene(double dt, const Numbers& gravity, double mu_s, double mu_d)
{
    Scene scene;
    scene.name = "scene";
    if (!(dt > 0 && dt <= 1))
        throw InputError("dt: expected a number above 0, up to 1 [s]");
    if (!(mu_s >= 0 && mu_d >= 0 && mu_d <= mu_s))
        throw InputError("mu_s, mu_d: expected 0 <= mu_d <= mu_s");
    scene.dt = dt;
    scene.world.gravity = vec3(gravity);
    if (mu_s > 0)
        scene.contact.friction = MassSplitting{mu_s, mu_d};
    return scene;
}

void add_plane(Run& run, const std::string& name, const Numbers& point, const Numbers& normal)
{
    const double length = vec3(normal).norm();
    if (!(length > 0))
        throw InputError("normal: expected a vector that is not zero");
    run.scene.world.planes.push_back({name, vec3(point), vec3(normal) / length});
}

Body& add_static(Run& run, const std::string& name, const Rows<double>& vertices, const Rows<int>& faces)
{
    SurfaceMesh mesh = surface_from(vertices, faces, Border::allowed);
    const int count = static_cast<int>(mesh.vertices.size());
    return run.add(std::make_unique<StaticBody>(name, SurfaceTopology(count, std::move(mesh.faces)),
                                                std::move(mesh.vertices)));
}

Body& add_rigid(Run& run, const std::string& name, const Rows<double>& vertices, const Rows<int>& faces,
                double density, const Numbers& velocity, const Numbers& angular_velocity)
{
    const SurfaceMesh mesh = surface_from(vertices, faces, Border::refused);
    return run.add(std::make_unique<RigidBody>(name, mesh, mass_properties(mesh, density), vec3(velocity),
                                               vec3(angular_velocity)));
}

Body& add_deformable(Run& run, const std::string& name, const Rows<double>& nodes,
                     const Rows<int>& tetrahedra, double young, double poisson, double density,
                     const Numbers& velocity)
{
    const TetrahedralMesh mesh{points_of(nodes, "nodes"), rows_of<int, 4>(tetrahedra, "tetrahedra")};
    check_solid(mesh, "the mesh");
    DeformableSettings settings;
    settings.material = {young, poisson, density};
    settings.velocity = vec3(velocity);
    return run.add(std::make_unique<DeformableBody>(name, mesh, settings));
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

void declare_pairs(py::module_& module)
{
    const auto forces = [](const Pairs& pairs, auto part_of) {
        std::vector<Vec3> rows;
        for (const Contact& contact : *pairs.contacts)
            rows.push_back(part_of(pair_force(contact, pairs.part)));
        return copy(rows);
    };
    py::class_<Pairs>(module, "Pairs", "The pairs in contact at one moment, a row each.")
        .def("__len__", [](const Pairs& pairs) { return pairs.contacts->size(); })
        .def_property_readonly("impulse", column<&Contact::impulse, double, 3>,
                               "along the normal, on A, in the last part of the step [N s]; no copy")
        .def_property_readonly("friction_impulse", column<&Contact::friction, double, 3>,
                               "the same along the surface; no copy")
        .def_property_readonly("bodies", column<&Contact::body_a, int, 2>,
                               "A and B; for a pair with a plane B is the plane; no copy")
        .def_property_readonly("vertices", column<&Contact::vertices, int, 4>,
                               "-1 where there is none; no copy")
        .def_property_readonly("weights", column<&Contact::weights, double, 4>,
                               "with which an impulse reaches them; no copy")
        .def_property_readonly("kind", column<&Contact::kind, std::uint8_t, 1>,
                               "0 plane, 1 vertex-face, 2 edge-edge; no copy")
        .def_property_readonly(
            "p", [](const Pairs& pairs) { return copy(pairs.p); }, "point of A [m]")
        .def_property_readonly(
            "q", [](const Pairs& pairs) { return copy(pairs.q); }, "point of B [m]")
        .def_property_readonly(
            "normal", [](const Pairs& pairs) { return copy(pairs.normals); }, "out of B")
        .def_property_readonly(
            "depth", [](const Pairs& pairs) { return py::array(py::cast(pairs.depths)); },
            "[m], negative inside")
        .def_property_readonly(
            "force",
            [forces](const Pairs& pairs) {
                return forces(pairs, [](const PairForce& force) { return force.normal; });
            },
            "along the normal, on A [N]")
        .def_property_readonly(
            "friction",
            [forces](const Pairs& pairs) {
                return forces(pairs, [](const PairForce& force) { return force.friction; });
            },
            "along the surface, on A [N]");
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
        .def("step", &Run::step, py::arg("steps") = 1)
        .def_property("chapter", &Run::chapter, &Run::choose, "whose solver runs it; before the first step")
        .def("add_plane", add_plane, py::arg("name"), py::arg("point") = zero, py::arg("normal") = up)
        .def("add_static", add_static, inside, py::arg("name"), py::arg("vertices"), py::arg("faces"))
        .def("add_rigid", add_rigid, inside, py::arg("name"), py::arg("vertices"), py::arg("faces"),
             py::arg("density") = 1000, py::arg("velocity") = zero, py::arg("angular_velocity") = zero)
        .def("add_deformable", add_deformable, inside, py::arg("name"), py::arg("nodes"),
             py::arg("tetrahedra"), py::arg("young"), py::arg("poisson"), py::arg("density") = 1000,
             py::arg("velocity") = zero)
        .def_property_readonly("name", [](const Run& run) { return run.scene.name; })
        .def_property_readonly(
            "dt", [](const Run& run) { return run.scene.dt; }, "[s]")
        .def_property_readonly(
            "duration", [](const Run& run) { return run.scene.duration; }, "[s]")
        .def_property_readonly(
            "time", [](const Run& run) { return run.scene.world.time; }, "[s]")
        .def_property_readonly("warnings", [](const Run& run) { return run.scene.warnings; })
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
