// Chapter 1 in one file: a particle falls onto the ground y = 0, which pushes it back as a spring would.
//
//     g++ -O2 chapter01.cpp && ./a.out          writes drop.svg: open it in a browser
//
// Which depth does the spring of a step use? The discrete penalty force takes that at the end of the
// predicted step, the continuous one all depths on the way there. Look at what a bounce keeps. Then change k.
#include <algorithm>
#include <cstdio>
#include <vector>

const double m = 1;            // mass [kg]
const double g = 9.81;         // gravity [m/s^2]
const double k = 2000;         // stiffness of the ground [N/m]; h = k dt^2 / m decides what is stable
const double dt = 0.01;        // length of a step [s]
const double duration = 5;     // [s]
const double drop_height = 1;  // [m]

// Impulse [N s] of a spring that uses the depth at the end of the step.
double discrete_impulse(double, double y_t1) { return -k * dt * std::min(0.0, y_t1); }

// Impulse [N s] of a spring along the straight path from y_t0 to y_t1: -k dt times the integral of min(0, y).
double continuous_impulse(double y_t0, double y_t1)
{
    const double low = std::min(y_t0, y_t1), high = std::max(y_t0, y_t1);
    if (low >= 0)
        return 0;
    if (high <= 0)
        return -k * dt * (low + high) / 2;    // below all the time
    const double below = low / (low - high);  // the part of the step that lies below
    return -k * dt * below * low / 2;
}

using Law = double (*)(double y_t0, double y_t1);

// Heights [m] of the particle after each step: predict without contact, push for the predicted path, move.
std::vector<double> fall(Law impulse)
{
    std::vector<double> heights;
    double y = drop_height, v = 0;
    for (double t = 0; t < duration; t += dt) {
        v -= dt * g;                      // predict
        v += impulse(y, y + dt * v) / m;  // respond
        y += dt * v;                      // move
        heights.push_back(y);
    }
    return heights;
}

// The greatest height of each flight over that of the one before: what a bounce keeps of its energy.
void tell(const char* name, const std::vector<double>& heights)
{
    std::printf("%s: a bounce keeps", name);
    double before = 0, highest = drop_height;
    for (std::size_t i = 1, landings = 0; i < heights.size() && landings < 4; ++i) {
        if (heights[i - 1] > 0 && heights[i] <= 0) {  // it lands
            if (landings++ > 0)
                std::printf(" %.0f %%", 100 * highest / before);
            before = highest;
            highest = 0;
        }
        highest = std::max(highest, heights[i]);
    }
    std::printf("\n");
}

const double wide = 800, high = 300, ground = 250, scale = 200;  // of the picture [px], and [px/m]

void draw(std::FILE* svg, const char* colour, const std::vector<double>& heights)
{
    std::fprintf(svg, "<polyline fill='none' stroke='%s' stroke-width='2' points='", colour);
    for (std::size_t i = 0; i < heights.size(); ++i)
        std::fprintf(svg, "%.1f,%.1f ", wide * double(i) * dt / duration, ground - scale * heights[i]);
    std::fprintf(svg, "'/>\n");
}

int main()
{
    const std::vector<double> discrete = fall(discrete_impulse), continuous = fall(continuous_impulse);
    tell("discrete  ", discrete);
    tell("continuous", continuous);

    std::FILE* svg = std::fopen("drop.svg", "w");
    if (!svg)
        return std::perror("drop.svg"), 1;
    std::fprintf(
        svg,
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 %g %g'><rect width='100%%' height='100%%' fill='white'/>\n",
        wide, high);
    std::fprintf(svg, "<path d='M0 %g H%g' stroke='#888'/><g font-family='sans-serif' font-size='14'>\n",
                 ground, wide);
    std::fprintf(
        svg,
        "<text x='10' y='%g' fill='#c0392b'>discrete</text><text x='90' y='%g' fill='#2768a3'>continuous</text></g>\n",
        high - 15, high - 15);
    draw(svg, "#c0392b", discrete);
    draw(svg, "#2768a3", continuous);
    std::fprintf(svg, "</svg>\n");
    return std::fclose(svg) == 0 ? 0 : 1;
}
