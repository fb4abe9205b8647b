#pragma once

#include "common/fem/basis.hpp"
#include "common/scenes/scene.hpp"

namespace enduring::chapter08 {

/// Two soft cubes of 0.3 m and 27 kg strike each other off their centres, without gravity and friction.
struct SoftCollision {
    Basis basis = Basis::linear;
    double young = 1e5;  ///< [Pa]
    double dt = 0.01;    ///< [s]
    unsigned seed = 1;   ///< turns them, and says how fast they spin
    int rigid = 0;       ///< how many of the two are rigid
};
Scene soft_collision(const SoftCollision& collision);

/// Rings of soft elements, each through the one above; the uppermost is held at its top.
struct SoftChain {
    int rings = 2;
    double young = 1e5;  ///< [Pa]
    double dt = 0.01;    ///< [s]
};
Scene soft_chain(const SoftChain& chain);
/// How often ring `one` runs through ring `other`, with its sign.
int linking_number(const Scene& scene, std::size_t one, std::size_t other);

/// A soft cube of 1 m and a ton on one of a kilogram.
Scene cube_on_light_cube(double young, double dt);

/// A bar of 1 m by 0.2 m that is twisted by a whole turn, held at one end and let go.
Scene twisted_soft_bar(Basis basis, double young, double dt);

/// Of all bodies about the origin [kg m^2/s].
Vec3 angular_momentum(const World& world);
/// The sum of the lengths of what each body has of it.
double turning(const World& world);

}  // namespace enduring::chapter08
