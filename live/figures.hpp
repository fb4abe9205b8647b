#pragma once

#include <array>
#include <string>
#include <vector>

/// What the book's live figures ask of the chapters. Plain numbers in and out, so that a page can draw them
/// and a test can compare them; each list begins with its fixed entries, as its comment says.
namespace enduring::live {

using Numbers = std::vector<double>;

/// Chapter 1: a particle of 1 kg dropped from 0.1 m.
/// @return {spectral radius, critical step [s], Re and Im of both eigenvalues, heights [m] of every step ...}
Numbers stability(bool continuous, double dt, double stiffness, int steps);

/// Chapters 2 and 3: the height of a vertex over a face, or of an edge over an edge, through the step.
/// @param edges   two edges (a0 a1 b0 b1) in the place of a vertex and a face (v f0 f1 f2)
/// @param points  of those four: all at the start of the step, then all
///     at its end, three coordinates each [m]
/// @return {time of the first touch, -1 for none, stage that settled it (0 signs, 1 doubles, 2
///          double-doubles), the four Bernstein coefficients of the height, its roots in [0, 1] ...}
Numbers query(bool edges, const std::array<double, 24>& points);

/// Chapter 3: the impulse under a depth that is given by its Bernstein
/// coefficients, for a normal that does not turn.
/// @return {CPF's integral of -depth over the parts inside, DPF's -depth(1)
///     or 0, begin and end of each interval ...}
Numbers integral(double d0, double d1, double d2, double d3);

/// Chapter 4: a block of 1 kg set down on a slope, one pair with an anchor.
/// @param mass_splitting  mass-splitting friction in the place of the thesis' one
/// @return {whether it never let go, largest friction over normal force,
///     places along the slope [m] every 10 ms ...}
Numbers slope(bool mass_splitting, double angle_deg, double mu_s, double mu_d, double damping,
              double seconds);

/// Chapter 5: the classification circle of a wedge that looks down.
/// @return for each whole degree that the floor leans, from -180 to 179: 1 for a board that can touch, + 2
///         where the averaged normal says regular, + 4 where the span does
Numbers circle(double opening_deg);

/// Chapter 6: a cube that slides over triangles. One scene at a time.
/// @param solver  5 or 6: the chapter whose solver is used
void begin_sliding(int solver, double speed);

/// Some steps of 10 ms.
/// @return {time [s], speed along x [m/s], number of pairs, the cube's eight corners x y z, then for each
///          pair x y z and 0 unknown, 1 regular, 2 hooked, 3 held ...}
Numbers slide_on(int steps);

/// Chapter 7: a particle of 1 kg dropped from 0.1 m, in implicit steps of 10 ms.
/// @param h        k dt^2 / m
/// @param centre   of the weight over the step
/// @param by_mean  moved by the mean of both velocities in the place of the end's
/// @return {spectral radius, h up to which it is stable if moved by the end's velocity, Re and Im of both
///          eigenvalues, then for each step height [m] and energy above that at rest, over the first ...}
Numbers implicit(double h, double centre, bool by_mean, int steps);

/// Chapter 9: where a cube crosses a block of 2 m by 0.8 m by 2 m, or a bar a wall. The block and the wall
/// lie around the origin.
/// @param x, y, z    place of the cube's or the bar's middle [m]
/// @param turn_deg   about y, after a tilt by `tilt_deg` about z
/// @return lists, each begun by its count: edges of the moved body (x y z of both ends), of the other one,
///         vertices inside of the one, of the other, ways out (one of each overlap), and curves, each of
///         which is a list of points
Numbers crossing(bool bar, double x, double y, double z, double turn_deg, double tilt_deg);

/// Chapter 11: a block of 1 kg on the ground, held by a spring that remembers its force.
/// @param h              k dt^2 / m
/// @param normal, along  velocity without contact, not zero [m/s]
/// @return {exact impulse along the normal and along the surface, then for each pass impulse, velocity and
///          natural map in the same two directions, and the length of the map over that of the velocity
///          without contact ...}
Numbers passes(double h, int count, double mu, double normal, double along);

/// Chapter 13: its methods, as tables have them, in its order.
std::vector<std::string> method_titles();

/// Chapter 13: a cube of 10 kg that slides over the ground, in ten steps of 10 ms. Each method has
/// 1, 2, 4, ... iterations, substeps or steps of Newton's method.
/// @param counts  how many of these numbers
/// @return {way along the ground under chapter 11's solver [m], then for each method and each number how much
///          farther the cube is along the ground, and how much higher [m] ...}
Numbers methods(double mu, double speed, int counts);

}  // namespace enduring::live
