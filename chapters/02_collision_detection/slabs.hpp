#pragma once

#include "chapters/02_collision_detection/swept_box.hpp"

#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace enduring {

/// What a surface passes through in a step lies between two planes.
struct Slab {
    Vec3 axis;         ///< of unit length
    double low, high;  ///< along it [m]

    /// Whether a box lies beside it, whatever rounding does.
    bool misses(const SweptBox& box) const;
};

/// Those along the normals of its faces, of a surface with few faces; none for others. An axis-aligned box
/// around a plate that is tilted is mostly empty.
/// @param margin  by which each is wider on both sides [m]
std::vector<Slab> slabs_along_faces(const SurfaceStep& surface, double margin);

/// The slabs of some bodies, each found when it is first asked for.
class BodySlabs {
public:
    /// @param boxes    around the bodies
    /// @param of_body  slabs_along_faces() of one
    BodySlabs(std::span<const SweptBox> boxes, std::function<std::vector<Slab>(std::size_t)> of_body)
        : boxes_(boxes), of_body_(std::move(of_body)), slabs_(boxes.size())
    {}
    /// Whether a slab of one misses the box of the other: then they do not touch in the step.
    bool keep_apart(std::size_t a, std::size_t b) { return misses(a, b) || misses(b, a); }

private:
    bool misses(std::size_t body, std::size_t other);

    std::span<const SweptBox> boxes_;
    std::function<std::vector<Slab>(std::size_t)> of_body_;
    std::vector<std::optional<std::vector<Slab>>> slabs_;
};

}  // namespace enduring
