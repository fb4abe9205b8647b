#include "common/geometry/tetrahedral_shapes.hpp"

#include "common/geometry/shape_arguments.hpp"

namespace enduring {
namespace {

/// Corners of a cell are numbered by bits: 1 for +x, 2 for +y, 4 for +z.
using CellTetrahedron = std::array<int, 4>;

Vec3 cell_corner(int bits) { return {double(bits & 1), double(bits >> 1 & 1), double(bits >> 2 & 1)}; }

/// Exchanges two corners where needed, so that the determinant is positive.
CellTetrahedron oriented(CellTetrahedron t)
{
    Mat3 edges;
    edges << cell_corner(t[1]) - cell_corner(t[0]), cell_corner(t[2]) - cell_corner(t[0]),
        cell_corner(t[3]) - cell_corner(t[0]);
    if (edges.determinant() < 0)
        std::swap(t[2], t[3]);
    return t;
}

/// Six tetrahedra, one for each way of walking from corner 000 to corner 111 along the axes.
std::vector<CellTetrahedron> six_around_the_diagonal()
{
    std::vector<CellTetrahedron> result;
    for (const auto& [first, second] : {std::array{1, 2}, {1, 4}, {2, 1}, {2, 4}, {4, 1}, {4, 2}})
        result.push_back(oriented({0, first, first | second, 7}));
    return result;
}

/// One tetrahedron over four corners that share no edge, and one at each of the other four corners.
std::vector<CellTetrahedron> five(bool mirrored)
{
    const int flip = mirrored ? 1 : 0;
    std::vector<CellTetrahedron> result{oriented({0 ^ flip, 3 ^ flip, 5 ^ flip, 6 ^ flip})};
    for (int corner : {1, 2, 4, 7}) {
        const int c = corner ^ flip;
        result.push_back(oriented({c, c ^ 1, c ^ 2, c ^ 4}));
    }
    return result;
}

}  // namespace

SurfaceMesh tetrahedron(double edge_length)
{
    require_length("edge_length of a tetrahedron", edge_length);
    const double height = edge_length * std::sqrt(2.0 / 3.0), around = edge_length / std::sqrt(3.0);
    SurfaceMesh mesh;
    mesh.vertices = {{around, -height / 4, 0},
                     {-around / 2, -height / 4, edge_length / 2},
                     {-around / 2, -height / 4, -edge_length / 2},
                     {0, 3 * height / 4, 0}};
    mesh.faces = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
    return mesh;
}

TetrahedralMesh bar(const Vec3& size, std::array<int, 3> cells, CellSplit split)
{
    for (double length : size)
        require_length("size of a bar", length);
    require_cells(cells);
    const int nx = cells[0], ny = cells[1], nz = cells[2];
    const auto node = [&](int i, int j, int k) { return i + (nx + 1) * (j + (ny + 1) * k); };

    TetrahedralMesh mesh;
    for (int k = 0; k <= nz; ++k)
        for (int j = 0; j <= ny; ++j)
            for (int i = 0; i <= nx; ++i)
                mesh.nodes.push_back(size.cwiseProduct(Vec3(double(i) / nx, double(j) / ny, double(k) / nz) -
                                                       Vec3::Constant(0.5)));

    const bool alike = split == CellSplit::six;
    const std::array pattern{alike ? six_around_the_diagonal() : five(false),
                             alike ? six_around_the_diagonal() : five(true)};
    for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i)
                for (const CellTetrahedron& local : pattern[(i + j + k) % 2]) {
                    std::array<int, 4> element{};
                    for (std::size_t c = 0; c < 4; ++c)
                        element[c] = node(i + (local[c] & 1), j + (local[c] >> 1 & 1),
                                          k + (local[c] >> 2 & 1));
                    mesh.elements.push_back(element);
                }
    return mesh;
}

}  // namespace enduring
