#include "common/experiments/paraview/series.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/experiments/run/run.hpp"
#include "common/geometry/quadratic.hpp"
#include "common/input/input_error.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/tests/triangle_body.hpp"

#include <doctest/doctest.h>
#include <pugixml.hpp>

#include <algorithm>
#include <memory>
#include <sstream>

using namespace enduring;

namespace {

/// Two triangles that lie 0.25 m apart, three contacts of every kind
/// between them and a plane, impulses by hand.
struct TwoSheets {
    World world;
    Contacts contacts;
    double dt = 0.5;

    TwoSheets()
    {
        world.bodies.push_back(triangle("upper", 0.25, {0, -1, 2}));
        world.bodies.push_back(triangle("lower"));
        world.planes.push_back({"ground"});
        world.time = 0.125;
        world.bodies.front()->set_time(world.time - dt);  // the step that ended was one whole
        Contact pair{ContactKind::vertex_face, 0, 1, 1, 0, {1, 0, 1, 2}, {1, -0.5, -0.25, -0.25}};
        pair.impulse = {0, 4, 0};
        pair.friction = {1, 0, 0};
        pair.category = ContactCategory::hooked;
        contacts.push_back(pair);
        Contact edges{ContactKind::edge_edge, 0, 1, 0, 1, {0, 1, 0, 2}, {0.75, 0.25, -0.5, -0.5}};
        edges.impulse = {0, 8, 0};
        edges.hold(true);
        contacts.push_back(edges);
        Contact foot{ContactKind::vertex_plane, 1, 0, 2, -1, {2, -1, -1, -1}, {1, 0, 0, 0}};
        foot.impulse = {0, 0.5, 0};
        contacts.push_back(foot);
    }
};

TetrahedralMesh one_tetrahedron() { return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}}; }

DeformableSettings soft()
{
    DeformableSettings settings;
    settings.material = {1e3, 0.3, 1e3};
    return settings;
}

/// Moves the surface vertex that starts at (0, 0, 1) within one tiny
/// step, in which the elements cannot answer.
void dent(Body& body, const Vec3& by)
{
    const double dt = 1e-9;
    const auto vertices = body.positions_t0();
    const int top =
        static_cast<int>(std::find(vertices.begin(), vertices.end(), Vec3(0, 0, 1)) - vertices.begin());
    body.predict(Vec3::Zero(), dt);
    body.apply_impulse(top, by / dt / body.inverse_mass(top)(0, 0));
    body.update_prediction(dt);
    body.commit(dt);
}

struct Parsed {
    pugi::xml_document document;
    explicit Parsed(const std::string& text) { REQUIRE(document.load_string(text.c_str())); }
    pugi::xml_node piece(const char* type) const
    {
        return document.child("VTKFile").child(type).child("Piece");
    }
};

std::vector<double> numbers(const pugi::xml_node& section, const char* name, int components)
{
    const pugi::xml_node array = section.find_child_by_attribute("DataArray", "Name", name);
    CAPTURE(name);
    REQUIRE(array);
    CHECK(array.attribute("NumberOfComponents").as_int() == components);
    std::istringstream words(array.text().get());
    std::vector<double> values;
    for (double value; words >> value;)
        values.push_back(value);
    CHECK(values.size() % static_cast<std::size_t>(components) == 0);
    return values;
}

Vec3 vector_at(const std::vector<double>& values, std::size_t i)
{
    return {values.at(3 * i), values.at(3 * i + 1), values.at(3 * i + 2)};
}

}  // namespace

TEST_CASE("paraview: every surface vertex and face arrives with its place, velocity and body")
{
    const TwoSheets sheets;
    const Parsed file(surfaces_vtp(sheets.world, sheets.contacts, sheets.dt));
    const pugi::xml_node piece = file.piece("PolyData");
    CHECK(piece.attribute("NumberOfPoints").as_int() == 6);
    CHECK(piece.attribute("NumberOfPolys").as_int() == 2);
    const auto points = numbers(piece.child("Points"), "points", 3),
               velocities = numbers(piece.child("PointData"), "velocity", 3);
    const auto bodies = numbers(piece.child("PointData"), "body", 1);
    for (std::size_t i = 0; i < 6; ++i) {
        const Body& body = *sheets.world.bodies[i / 3];
        CHECK(vector_at(points, i) == body.positions_t0()[i % 3]);
        CHECK(vector_at(velocities, i) == (i < 3 ? Vec3(0, -1, 2) : Vec3(0, 0, 0)));
        CHECK(bodies.at(i) == (i < 3 ? 0 : 1));
    }
    CHECK(numbers(piece.child("Polys"), "connectivity", 1) == std::vector<double>{0, 1, 2, 3, 4, 5});
    CHECK(numbers(piece.child("Polys"), "offsets", 1) == std::vector<double>{3, 6});
}

TEST_CASE(
    "paraview: the contact forces on vertices are the pairs' impulses over dt, and cancel between bodies")
{
    const TwoSheets sheets;
    const Parsed file(surfaces_vtp(sheets.world, sheets.contacts, sheets.dt));
    const auto forces = numbers(file.piece("PolyData").child("PointData"), "contact_force", 3);
    REQUIRE(forces.size() == 18);
    CHECK((vector_at(forces, 0) - Vec3(0, 0.75 * 8, 0) / 0.5).norm() < 1e-14);
    CHECK((vector_at(forces, 1) - (Vec3(1, 4, 0) + 0.25 * Vec3(0, 8, 0)) / 0.5).norm() < 1e-14);
    CHECK((vector_at(forces, 5) - (-0.25 * Vec3(1, 4, 0) - 0.5 * Vec3(0, 8, 0) + Vec3(0, 0.5, 0)) / 0.5)
              .norm() < 1e-14);
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < 6; ++i)
        sum += vector_at(forces, i);
    CHECK((sum - Vec3(0, 0.5, 0) / 0.5).norm() < 1e-13);  // all that remains comes from the plane
}

TEST_CASE("paraview: a pair is a line from q to p with its forces, depth and labels")
{
    const TwoSheets sheets;
    const Parsed file(pairs_vtp(sheets.world, sheets.contacts, sheets.dt));
    const pugi::xml_node piece = file.piece("PolyData"), cells = piece.child("CellData");
    CHECK(piece.attribute("NumberOfPoints").as_int() == 6);
    CHECK(piece.attribute("NumberOfLines").as_int() == 3);
    const auto points = numbers(piece.child("Points"), "points", 3), depths = numbers(cells, "depth", 1);
    for (std::size_t i = 0; i < 3; ++i) {
        CAPTURE(i);
        const Contact& contact = sheets.contacts[i];
        Vec3 between = Vec3::Zero();  // p - q, from the weights alone
        for (int v = 0; v < contact.vertex_count(); ++v)
            between += contact.weights[v] * contact_vertex(sheets.world, contact, v, 1);
        if (contact.on_plane())
            between = Vec3(0, 0, 0);  // its vertex lies in the plane
        CHECK((vector_at(points, 2 * i + 1) - vector_at(points, 2 * i) - between).norm() < 1e-14);
        CHECK(std::abs(depths.at(i) - (contact.on_plane() ? 0 : 0.25)) < 1e-14);
        CHECK(vector_at(numbers(cells, "normal_force", 3), i) == contact.impulse / 0.5);
        CHECK(vector_at(numbers(cells, "friction_force", 3), i) == contact.friction / 0.5);
        CHECK(vector_at(numbers(cells, "impulse", 3), i) == contact.impulse + contact.friction);
    }
    CHECK(numbers(cells, "kind", 1) == std::vector<double>{1, 2, 0});
    CHECK(numbers(cells, "category", 1) == std::vector<double>{2, 0, 0});
    CHECK(numbers(cells, "held", 1) == std::vector<double>{0, 1, 0});
    CHECK(numbers(cells, "body_a", 1) == std::vector<double>{0, 0, 1});
    CHECK(numbers(cells, "body_b", 1) == std::vector<double>{1, 1, -1});
}

TEST_CASE("paraview: quadratic elements come with points of the body on their edges, not with control points")
{
    World world;
    world.bodies.push_back(
        std::make_unique<DeformableBody>("soft", with_edge_midpoints(one_tetrahedron()), soft()));
    dent(*world.bodies[0], {0.1, -0.05, 0.2});
    const Parsed file(elements_vtu(world));
    const pugi::xml_node piece = file.piece("UnstructuredGrid");
    CHECK(piece.attribute("NumberOfCells").as_int() == 1);
    CHECK(numbers(piece.child("Cells"), "types", 1) == std::vector<double>{24});
    CHECK(numbers(piece.child("Cells"), "offsets", 1) == std::vector<double>{10});
    const auto points = numbers(piece.child("Points"), "points", 3);
    REQUIRE(points.size() == 30);
    REQUIRE(world.bodies[0]->positions_t0().size() == 10);  // every point of this element is a surface vertex
    for (const Vec3& vertex : world.bodies[0]->positions_t0()) {
        double nearest = 1;
        for (std::size_t i = 0; i < 10; ++i)
            nearest = std::min(nearest, (vector_at(points, i) - vertex).norm());
        CAPTURE(vertex.transpose());
        CHECK(nearest < 1e-14);
    }
}

TEST_CASE("paraview: an element is marked once a corner has been pushed through its base")
{
    for (const double push : {-0.5, -1.5}) {
        CAPTURE(push);
        World world;
        world.bodies.push_back(triangle("lower"));  // has no elements
        world.bodies.push_back(std::make_unique<DeformableBody>("soft", one_tetrahedron(), soft()));
        dent(*world.bodies[1], {0, 0, push});
        const Parsed file(elements_vtu(world));
        const pugi::xml_node cells = file.piece("UnstructuredGrid").child("CellData");
        CHECK(numbers(cells, "inverted", 1) == std::vector<double>{push < -1 ? 1.0 : 0.0});
        CHECK(numbers(cells, "body", 1) == std::vector<double>{1});
    }
}

TEST_CASE("paraview: a series saves every few steps and lists them with their times")
{
    TemporaryFolder folder;
    Scene scene = load_scene(scene_file("bar_on_cube"));
    ParaviewSeries series(folder.path, 3);
    RunLimits limits;
    limits.steps = 7;
    run(scene, {}, {&series}, limits);
    series.finish();
    CHECK(series.moments() == 3);
    for (const char* name : {"surfaces", "elements", "pairs"}) {
        CAPTURE(name);
        pugi::xml_document list;
        REQUIRE(list.load_file((folder.path / (std::string(name) + ".pvd")).c_str()));
        int found = 0;
        for (const pugi::xml_node entry : list.child("VTKFile").child("Collection").children("DataSet")) {
            CHECK(entry.attribute("timestep").as_double() == doctest::Approx(3 * found * scene.dt));
            pugi::xml_document moment;
            CHECK(moment.load_file((folder.path / entry.attribute("file").as_string()).c_str()));
            ++found;
        }
        CHECK(found == 3);
    }
    CHECK_THROWS_WITH_AS(ParaviewSeries(folder.path, 0),
                         "a series saves every 1st, 2nd, ... step, not every 0", InputError);
}
