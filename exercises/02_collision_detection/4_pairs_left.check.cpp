#include "exercises/02_collision_detection/4_pairs_left.hpp"
#include "exercises/checking.hpp"

#include <cmath>

using namespace enduring;

namespace {

/// Counted by hand, kind by kind: a plate of n x n cells that glides over m cells.
double counted(double n, double m)
{
    const double vertices = 2 * (n + 1) * (n + 1) * (1 + m), faces = 2 * n * n * (1 + m);
    const double along_x = n * (n + 1) * (3 + 2 * m), along_z = n * (n + 1) * (3 + 5 * m),
                 diagonals = n * n * (8 + 5 * m);
    return vertices + faces + along_x + along_z + diagonals;
}

}  // namespace

TEST_CASE("prediction: a number is written down")
{
    expect_that("the predicted factor is a positive number",
                predicted_factor() > 0 && std::isfinite(predicted_factor()));
}

TEST_CASE("measurement: a plate that goes through the floor leaves some pairs")
{
    given("4 cells a side, no glide");
    expect_that("there are pairs", pairs_left(gliding_plate(4, 0)) > 0);
}

TEST_CASE("measurement: a plate that comes straight down leaves the pairs that one can count")
{
    for (const int cells : {1, 4, 16}) {
        given(cells, " cells a side, no glide");
        expect("pairs", pairs_left(gliding_plate(cells, 0)), counted(cells, 0), 0);
    }
}

TEST_CASE("measurement: a plate that glides leaves the pairs on its way, too")
{
    for (const int cells : {4, 8, 16}) {
        given(cells, " cells a side, glide 0.25 m");
        expect("pairs", pairs_left(gliding_plate(cells, 0.25)), counted(cells, 0.25 * cells), 0);
    }
}

TEST_CASE("factor: it is that of the plate, the cells and the glide that are asked for")
{
    for (const int cells : {4, 8})
        for (const double glide : {0.0, 0.25, 0.5}) {
            given(cells, " and twice as many cells a side, glide ", glide, " m");
            expect("pairs over pairs", measured_factor(cells, glide),
                   counted(2 * cells, 2 * cells * glide) / counted(cells, cells * glide), 1e-9);
        }
}

TEST_CASE("factor: four times the triangles, and seven times the pairs where the plate glides")
{
    given("16 and 32 cells a side, glide 0.25 m");
    expect("pairs over pairs", measured_factor(16, 0.25), counted(32, 8) / counted(16, 4), 1e-9);
    say("16 cells a side: ", pairs_left(gliding_plate(16, 0.25)),
        " pairs; 32 cells a side: ", pairs_left(gliding_plate(32, 0.25)));
    say("the plate glides:             ", measured_factor(16, 0.25), " times as many");
    say("it comes straight down:       ", measured_factor(16, 0), " times as many");
    say("you predicted, for the first: ", predicted_factor());
}

TEST_CASE("overlaps: a point lies in one cell, and a cell holds one point")
{
    given("cells of 0.5 m");
    expect("a point and boxes of a cell", mean_overlaps({0, 0}, {0.5, 0.5}, 0.5), 1.0, 1e-12);
    expect("a box of a cell and points", mean_overlaps({0.5, 0.5}, {0, 0}, 0.5), 1.0, 1e-12);
}

TEST_CASE("overlaps: a box of the size of a cell meets four")
{
    given("cells of 0.5 m");
    expect("a box of a cell and boxes of a cell", mean_overlaps({0.5, 0.5}, {0.5, 0.5}, 0.5), 4.0, 1e-12);
}

TEST_CASE("overlaps: sizes along x and along z count separately")
{
    given("cells of 0.5 m");
    expect("lines along x never meet lines along x", mean_overlaps({0.5, 0}, {0.5, 0}, 0.5), 0.0, 1e-12);
    expect("a line along x meets one line along z", mean_overlaps({0.5, 0}, {0, 0.5}, 0.5), 1.0, 1e-12);
    expect("a box of 2 m along x and half a metre along z, and boxes of a cell",
           mean_overlaps({2, 0.5}, {0.5, 0.5}, 0.5), 10.0, 1e-12);
}

TEST_CASE("overlaps: it is the average over all places of the box, which need be no whole number")
{
    const double cell = 0.4;
    for (const double x : {0.1, 0.7})
        for (const double z : {0.3, 1.1}) {
            const Footprint box{x, z}, other{0.25, 0.15};
            // Along each direction alone: put the box at many places and count.
            const auto along = [cell](double a, double b) {
                int overlaps = 0;
                for (int place = 0; place < 1000; ++place)
                    for (int i = -10; i <= 10; ++i) {
                        const double begin = (place + 0.5) / 1000 * cell;
                        overlaps += begin < i * cell + b && i * cell < begin + a;
                    }
                return overlaps / 1000.0;
            };
            given("a box of ", x, " by ", z, " m, and boxes of 0.25 by 0.15 m in cells of ", cell, " m");
            expect("overlaps", mean_overlaps(box, other, cell), along(x, other.x) * along(z, other.z), 0.02);
        }
}

TEST_CASE("law: it counts what a plate meets that comes straight down")
{
    given(
        "1 cell a side, no glide: 8 pairs of a vertex and a face, 2 of a face and a vertex, 20 of two edges");
    expect("pairs by the law", law_of_pairs(1, 0), counted(1, 0), 1e-6);
    for (const int cells : {4, 100}) {
        given(cells, " cells a side, no glide");
        expect("pairs by the law", law_of_pairs(cells, 0), counted(cells, 0), 1e-6 * counted(cells, 0));
    }
}

TEST_CASE("law: it counts what a plate meets that glides")
{
    for (const int cells : {4, 8, 100}) {
        given(cells, " cells a side, glide 0.25 m");
        expect("pairs by the law", law_of_pairs(cells, 0.25), counted(cells, 0.25 * cells),
               1e-6 * counted(cells, 0.25 * cells));
    }
    for (const int glided : {7, 29}) {
        given("100 cells a side, glide of ", glided, " cells");
        expect("pairs by the law", law_of_pairs(100, glided / 100.0), counted(100, glided),
               1e-9 * counted(100, glided));
    }
}

TEST_CASE("law: each cell of glide adds the same number of pairs")
{
    given("8 cells a side, glides of 0, 0.25 and 0.5 m");
    const double none = law_of_pairs(8, 0), some = law_of_pairs(8, 0.25), more = law_of_pairs(8, 0.5);
    expect("pairs that the second quarter of a metre adds, as the first does", more - some, some - none,
           1e-6 * more);
}
