#include "common/geometry/box_shapes.hpp"

#include "common/geometry/shape_arguments.hpp"

#include <numbers>

namespace enduring {
namespace {

using Cells = std::array<int, 3>;

/// Numbers the points of a regular lattice that lie on its outside, in
/// the order in which they are first asked for.
class BoxLattice {
public:
    BoxLattice(const Vec3& size, const Cells& cells) : size_(size), cells_(cells)
    {
        const auto points = [&](std::size_t axis) { return static_cast<std::size_t>(cells[axis]) + 1; };
        numbers_.assign(points(0) * points(1) * points(2), -1);
    }

    int vertex(const Cells& at)
    {
        const int row = at[1] + (cells_[1] + 1) * at[2];
        const std::size_t index = static_cast<std::size_t>(row) * (cells_[0] + 1) + at[0];
        if (numbers_[index] < 0) {
            numbers_[index] = static_cast<int>(vertices.size());
            const Vec3 fraction{1.0 * at[0] / cells_[0], 1.0 * at[1] / cells_[1], 1.0 * at[2] / cells_[2]};
            vertices.push_back(size_.cwiseProduct(fraction - Vec3::Constant(0.5)));
        }
        return numbers_[index];
    }

    std::vector<Vec3> vertices;

private:
    Vec3 size_;
    Cells cells_;
    std::vector<int> numbers_;
};

/// One side of the box, at the low or high end of `axis`, as a grid of cells facing outwards.
void add_side(BoxLattice& lattice, const Cells& cells, std::size_t axis, bool high, std::vector<Face>& faces)
{
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int j = 0; j < cells[v]; ++j)
        for (int i = 0; i < cells[u]; ++i) {
            const auto corner = [&](int di, int dj) {
                Cells at{};
                at[axis] = high ? cells[axis] : 0;
                at[u] = i + di;
                at[v] = j + dj;
                return lattice.vertex(at);
            };
            const int a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
            if (high)
                faces.insert(faces.end(), {{a, b, c}, {a, c, d}});
            else
                faces.insert(faces.end(), {{a, c, b}, {a, d, c}});
        }
}

}  // namespace

SurfaceMesh box(const Vec3& size, std::array<int, 3> cells)
{
    for (double length : size)
        require_length("size of a box", length);
    require_cells(cells);
    BoxLattice lattice(size, cells);
    SurfaceMesh mesh;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (bool high : {false, true})
            add_side(lattice, cells, axis, high, mesh.faces);
    mesh.vertices = std::move(lattice.vertices);
    return mesh;
}

SurfaceMesh slope(const Vec3& size, double angle, std::array<int, 3> cells)
{
    if (!(std::abs(angle) < std::numbers::pi / 2))
        throw InputError("angle of a slope is " + std::to_string(angle) + "; it must lie in (-pi/2, pi/2)");
    SurfaceMesh mesh = box(size, cells);
    const Eigen::AngleAxisd tilt(angle, Vec3::UnitZ());
    for (Vec3& x : mesh.vertices)
        x = tilt * (x - Vec3(0, size.y() / 2, 0));
    return mesh;
}

SurfaceMesh plane_grid(double size_x, double size_z, std::array<int, 2> cells, GridDiagonals diagonals)
{
    require_length("size_x of a plane grid", size_x);
    require_length("size_z of a plane grid", size_z);
    require_cells(cells);
    const int nx = cells[0], nz = cells[1];
    const auto point = [&](double i, double k) {
        return Vec3((i / nx - 0.5) * size_x, 0, (k / nz - 0.5) * size_z);
    };

    SurfaceMesh mesh;
    for (int k = 0; k <= nz; ++k)
        for (int i = 0; i <= nx; ++i)
            mesh.vertices.push_back(point(i, k));
    for (int k = 0; k < nz; ++k)
        for (int i = 0; i < nx; ++i) {
            const int a = i + (nx + 1) * k, b = a + nx + 1, c = b + 1, d = a + 1;
            if (diagonals == GridDiagonals::crossed) {
                const int middle = static_cast<int>(mesh.vertices.size());
                mesh.vertices.push_back(point(i + 0.5, k + 0.5));
                mesh.faces.insert(mesh.faces.end(),
                                  {{a, b, middle}, {b, c, middle}, {c, d, middle}, {d, a, middle}});
            } else if (diagonals == GridDiagonals::alternating && (i + k) % 2 == 1) {
                mesh.faces.insert(mesh.faces.end(), {{a, b, d}, {b, c, d}});
            } else {
                mesh.faces.insert(mesh.faces.end(), {{a, b, c}, {a, c, d}});
            }
        }
    return mesh;
}

}  // namespace enduring
