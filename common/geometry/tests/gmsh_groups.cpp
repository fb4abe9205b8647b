#include "common/geometry/read_gmsh.hpp"
#include "common/geometry/tests/complaint.hpp"
#include "common/input/source_directory.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>

using namespace enduring;

namespace {

const std::filesystem::path seeds = source_directory() / "common/geometry/fuzz/seeds/gmsh_reader";

/// One tetrahedron, a triangle of which is in a group, and a second one with a node of its own that no
/// tetrahedron uses.
const std::string small = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
2 7 "the clamped side"
3 7 "all"
$EndPhysicalNames
$Nodes
5
10 0 0 0
20 1 0 0
30 0 1 0
40 0 0 1
50 0 0 -1
$EndNodes
$Elements
4
1 2 2 7 1 20 30 40
2 2 2 7 1 20 30 50
3 2 2 8 1 10 20 30
4 4 2 7 1 10 20 30 40
$EndElements
)";

GmshSolid read(const std::string& text)
{
    std::istringstream stream(text);
    return read_gmsh_with_groups(stream, "m.msh");
}

std::string complaint(const std::string& from, const std::string& to)
{
    std::string text = small;
    text.replace(text.find(from), from.size(), to);
    return complaint_of([&] { read(text); });
}

}  // namespace

TEST_CASE("Gmsh groups: their nodes are those of the elements of their dimension that tetrahedra use, too")
{
    const NodeGroups groups = read(small).groups;
    REQUIRE(groups.size() == 2);
    CHECK(groups.at("the clamped side").nodes == std::vector{1, 2, 3});
    CHECK(groups.at("the clamped side").edges == std::vector<Edge>{{1, 2}, {1, 3}, {2, 3}});
    CHECK(groups.at("all").nodes == std::vector{0, 1, 2, 3});
    CHECK(groups.at("all").edges.size() == 6);
}

TEST_CASE("Gmsh groups: points, curves, faces and the body of a box, as Gmsh saves them in four formats")
{
    const auto nodes_where = [](const GmshSolid& solid, const auto& is_in) {
        std::vector<int> found;
        for (std::size_t node = 0; node < solid.mesh.nodes.size(); ++node)
            if (is_in(solid.mesh.nodes[node]))
                found.push_back(static_cast<int>(node));
        return found;
    };
    for (const std::string name : {"groups_order1_v22", "groups_order1_v22_binary", "groups_order1_v41",
                                   "groups_order1_v41_binary", "groups_order2_v41"}) {
        CAPTURE(name);
        const GmshSolid box = read_gmsh_with_groups(seeds / (name + ".msh"));
        REQUIRE(box.groups.size() == 5);
        CHECK(box.groups.at("left end").nodes ==
              nodes_where(box, [](const Vec3& x) { return x.x() < 1e-9; }));
        CHECK(box.groups.at("right").nodes ==
              nodes_where(box, [](const Vec3& x) { return x.x() > 2 - 1e-9; }));
        CHECK(box.groups.at("corner").nodes ==
              nodes_where(box, [](const Vec3& x) { return (x - Vec3(2, 1, 0)).norm() < 1e-9; }));
        CHECK(box.groups.at("rim").nodes ==
              nodes_where(box, [](const Vec3& x) { return x.x() > 2 - 1e-9 && x.z() < 1e-9; }));
        CHECK(box.groups.at("all").nodes.size() == box.mesh.nodes.size());
        CHECK(box.groups.at("corner").edges.empty());
        CHECK(!box.groups.at("rim").edges.empty());
    }
}

TEST_CASE("Gmsh groups: mistakes in them are named with their line")
{
    CHECK(complaint("2\n2 7", "2\n5 7") == "m.msh:6: a group of dimension 5");
    CHECK(complaint("7 \"all\"", "7 all") == "m.msh:7: the name of a group stands between quotation marks");
    CHECK(complaint("20 30 50", "20 30 60") == "m.msh:20: element 2 names node 60, which does not exist");
    CHECK(complaint("7 1 20 30 50", "8 1 20 30 60") == "no complaint");  // in no group, so it is passed over
    CHECK(complaint("2\n2 7", "x\n2 7") == "no complaint");
    CHECK(complaint("$EndPhysicalNames", "$EndNames").find("m.msh:8: dimension of a group") == 0);
}
