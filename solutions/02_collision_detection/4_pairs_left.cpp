#include "exercises/02_collision_detection/4_pairs_left.hpp"

#include <array>

namespace enduring {

double predicted_factor() { return 4; }

long pairs_left(const GlidingPlate& scene)
{
    FaceTree plate(scene.plate, scene.plate_t0), floor(scene.floor, scene.floor_both);
    plate.refit(scene.plate_step());
    floor.refit(scene.floor_step());
    CandidatePairs pairs;
    collect_pairs(plate, floor, pairs);
    return static_cast<long>(pairs.size());
}

double measured_factor(int cells, double glide)
{
    const double coarse = static_cast<double>(pairs_left(gliding_plate(cells, glide)));
    return static_cast<double>(pairs_left(gliding_plate(2 * cells, glide))) / coarse;
}

double mean_overlaps(const Footprint& box, const Footprint& other, double cell)
{
    return (box.x + other.x) / cell * (box.z + other.z) / cell;
}

double law_of_pairs(int cells, double glide)
{
    struct Kind {
        double count;  // in the plate
        Footprint rest;
    };
    const double n = cells, cell = 1 / n;
    const std::array<Kind, 3> edges{
        {{n * (n + 1), {cell, 0}}, {n * (n + 1), {0, cell}}, {n * n, {cell, cell}}}};
    const auto swept = [glide](const Footprint& rest) { return Footprint{rest.x + glide, rest.z}; };

    double pairs = (n + 1) * (n + 1) * 2 * mean_overlaps(swept({0, 0}), {cell, cell}, cell);
    pairs += 2 * n * n * mean_overlaps(swept({cell, cell}), {0, 0}, cell);
    for (const Kind& a : edges)
        for (const Kind& b : edges)
            pairs += a.count * mean_overlaps(swept(a.rest), b.rest, cell);
    return pairs;
}

}  // namespace enduring
