#include "chapters/02_collision_detection/slabs.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

/// A body with more has hardly any normal that it lies behind as a whole. A tenth: none has slabs. Ten times:
/// slabs of spheres take time, and miss nothing that boxes do not.
constexpr std::size_t few_faces = 24;

bool is_known(const std::vector<Slab>& slabs, const Vec3& axis)
{
    constexpr double parallel = 1 - 1e-9;
    return std::any_of(slabs.begin(), slabs.end(),
                       [&](const Slab& slab) { return std::abs(slab.axis.dot(axis)) > parallel; });
}

Slab slab_along(const Vec3& axis, const SurfaceStep& surface)
{
    Slab slab{axis, INFINITY, -INFINITY};
    for (const std::span<const Vec3>& positions : {surface.t0, surface.t1})
        for (const Vec3& position : positions) {
            slab.low = std::min(slab.low, axis.dot(position));
            slab.high = std::max(slab.high, axis.dot(position));
        }
    return slab;
}

}  // namespace

//! [slabs]
bool Slab::misses(const SweptBox& box) const
{
    constexpr double rounding = 1e-12;  // of coordinates; a box that is missed by less is looked at
    const Vec3 middle = 0.5 * (box.low + box.high), half = 0.5 * (box.high - box.low);
    const double at = axis.dot(middle), reach = axis.cwiseAbs().dot(half),
                 apart = rounding * (middle.norm() + half.norm() + std::abs(low) + std::abs(high));
    return at - reach > high + apart || at + reach < low - apart;
}

std::vector<Slab> slabs_along_faces(const SurfaceStep& surface, double margin)
{
    std::vector<Slab> slabs;
    if (surface.topology.faces().size() > few_faces)
        return slabs;
    for (const auto& [a, b, c] : surface.topology.faces()) {
        const Vec3 normal = (surface.start(b) - surface.start(a))
                                .cross(surface.start(c) - surface.start(a))
                                .stableNormalized();
        if (!normal.isZero(0) && !is_known(slabs, normal))
            slabs.push_back(slab_along(normal, surface));
    }
    for (Slab& slab : slabs) {
        slab.low -= margin * slab.axis.lpNorm<1>();  // as far as a box with this margin reaches
        slab.high += margin * slab.axis.lpNorm<1>();
    }
    return slabs;
}
//! [slabs]

bool BodySlabs::misses(std::size_t body, std::size_t other)
{
    if (!slabs_[body])
        slabs_[body] = of_body_(body);
    return std::any_of(slabs_[body]->begin(), slabs_[body]->end(),
                       [&](const Slab& slab) { return slab.misses(boxes_[other]); });
}

}  // namespace enduring
