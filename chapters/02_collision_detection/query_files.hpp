#pragma once

#include "chapters/02_collision_detection/query.hpp"

#include <array>
#include <filesystem>
#include <istream>
#include <string>
#include <vector>

namespace enduring {

/// One query of a file: v f0 f1 f2 or ea0 ea1 eb0 eb1 at the start of the step, then at its end.
struct FileQuery {
    std::array<Vec3, 8> points;
    std::optional<bool> collides;  ///< the answer, where the file gives one

    VertexFaceStep vertex_face() const;
    EdgeEdgeStep edge_edge() const;
};

/// Reads queries with rational coordinates, the format of the public benchmark that came with
/// Tight-Inclusion (Wang et al. 2021): 8 lines a query, one point a line, `num,den` for x, y
/// and z, and then, if known, the answer 0 or 1, the same on all eight. Numerators and
/// denominators are integers of any length whose quotient is a double.
/// @throws InputError  "file:line: reason": no such file, a field missing or too many, not an integer, a zero
///                     denominator, a quotient that is no finite double, answers that differ, lines left over
std::vector<FileQuery> read_queries(const std::filesystem::path& file);
std::vector<FileQuery> read_queries(std::istream& stream, const std::string& name);

}  // namespace enduring
