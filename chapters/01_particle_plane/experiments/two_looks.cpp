#include "chapters/01_particle_plane/experiments/experiments.hpp"
#include "chapters/01_particle_plane/plane_impulse.hpp"

namespace enduring::chapter01 {

/// Three steps of a particle, and what each method makes of them: the impulse over k dt, a depth.
void two_looks(const RunOptions&, Report& report)
{
    struct Case {
        std::string name;
        double depth_t0, depth_t1;
    };
    Table table({"step", "from_mm", "to_mm", "dpf_mm", "cpf_mm"});
    for (const Case& c :
         {Case{"enters", 0.02, -0.04}, Case{"sinks", -0.02, -0.05}, Case{"leaves", -0.04, 0.02}})
        table.add({c.name, 1000 * c.depth_t0, 1000 * c.depth_t1,
                   1000 * discrete_plane_impulse(c.depth_t1, 1, 1),
                   1000 * continuous_plane_impulse(c.depth_t0, c.depth_t1, 1, 1)});
    report.table("two_looks", table);
    report.page_table("two_looks", table);
    report.plot("chapters/01_particle_plane/plots/two_looks.gp");
}

}  // namespace enduring::chapter01
