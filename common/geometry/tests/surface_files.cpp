#include "common/geometry/box_shapes.hpp"
#include "common/geometry/read_surface.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/geometry/surface_checks.hpp"
#include "common/geometry/tests/complaint.hpp"
#include "common/geometry/weld.hpp"
#include "common/input/input_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <sstream>

using namespace enduring;

namespace {

/// Every triangle with three vertices of its own, as an STL file has it.
SurfaceMesh in_pieces(const SurfaceMesh& mesh)
{
    SurfaceMesh pieces;
    for (const Face& face : mesh.faces) {
        const int first = static_cast<int>(pieces.vertices.size());
        for (const int corner : face)
            pieces.vertices.push_back(mesh.vertices[corner]);
        pieces.faces.push_back({first, first + 1, first + 2});
    }
    return pieces;
}

std::string off_text(const SurfaceMesh& mesh)
{
    std::ostringstream text;
    text << "OFF\n# a comment\n" << mesh.vertices.size() << ' ' << mesh.faces.size() << " 0\n";
    for (const Vec3& x : mesh.vertices)
        text << x.x() << ' ' << x.y() << ' ' << x.z() << '\n';
    for (const Face& face : mesh.faces)
        text << "3 " << face[0] << ' ' << face[1] << ' ' << face[2] << '\n';
    return text.str();
}

std::string stl_text(const SurfaceMesh& mesh)
{
    std::ostringstream text;
    text << "solid part\n";
    for (const Face& face : mesh.faces) {
        text << "facet normal 0 0 0\nouter loop\n";
        for (const int corner : face)
            text << "vertex " << mesh.vertices[corner].x() << ' ' << mesh.vertices[corner].y() << ' '
                 << mesh.vertices[corner].z() << '\n';
        text << "endloop\nendfacet\n";
    }
    text << "endsolid part\n";
    return text.str();
}

template <class Number>
void append_bytes(std::string& bytes, Number value, bool largest_first = false)
{
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (largest_first)
        std::reverse(raw, raw + sizeof value);
    bytes.append(raw, sizeof value);
}

std::string binary_stl(const SurfaceMesh& mesh)
{
    std::string bytes(80, ' ');
    append_bytes(bytes, static_cast<std::uint32_t>(mesh.faces.size()));
    for (const Face& face : mesh.faces) {
        bytes.append(12, '\0');
        for (const int corner : face)
            for (const double x : mesh.vertices[corner])
                append_bytes(bytes, static_cast<float>(x));
        bytes.append(2, '\0');
    }
    return bytes;
}

std::string ply(const SurfaceMesh& mesh, bool binary, bool largest_first = false)
{
    std::ostringstream head;
    head << "ply\nformat "
         << (!binary         ? "ascii"
             : largest_first ? "binary_big_endian"
                             : "binary_little_endian")
         << " 1.0\nelement vertex " << mesh.vertices.size()
         << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << mesh.faces.size()
         << "\nproperty list uchar int vertex_indices\nend_header\n";
    std::string text = head.str();
    std::ostringstream words;
    for (const Vec3& x : mesh.vertices) {
        words << x.x() << ' ' << x.y() << ' ' << x.z() << '\n';
        for (const double coordinate : x)
            if (binary)
                append_bytes(text, static_cast<float>(coordinate), largest_first);
    }
    for (const Face& face : mesh.faces) {
        words << "3 " << face[0] << ' ' << face[1] << ' ' << face[2] << '\n';
        if (binary)
            append_bytes(text, static_cast<std::uint8_t>(3));
        for (const int corner : face)
            if (binary)
                append_bytes(text, static_cast<std::int32_t>(corner), largest_first);
    }
    return binary ? text : text + words.str();
}

/// Whether both have the same triangles in space, in the same order.
void check_same(const SurfaceMesh& read, const SurfaceMesh& written)
{
    REQUIRE(read.faces.size() == written.faces.size());
    CHECK(read.vertices.size() == written.vertices.size());
    for (std::size_t f = 0; f < read.faces.size(); ++f)
        for (std::size_t i = 0; i < 3; ++i)
            CHECK(read.vertices[read.faces[f][i]] == written.vertices[written.faces[f][i]]);
}

std::string complaint(const std::string& bytes, const std::string& kind)
{
    return complaint_of([&] {
        kind == ".off"   ? read_off(bytes, "m.off")
        : kind == ".stl" ? read_stl(bytes, "m.stl")
                         : read_ply(bytes, "m.ply");
    });
}

}  // namespace

TEST_CASE("surface files: OFF, STL and PLY, text and binary, give the triangles that were written")
{
    const SurfaceMesh cube = box({1, 2, 0.5},
                                 {2, 1, 4});  // coordinates of few digits, also in single precision
    check_same(read_off(off_text(cube), "cube"), cube);
    check_same(read_stl(stl_text(cube), "cube"), cube);
    check_same(read_stl(binary_stl(cube), "cube"), cube);
    check_same(read_ply(ply(cube, false), "cube"), cube);
    check_same(read_ply(ply(cube, true), "cube"), cube);
    check_same(read_ply(ply(cube, true, true), "cube"), cube);
    CHECK_NOTHROW(check_surface(read_stl(binary_stl(cube), "cube"), "cube"));
}

TEST_CASE("surface files: a polygon with a dent becomes triangles of the same area, also from an OFF file")
{
    const std::string dart = "OFF\n4 1 0\n0 0 0\n2 1 0\n0 2 0\n0.5 1 0\n4 0 1 2 3\n";
    const SurfaceMesh mesh = read_off(dart, "dart");
    double area = 0;
    for (const auto& [a, b, c] : mesh.faces)
        area += (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).z() / 2;
    CHECK(area == doctest::Approx(1.5));
}

TEST_CASE("surface files: each kind of bad file is refused with the file and a reason")
{
    const std::string good = off_text(box({1, 1, 1}));
    CHECK(complaint(good, ".off") == "no complaint");
    const std::string ply_head =
                          "ply\nformat ascii 1.0\ncomment a triangle\nelement vertex 3\nproperty float x\n"
                          "property float y\nproperty float z\nelement face 1\n"
                          "property list uchar int vertex_indices\nend_header\n",
                      triangle = ply_head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    CHECK(complaint(triangle, ".ply") == "no complaint");
    const auto changed = [&](std::string text, const std::string& from, const std::string& to) {
        REQUIRE(text.find(from) != std::string::npos);
        return text.replace(text.find(from), from.size(), to);
    };
    const std::vector<std::array<std::string, 3>> cases{
        {"", ".off", "m.off: the file is empty"},
        {"PLY\n1 2 3\n", ".off", "m.off:1: not an OFF file"},
        {"OFF\n2000000000 1 0\n", ".off", "m.off:2: the file ends where a vertex is missing"},
        {"OFF\n-3 1 0\n", ".off", "m.off:2: the count of vertices is -3, below zero"},
        {"OFF\n3 -1 0\n", ".off", "m.off:2: the count of faces is -1, below zero"},
        {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n", ".off",
         "m.off:6: the count of corners is -3, below zero"},
        {"ply\nformat ascii 1.0\nelement vertex -1\n", ".ply",
         "m.ply:3: the count of 'vertex' is -1, below zero"},
        {"OFF\n1e9 1 0\n", ".off", "m.off:2: count of vertices is '1e9', not a whole number"},
        {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 nan\n3 0 1 2\n", ".off",
         "m.off:5: coordinate is 'nan', not a finite number"},
        {"OFF 3 1 0\n0 0 0\n1 0 0\n\n# here\n0 1 0\n3 0 1 3\n", ".off",
         "m.off:7: the face names vertex 3; the file has 0 to 2"},
        {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n", ".off", "m.off:6: a face with 2 corners"},
        {"OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", ".off", "m.off:5: the file has no faces"},
        {"", ".stl", "m.stl: the file is empty"},
        {"solid part\nendsolid\n", ".stl", "m.stl: the file has no faces"},
        {"solid part\nfacet\nvertex 0 0 0\nvertex 1 0 0\nendloop\n", ".stl",
         "m.stl:5: a facet with 2 corners; three are needed"},
        {"solid part\nfacet\nvertex 0 0\n", ".stl", "m.stl:3: coordinate is missing"},
        {"solid part\nvertices\n", ".stl", "m.stl:2: 'vertices' is no keyword of an STL file"},
        {"part", ".stl", "m.stl: neither a text"},
        {binary_stl(box({1, 1, 1})).substr(0, 600), ".stl",
         "m.stl: a binary STL file that promises 684 bytes and has 600"},
        {triangle.substr(0, triangle.find("end_header")), ".ply",
         "m.ply:9: the file ends where end_header is missing"},
        {triangle.substr(0, 60), ".ply", "m.ply:5: 'pro' is no keyword of a PLY head"},
        {changed(triangle, "ascii", "utf8"), ".ply", "m.ply:2: the format 'utf8' is not known"},
        {changed(triangle, "float z", "real z"), ".ply", "m.ply:7: 'real' is no type of number"},
        {changed(triangle, "element vertex 3", "element vertex 99999999999"), ".ply",
         "m.ply:14: the file ends where a vertex is missing"},
        {changed(triangle, "property float z\n", ""), ".ply", "m.ply:10: a vertex has no x, y and z"},
        {changed(triangle, "0 1 0", "0 1 inf"), ".ply", "m.ply:13: coordinate is 'inf', not a finite number"},
        {changed(triangle, "3 0 1 2", "3 0 1 7"), ".ply", "m.ply:14: the face names vertex 7"},
        {changed(triangle, "3 0 1 2", "4 0 1 2"), ".ply", "m.ply:14: a vertex of the face is missing"},
        {ply(box({1, 1, 1}), true).substr(0, 250), ".ply",
         "m.ply: byte 250: the file ends where a number is missing"},
        {changed(ply_head, "element vertex 3", "element vertex 3\nelement edge 4"), ".ply",
         "m.ply:11: the element 'vertex' has no properties"},
    };
    for (const auto& [bytes, kind, expected] : cases) {
        CAPTURE(bytes);
        const std::string got = complaint(bytes, kind);
        CAPTURE(got);
        CHECK(got.substr(0, expected.size()) == expected);
    }
    CHECK_THROWS_WITH_AS(read_surface("part.step"),
                         "part.step: a surface is read from a file ending in .obj, .off, .stl or .ply",
                         InputError);
    CHECK_THROWS_WITH_AS(read_surface("/nowhere/part.STL"), "/nowhere/part.STL: no such file", InputError);
}

TEST_CASE("weld: a surface in pieces is closed again, and has its vertices in their old order")
{
    const SurfaceMesh ball = sphere(0.3, 3), pieces = in_pieces(ball);
    CHECK_THROWS_AS(check_surface(pieces, "pieces"), InputError);
    const SurfaceMesh whole = welded(pieces, 0);
    CHECK(whole.vertices.size() == ball.vertices.size());
    CHECK(whole.faces.size() == ball.faces.size());
    CHECK_NOTHROW(check_surface(whole, "whole"));
    CHECK(enclosed_volume(whole) == doctest::Approx(enclosed_volume(ball)).epsilon(1e-14));
}

TEST_CASE(
    "weld: what lies within the distance becomes one, what lies beyond it stays, wherever the grid's cells end")
{
    const double distance = 1e-3;
    for (int i = 0; i < 200; ++i) {
        const Vec3 at(0.00037 * i - 0.04, 0.01 * i, -0.00411 * i);
        for (const double gap : {0.0, 0.99 * distance, 1.01 * distance}) {
            const Vec3 direction = Vec3(1, i % 3 - 1, i % 5 - 2).normalized();
            const SurfaceMesh two{{at, at + Vec3(1, 0, 0), at + Vec3(0, 1, 0), at + gap * direction,
                                   at + Vec3(0, 0, 1), at + Vec3(0, 1, 1)},
                                  {{0, 1, 2}, {3, 4, 5}}};
            CAPTURE(i);
            CAPTURE(gap);
            CHECK(welded(two, distance).vertices.size() == (gap < distance ? 5 : 6));
        }
    }
}

TEST_CASE(
    "weld: a surface far from the origin is welded, also where a grid over its gaps would have more cells than a double counts")
{
    SurfaceMesh ball = in_pieces(sphere(1, 2));
    for (Vec3& x : ball.vertices)
        x = 1e-6 * x + Vec3(1e5, -1e5, 0);
    const SurfaceMesh whole = welded(ball, 1e-13);
    CHECK(whole.vertices.size() <= sphere(1, 2).vertices.size());
    CHECK(whole.vertices.size() > 4);
}

TEST_CASE("weld: a face that loses a side goes, and the surface around it closes")
{
    SurfaceMesh cube = box({1, 1, 1});
    // A sliver in an edge: one corner comes twice, a hair apart, and a face between them closes the gap.
    const Face face = cube.faces[0];
    cube.vertices.push_back(cube.vertices[face[0]] + Vec3(0, 0, 1e-13));
    cube.faces[0] = {8, face[1], face[2]};
    cube.faces.push_back({face[0], face[1], 8});
    cube.faces.push_back({face[0], 8, face[2]});
    CHECK_THROWS_AS(check_surface(cube, "cube"), InputError);
    const SurfaceMesh whole = welded(cube, weld_distance(cube));
    CHECK(whole.faces.size() == 12);
    CHECK_NOTHROW(check_surface(whole, "cube"));
}
