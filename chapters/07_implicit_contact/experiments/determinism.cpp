#include "chapters/07_implicit_contact/experiments/experiments.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/solver.hpp"

#include <algorithm>
#include <numeric>

namespace enduring::chapter07 {
namespace {

using Order = std::vector<std::size_t>;  ///< which box stands where in the scene

/// A run of boxes that stand in some order in their scene.
class Run {
public:
    Run(const std::vector<Box>& boxes, const Order& order, double dt) : order_(order)
    {
        std::vector<Box> ordered;
        for (const std::size_t box : order)
            ordered.push_back(boxes[box]);
        scene_ = scene_of(ordered, dt);
        solver_ = counting_solver(chapter07_solver, solves_)(scene_.contact);
    }

    void until(double time)
    {
        while (scene_.world.time < time - 0.5 * scene_.dt)
            advance(scene_.world, contacts_, solver_, scene_.dt);
    }

    /// Vertices of all boxes [m], in the boxes' own order.
    std::vector<Vec3> vertices() const
    {
        std::vector<Vec3> all(8 * order_.size());
        for (std::size_t i = 0; i < order_.size(); ++i)
            std::copy_n(scene_.world.bodies[i]->positions_t0().begin(), 8,
                        all.begin() + static_cast<std::ptrdiff_t>(8 * order_[i]));
        return all;
    }

private:
    Order order_;
    SolveStatistics solves_;
    Scene scene_;
    Solver solver_;
    Contacts contacts_;
};

double farthest(const std::vector<Vec3>& one, const std::vector<Vec3>& other)
{
    double distance = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
        distance = std::max(distance, (one[i] - other[i]).norm());
    return distance;
}

struct Way {
    std::string name;
    Order order;
};

std::vector<Way> ways_to_order(std::size_t count)
{
    Order order(count);
    std::iota(order.begin(), order.end(), 0);
    std::vector<Way> ways{{"the same again", order}};
    std::reverse(order.begin(), order.end());
    ways.push_back({"reversed", order});
    for (std::size_t i = 0; i < count; ++i)
        order[i] = 7 * i % count;  // the counts here are no multiples of 7
    ways.push_back({"every seventh", order});
    return ways;
}

}  // namespace

/// The same boxes in another order in their scene: how far apart do the runs go?
void determinism(const RunOptions& options, Report& report)
{
    const std::vector<double> times = options.quick ? std::vector{0.2, 1.0} : std::vector{0.2, 1.0, 6.0};
    Table table({"boxes", "order", "time_s", "farthest_apart_m"});
    double stack_apart = 0, heap_apart = 0;
    bool same = true;
    for (const bool heap : {false, true}) {
        const std::vector<Box> boxes = heap ? loose_cubes(options.quick ? 8 : 24, 2, 1) : stack_of(10);
        for (const Way& way : ways_to_order(boxes.size())) {
            Run first(boxes, ways_to_order(boxes.size()).front().order, 0.01), second(boxes, way.order, 0.01);
            for (const double time : times) {
                first.until(time);
                second.until(time);
                const double apart = farthest(first.vertices(), second.vertices());
                table.add({heap ? "heap" : "stack", way.name, time, apart});
                same = same && (way.name != "the same again" || apart == 0);
                (heap ? heap_apart : stack_apart) = std::max(heap ? heap_apart : stack_apart, apart);
            }
        }
    }
    report.table("determinism", table);
    report.page_table("determinism", table, 2);
    report.fact("determinism", "same_again", same ? "yes" : "no");
    report.fact("determinism", "stack_apart_m", stack_apart, 1);
    report.fact("determinism", "heap_apart_m", heap_apart, 1);
}

}  // namespace enduring::chapter07
