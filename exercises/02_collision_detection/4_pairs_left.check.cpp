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
}

TEST_CASE("law: each cell of glide adds the same number of pairs")
{
    given("8 cells a side, glides of 0, 0.25 and 0.5 m");
    const double none = law_of_pairs(8, 0), some = law_of_pairs(8, 0.25), more = law_of_pairs(8, 0.5);
    expect("pairs that the second quarter of a metre adds, as the first does", more - some, some - none,
           1e-6 * more);
}
