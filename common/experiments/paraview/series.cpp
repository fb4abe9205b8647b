#include "common/experiments/paraview/series.hpp"

#include "common/experiments/report/report.hpp"
#include "common/input/input_error.hpp"
#include "common/input/pending_file.hpp"

#include <algorithm>
#include <utility>

namespace enduring {
namespace {

/// surfaces/000040.vtp: the step, so that files sort by it.
std::string moment_file(const std::string& kind, int step, const std::string& suffix)
{
    const std::string digits = std::to_string(step);
    return kind + '/' + std::string(6 - std::min<std::size_t>(6, digits.size()), '0') + digits + suffix;
}

}  // namespace

ParaviewSeries::ParaviewSeries(std::filesystem::path folder, int every)
    : folder_(std::move(folder)), every_(every)
{
    if (every < 1)
        throw InputError("a series saves every 1st, 2nd, ... step, not every " + std::to_string(every));
    require_writable_folder(folder_, "--paraview");
}

void ParaviewSeries::observe(const World& world, const Contacts& contacts, double dt)
{
    if (world.step % every_ != 0)
        return;
    save(surfaces_, moment_file("surfaces", world.step, ".vtp"), world.time,
         surfaces_vtp(world, contacts, dt));
    save(pairs_, moment_file("pairs", world.step, ".vtp"), world.time, pairs_vtp(world, contacts, dt));
    if (has_elements(world))
        save(elements_, moment_file("elements", world.step, ".vtu"), world.time, elements_vtu(world));
}

void ParaviewSeries::save(std::vector<VtkMoment>& series, const std::string& file, double time,
                          const std::string& text)
{
    write_file(folder_ / file, text);
    series.push_back({time, file});
}

void ParaviewSeries::finish() const
{
    for (const auto& [name, series] :
         {std::pair{"surfaces.pvd", &surfaces_}, {"elements.pvd", &elements_}, {"pairs.pvd", &pairs_}})
        if (!series->empty())
            write_file(folder_ / name, series_pvd(*series));
}

}  // namespace enduring
