#include "exercises/09_deep_contacts/2_ties.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

using namespace enduring;

namespace {

std::string told(const LatticePoint& p) { return in_words("(", p.x, ", ", p.y, ")"); }

/// Coordinates of at most 20, made so large that e is a whole number: e = (5000, 1) / 5000^2, which is too
/// small to change an answer that is no tie.
constexpr std::int64_t fine = 5000;

LatticePoint magnified(const LatticePoint& p) { return {p.x * fine * fine, p.y * fine * fine}; }

LatticePoint really_shifted(const LatticePoint& p, int shift)
{
    const LatticePoint large = magnified(p);
    return {large.x + shift * fine, large.y + shift};
}

__extension__ using Wide = __int128;

/// Sign of (b - a) x (p - a); no tie is possible where p was really shifted.
int plain_side(const LatticePoint& p, const LatticePoint& a, const LatticePoint& b)
{
    const Wide area = static_cast<Wide>(b.x - a.x) * (p.y - a.y) - static_cast<Wide>(b.y - a.y) * (p.x - a.x);
    return (area > 0) - (area < 0);
}

int plain_crossing(const LatticePoint& p, const LatticePoint& q, const LatticePoint& a, const LatticePoint& b)
{
    const int from = plain_side(p, a, b), to = plain_side(q, a, b);
    return from != to && plain_side(a, p, q) != plain_side(b, p, q) ? from : 0;
}

/// Checks one of many; a case ends with the first that is wrong.
bool is_right(const std::string& what, int got, int expected)
{
    expect(what, got, expected, 0);
    return got == expected;
}

RandomInputs generator(8);

LatticePoint random_point(int size)
{
    const int x = generator.whole(-size, size), y = generator.whole(-size, size);
    return {x, y};
}

LatticePolygon rectangle(std::int64_t x, std::int64_t y, std::int64_t width, std::int64_t height)
{
    return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

const LatticePolygon notched{{0, 0}, {6, 0}, {6, 6}, {3, 2}, {0, 6}};

int crossings(const LatticePolygon& one, const LatticePolygon& other)
{
    int count = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
        for (std::size_t j = 0; j < other.size(); ++j)
            count += crosses(one[i], one[(i + 1) % one.size()], other[j], other[(j + 1) % other.size()], 1) !=
                     0;
    return count;
}

}  // namespace

TEST_CASE("side: left of the line from a to b is 1, right is -1, whatever the shift")
{
    for (const int shift : {1, -1}) {
        given("a (0, 0), b (4, 2), shift ", shift);
        expect("side of (1, 3)", side_of_line({1, 3}, {0, 0}, {4, 2}, shift), 1, 0);
        expect("side of (3, 1)", side_of_line({3, 1}, {0, 0}, {4, 2}, shift), -1, 0);
        expect("side of (1, 3), with a and b exchanged", side_of_line({1, 3}, {4, 2}, {0, 0}, shift), -1, 0);
    }
}

TEST_CASE("side: a point on the line goes where the shift takes it, for lines of all directions")
{
    for (const LatticePoint& along :
         {LatticePoint{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}, {3, 2}, {-2, 5}})
        for (const int shift : {1, -1})
            for (const std::int64_t place : {-2, 0, 1, 3}) {
                const LatticePoint a{7, -3}, b{7 + along.x, -3 + along.y};
                const LatticePoint p{7 + place * along.x, -3 + place * along.y};
                given("a ", told(a), ", b ", told(b), ", p ", told(p), ", shift ", shift);
                if (!is_right("side", side_of_line(p, a, b, shift),
                              plain_side(really_shifted(p, shift), magnified(a), magnified(b))))
                    return;
            }
}

TEST_CASE("side: without a line there is no side")
{
    given("a and b both (2, 5)");
    expect("side of (3, 5)", side_of_line({3, 5}, {2, 5}, {2, 5}, 1), 0, 0);
    expect("side of (2, 5)", side_of_line({2, 5}, {2, 5}, {2, 5}, -1), 0, 0);
}

TEST_CASE("side: it is exact for coordinates up to 1e9")
{
    const int large = 1000000000;
    const LatticePoint a{-large, -large + 1}, b{large, large};
    // (b - a) x (p - a) = 2e9 (p.y - a.y) - (2e9 - 1) (p.x - a.x)
    for (const int shift : {1, -1}) {
        given("a ", told(a), ", b ", told(b), ", shift ", shift);
        expect("side of (1e9 - 1, 1e9 - 1)", side_of_line({large - 1, large - 1}, a, b, shift), -1, 0);
        expect("side of (1e9 - 1, 1e9)", side_of_line({large - 1, large}, a, b, shift), 1, 0);
        expect("side of (0, 0)", side_of_line({0, 0}, a, b, shift), -1, 0);
        expect("side of (0, 1)", side_of_line({0, 1}, a, b, shift), 1, 0);
    }
    for (int trial = 0; trial < 1000; ++trial) {
        LatticePoint points[3];
        for (LatticePoint& point : points)
            point = random_point(large);
        const auto& [p, from, to] = points;
        given("a ", told(from), ", b ", told(to), ", p ", told(p), ", shift 1");
        if (!is_right("side", side_of_line(p, from, to, 1), plain_side(p, from, to)))
            return;
    }
}

TEST_CASE("crosses: from the left to the right is 1, back is -1, and past either end it is 0")
{
    const LatticePoint a{0, 0}, b{0, 10};
    for (const int shift : {1, -1}) {
        given("a (0, 0), b (0, 10), shift ", shift);
        expect("from (-3, 5) to (4, 5)", crosses({-3, 5}, {4, 5}, a, b, shift), 1, 0);
        expect("from (4, 5) to (-3, 5)", crosses({4, 5}, {-3, 5}, a, b, shift), -1, 0);
        expect("from (-3, 5) to (4, 5), with a and b exchanged", crosses({-3, 5}, {4, 5}, b, a, shift), -1,
               0);
        expect("from (-3, 12) to (4, 12), above b", crosses({-3, 12}, {4, 12}, a, b, shift), 0, 0);
        expect("from (-3, -1) to (4, -2), below a", crosses({-3, -1}, {4, -2}, a, b, shift), 0, 0);
        expect("from (-3, 5) to (-1, 5), which does not reach it", crosses({-3, 5}, {-1, 5}, a, b, shift), 0,
               0);
    }
}

TEST_CASE("crosses: all pairs of segments on a small lattice, as if they were really shifted")
{
    for (int trial = 0; trial < 4000; ++trial) {
        const LatticePoint p = random_point(2), q = random_point(2), a = random_point(2), b = random_point(2);
        for (const int shift : {1, -1}) {
            given("p ", told(p), ", q ", told(q), ", a ", told(a), ", b ", told(b), ", shift ", shift);
            if (!is_right("crossing", crosses(p, q, a, b, shift),
                          plain_crossing(really_shifted(p, shift), really_shifted(q, shift), magnified(a),
                                         magnified(b))))
                return;
        }
    }
}

TEST_CASE("crosses: a segment through the corner of two edges crosses one of them")
{
    const LatticePoint left{-5, 1}, corner{0, 0}, right{5, 1};
    for (const int shift : {1, -1}) {
        given("edges from (-5, 1) to (0, 0) and on to (5, 1), a segment from (0, 3) to (0, -3), shift ",
              shift);
        const int one = crosses({0, 3}, {0, -3}, left, corner, shift),
                  other = crosses({0, 3}, {0, -3}, corner, right, shift);
        expect("sum of both", one + other, 1, 0);
        expect("product of both", one * other, 0, 0);
    }
}

TEST_CASE("polygons: two closed ones cross an even number of times, whatever coincides")
{
    const LatticePolygon square = rectangle(0, 0, 4, 4);
    for (std::int64_t x = -7; x <= 7; ++x)
        for (std::int64_t y = -7; y <= 7; ++y) {
            LatticePolygon moved = notched;
            for (LatticePoint& corner : moved)
                corner = {corner.x + x, corner.y + y};
            given("a square of 4 at (0, 0), and a square of 6 with a notch at (", x, ", ", y, ")");
            if (!is_right("remainder of their crossings, over 2", crossings(square, moved) % 2, 0))
                return;
        }
    say("two squares of 4 that share a corner region: ", crossings(square, rectangle(2, 2, 4, 4)),
        " crossings");
    say("the same square twice: ", crossings(square, square), " crossings");
}

TEST_CASE("polygons: along each edge the winding number changes by what the edge crosses")
{
    for (int trial = 0; trial < 2000; ++trial) {
        const LatticePoint p = random_point(7), q = random_point(7);
        for (const int shift : {1, -1}) {
            int sum = 0;
            for (std::size_t i = 0; i < notched.size(); ++i)
                sum += crosses(p, q, notched[i], notched[(i + 1) % notched.size()], shift);
            given("a square of 6 with a notch, p ", told(p), ", q ", told(q), ", shift ", shift);
            if (!is_right("winding number of p less that of q",
                          winding_number(p, notched, shift) - winding_number(q, notched, shift), sum))
                return;
        }
    }
}

TEST_CASE("winding number: 1 inside, 0 outside, -1 where the polygon runs the other way")
{
    const LatticePolygon square = rectangle(0, 0, 4, 4);
    const LatticePolygon backwards(square.rbegin(), square.rend());
    for (const int shift : {1, -1}) {
        given("a square of 4 at (0, 0), shift ", shift);
        expect("inside", winding_number({1, 3}, square, shift), 1, 0);
        expect("inside, with the corners in the other order", winding_number({1, 3}, backwards, shift), -1,
               0);
        for (const LatticePoint& p : {LatticePoint{-1, 2}, {5, 2}, {2, -1}, {2, 5}, {5, 5}, {-1, 4}, {-3, 0}})
            expect("outside, at " + told(p), winding_number(p, square, shift), 0, 0);
    }
}

TEST_CASE("winding number: a polygon that runs around twice winds twice")
{
    const LatticePolygon twice{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {9, 0}, {9, 9}, {0, 9}};
    const std::int64_t far = 1000000;
    given("a square of 1e6 at (0, 0)");
    expect("winding number of (500 000, 100)", winding_number({500000, 100}, rectangle(0, 0, far, far), 1), 1,
           0);
    given("a square of 9, run around twice");
    expect("winding number of (4, 4)", winding_number({4, 4}, twice, 1), 2, 0);
}

TEST_CASE("winding number: no polygon winds around nothing")
{
    given("a polygon without corners, and one with a single corner");
    expect("winding number", winding_number({0, 0}, {}, 1), 0, 0);
    expect("winding number", winding_number({0, 0}, {{0, 0}}, 1), 0, 0);
}

TEST_CASE("winding number: a point on the border is where the shift takes it")
{
    LatticePolygon large;
    for (const LatticePoint& corner : notched)
        large.push_back(magnified(corner));
    for (std::int64_t x = -1; x <= 7; ++x)
        for (std::int64_t y = -1; y <= 7; ++y)
            for (const int shift : {1, -1}) {
                given("a square of 6 with a notch, the point (", x, ", ", y, "), shift ", shift);
                const LatticePoint there = really_shifted({x, y}, shift);
                int right = 0;  // half-open edges: no tie is possible there
                for (std::size_t i = 0; i < large.size(); ++i) {
                    const LatticePoint &a = large[i], &b = large[(i + 1) % large.size()];
                    if ((a.y <= there.y) != (b.y <= there.y) &&
                        plain_side(there, a, b) == (a.y <= there.y ? 1 : -1))
                        right += a.y <= there.y ? 1 : -1;
                }
                if (!is_right("winding number", winding_number({x, y}, notched, shift), right))
                    return;
            }
    const LatticePolygon square = rectangle(0, 0, 4, 4);
    int inside = 0;
    for (const LatticePoint& corner : square)
        inside += winding_number(corner, square, 1);
    say("the four corners of a square, shifted: ", inside, " of them is inside");
}

TEST_CASE("winding number: it is exact for coordinates up to 1e9 less 1")
{
    const std::int64_t large = 999999999;
    const LatticePolygon sliver{{-large, -large}, {large, large - 1}, {large, large}};
    given("a sliver from (-1e9 + 1, -1e9 + 1) to (1e9 - 1, 1e9 - 2) and (1e9 - 1, 1e9 - 1)");
    expect("winding number of (5, 5), on its long edge, shift 1", winding_number({5, 5}, sliver, 1), 1, 0);
    expect("winding number of (5, 5), on its long edge, shift -1", winding_number({5, 5}, sliver, -1), 0, 0);
    expect("winding number of (5, 4)", winding_number({5, 4}, sliver, 1), 0, 0);
}
