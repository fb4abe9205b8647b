#include "common/geometry/mend.hpp"

#include "common/geometry/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace enduring {
namespace {

/// The side of a face that runs from one corner to the next.
struct FaceSide {
    int face, corner;
};
using SidesOfEdges = std::map<Edge, std::vector<FaceSide>>;

int& corner_of(std::vector<Face>& faces, const FaceSide& side, int further = 0)
{
    return faces[static_cast<std::size_t>(side.face)][static_cast<std::size_t>((side.corner + further) % 3)];
}
int corner_of(const std::vector<Face>& faces, const FaceSide& side, int further = 0)
{
    return faces[static_cast<std::size_t>(side.face)][static_cast<std::size_t>((side.corner + further) % 3)];
}

SidesOfEdges sides_of_edges(const std::vector<Face>& faces)
{
    SidesOfEdges sides;
    for (int face = 0; face < static_cast<int>(faces.size()); ++face)
        for (int corner = 0; corner < 3; ++corner) {
            const FaceSide side{face, corner};
            const auto [low, high] = std::minmax({corner_of(faces, side), corner_of(faces, side, 1)});
            sides[{low, high}].push_back(side);
        }
    return sides;
}

bool names_twice(const Face& face) { return face[0] == face[1] || face[1] == face[2] || face[2] == face[0]; }

/// Numbers in sets that are joined; each set is known by its least number.
class Joined {
public:
    explicit Joined(std::size_t count) : towards_(count) { std::iota(towards_.begin(), towards_.end(), 0); }
    int least(int one)
    {
        while (towards_[static_cast<std::size_t>(one)] != one)
            one = towards_[static_cast<std::size_t>(one)] =
                towards_[static_cast<std::size_t>(towards_[static_cast<std::size_t>(one)])];
        return one;
    }
    void join(int one, int other)
    {
        const auto [low, high] = std::minmax({least(one), least(other)});
        towards_[static_cast<std::size_t>(high)] = low;
    }

private:
    std::vector<int> towards_;
};

//! [flat_faces]
/// Takes faces without area out, as many in a round as do not touch each other.
/// @return  how many; 0 at the end
int take_flat_faces_out(SurfaceMesh& mesh)
{
    const SidesOfEdges sides = sides_of_edges(mesh.faces);
    std::vector<char> touched(mesh.vertices.size(), 0);
    std::vector<Face> more;
    for (int f = 0; f < static_cast<int>(mesh.faces.size()); ++f) {
        Face& face = mesh.faces[static_cast<std::size_t>(f)];
        const auto length = [&](int i) {
            const FaceSide side{f, i};
            return (mesh.vertices[corner_of(mesh.faces, side)] -
                    mesh.vertices[corner_of(mesh.faces, side, 1)])
                .squaredNorm();
        };
        const std::array<double, 3> squared{length(0), length(1), length(2)};
        const int longest =
                      static_cast<int>(std::max_element(squared.begin(), squared.end()) - squared.begin()),
                  shortest =
                      static_cast<int>(std::min_element(squared.begin(), squared.end()) - squared.begin());
        const double most = squared[static_cast<std::size_t>(longest)];
        const Vec3 area = (mesh.vertices[face[1]] - mesh.vertices[face[0]])
                              .cross(mesh.vertices[face[2]] - mesh.vertices[face[0]]);
        if (area.norm() > tolerance::least_area * most || std::any_of(face.begin(), face.end(), [&](int v) {
                return touched[static_cast<std::size_t>(v)] != 0;
            }))
            continue;
        const FaceSide base{f, longest}, small{f, shortest};
        const int p = corner_of(mesh.faces, base), q = corner_of(mesh.faces, base, 1),
                  middle = corner_of(mesh.faces, base, 2);
        for (const FaceSide& near : sides.at({std::min(p, q), std::max(p, q)}))
            for (const int v : mesh.faces[static_cast<std::size_t>(near.face)])
                touched[static_cast<std::size_t>(v)] = 1;
        if (squared[static_cast<std::size_t>(shortest)] <= tolerance::least_area * most) {
            const int kept = std::min(corner_of(mesh.faces, small), corner_of(mesh.faces, small, 1)),
                      gone = std::max(corner_of(mesh.faces, small), corner_of(mesh.faces, small, 1));
            for (Face& other : mesh.faces)
                std::replace(other.begin(), other.end(), gone, kept);
            continue;
        }
        for (const FaceSide& near : sides.at({std::min(p, q), std::max(p, q)}))
            if (near.face != f) {  // cut at the middle corner, which lies on its side
                more.push_back(mesh.faces[static_cast<std::size_t>(near.face)]);
                corner_of(mesh.faces, near, 1) = middle;
                more.back()[static_cast<std::size_t>(near.corner)] = middle;
            }
        face = {p, p, p};
    }
    mesh.faces.insert(mesh.faces.end(), more.begin(), more.end());
    return static_cast<int>(std::erase_if(mesh.faces, names_twice));
}
//! [flat_faces]

/// Of faces over the same vertices one is left, if more of them face one way than the other; else none, as of
/// a wall between two rooms.
int take_double_faces_out(std::vector<Face>& faces)
{
    std::map<Face, std::array<std::vector<std::size_t>, 2>> same;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        Face turned = faces[f], sorted = faces[f];
        std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()), turned.end());
        std::sort(sorted.begin(), sorted.end());
        same[sorted][turned == sorted ? 0 : 1].push_back(f);
    }
    std::vector<char> kept(faces.size(), 0);
    for (const auto& [corners, ways] : same)
        if (ways[0].size() != ways[1].size())
            kept[ways[ways[0].size() > ways[1].size() ? 0 : 1].front()] = 1;
    std::vector<Face> left;
    for (std::size_t f = 0; f < faces.size(); ++f)
        if (kept[f] != 0)
            left.push_back(faces[f]);
    const auto taken = static_cast<int>(faces.size() - left.size());
    faces = std::move(left);
    return taken;
}

//! [flaps]
/// Patches are faces that are neighbours over edges of two faces. One that has a border and touches another
/// one, which has none, hangs on it.
int take_flaps_out(std::vector<Face>& faces, std::size_t vertices)
{
    const SidesOfEdges sides = sides_of_edges(faces);
    Joined patches(faces.size());
    for (const auto& [edge, at] : sides)
        if (at.size() == 2)
            patches.join(at[0].face, at[1].face);
    std::vector<char> is_open(faces.size(), 0), hangs(faces.size(), 0), is_held(vertices, 0);
    for (const auto& [edge, at] : sides)
        if (at.size() == 1)
            is_open[static_cast<std::size_t>(patches.least(at[0].face))] = 1;
    const auto patch_of = [&](std::size_t f) {
        return static_cast<std::size_t>(patches.least(static_cast<int>(f)));
    };
    for (std::size_t f = 0; f < faces.size(); ++f)
        if (is_open[patch_of(f)] == 0)
            for (const int v : faces[f])
                is_held[static_cast<std::size_t>(v)] = 1;
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (const int v : faces[f])
            if (is_open[patch_of(f)] != 0 && is_held[static_cast<std::size_t>(v)] != 0)
                hangs[patch_of(f)] = 1;
    std::vector<Face> left;
    for (std::size_t f = 0; f < faces.size(); ++f)
        if (hangs[patch_of(f)] == 0)
            left.push_back(faces[f]);
    const auto taken = static_cast<int>(faces.size() - left.size());
    faces = std::move(left);
    return taken;
}
//! [flaps]

//! [around_an_edge]
/// The sides at an edge in pairs that have the inside between them. Seen along the edge from its smaller
/// vertex, a face that runs along it has the inside below its own angle, and one that runs against it above.
std::vector<std::pair<FaceSide, FaceSide>> pairs_around(const SurfaceMesh& mesh, const Edge& edge,
                                                        const std::vector<FaceSide>& sides)
{
    if (sides.size() == 2)
        return {{sides[0], sides[1]}};
    const Vec3 origin = mesh.vertices[edge[0]], along = (mesh.vertices[edge[1]] - origin).normalized();
    const Vec3 across = along.unitOrthogonal(), up = along.cross(across);
    struct Turned {
        double angle;
        bool runs_along;
        FaceSide side;
    };
    std::vector<Turned> around;
    for (const FaceSide& side : sides) {
        const Vec3 inwards = mesh.vertices[corner_of(mesh.faces, side, 2)] - origin;
        around.push_back(
            {std::atan2(inwards.dot(up), inwards.dot(across)), corner_of(mesh.faces, side) == edge[0], side});
    }
    std::stable_sort(around.begin(), around.end(),
                     [](const Turned& a, const Turned& b) { return a.angle < b.angle; });
    std::vector<std::pair<FaceSide, FaceSide>> pairs;
    for (std::size_t i = 0; i < around.size(); ++i) {
        const Turned &one = around[i], &next = around[(i + 1) % around.size()];
        if (!one.runs_along && next.runs_along)
            pairs.emplace_back(one.side, next.side);
    }
    return pairs;
}
//! [around_an_edge]

/// Gives each fan of faces around a vertex a vertex of its own.
void part_fans(SurfaceMesh& mesh, MendCounts& counts)
{
    Joined corners(3 * mesh.faces.size());
    const auto number = [](const FaceSide& side, int further) {
        return 3 * side.face + (side.corner + further) % 3;
    };
    for (const auto& [edge, sides] : sides_of_edges(mesh.faces)) {
        counts.parted_edges += sides.size() > 2 ? 1 : 0;
        if (sides.size() < 2)
            continue;
        for (const auto& [one, other] : pairs_around(mesh, edge, sides)) {
            const bool opposite = corner_of(mesh.faces, one) != corner_of(mesh.faces, other);
            corners.join(number(one, 0), number(other, opposite ? 1 : 0));
            corners.join(number(one, 1), number(other, opposite ? 0 : 1));
        }
    }
    std::vector<int> first(mesh.vertices.size(), -1);
    std::map<int, int> vertex_of_fan;
    const std::vector<Face> before = mesh.faces;
    for (int c = 0; c < static_cast<int>(3 * before.size()); ++c) {
        const int fan = corners.least(c),
                  old = before[static_cast<std::size_t>(c / 3)][static_cast<std::size_t>(c % 3)];
        const auto [known, is_new] = vertex_of_fan.try_emplace(fan, old);
        if (is_new && std::exchange(first[static_cast<std::size_t>(old)], fan) >= 0) {
            known->second = static_cast<int>(mesh.vertices.size());
            mesh.vertices.push_back(Vec3(mesh.vertices[static_cast<std::size_t>(old)]));
            ++counts.parted_vertices;
        }
        mesh.faces[static_cast<std::size_t>(c / 3)][static_cast<std::size_t>(c % 3)] = known->second;
    }
}

std::string counted_of(int count, const std::string& one, const std::string& many)
{
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace

std::string MendCounts::text() const
{
    std::string text;
    const auto add = [&](int count, const std::string& what) {
        if (count > 0)
            text += (text.empty() ? "" : "; ") + what;
    };
    add(flat_faces, counted_of(flat_faces, "face", "faces") + " without area taken out");
    add(double_faces,
        counted_of(double_faces, "face", "faces") + " over the vertices of another one taken out");
    add(flap_faces, counted_of(flap_faces, "face", "faces") + " of flaps taken out");
    add(parted_edges, "parts that shared " + counted_of(parted_edges, "edge", "edges") + " parted");
    add(parted_vertices, counted_of(parted_vertices, "vertex", "vertices") + " more, where parts met");
    return text;
}

MendedSurface mended(const SurfaceMesh& mesh, Border border)
{
    MendedSurface result{mesh, {}};
    result.counts.flat_faces = static_cast<int>(std::erase_if(result.mesh.faces, names_twice));
    constexpr int most_rounds = 1000;  // a face that is cut may leave another one without area
    for (int round = 0; round < most_rounds; ++round) {
        const int taken = take_flat_faces_out(result.mesh);
        result.counts.flat_faces += taken;
        if (taken == 0)
            break;
    }
    result.counts.double_faces = take_double_faces_out(result.mesh.faces);
    if (border == Border::refused)
        result.counts.flap_faces = take_flaps_out(result.mesh.faces, result.mesh.vertices.size());
    part_fans(result.mesh, result.counts);
    result.mesh = without_unused_vertices(result.mesh);
    return result;
}

}  // namespace enduring
