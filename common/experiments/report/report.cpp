#include "common/experiments/report/report.hpp"

#include "common/experiments/report/pictures_wanted.hpp"
#include "common/experiments/report/subprocess.hpp"
#include "common/experiments/report/table.hpp"
#include "common/experiments/report/warn_once.hpp"
#include "common/input/input_error.hpp"
#include "common/input/number_text.hpp"
#include "common/input/source_directory.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace enduring {
namespace {

/// A gnuplot string: between single quotes only the quote itself is special.
std::string gnuplot_quoted(const std::filesystem::path& path)
{
    std::string quoted = "'";
    for (const char c : path.string())
        quoted += c == '\'' ? "''" : std::string(1, c);
    return quoted + "'";
}

bool ends_as_svg(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    return text.find("</svg>", text.size() - std::min<std::size_t>(text.size(), 16)) != std::string::npos;
}

}  // namespace

Report::Report(std::filesystem::path folder) : folder_(std::move(folder))
{
    std::error_code failure;
    made_folder_ = std::filesystem::create_directories(folder_, failure);
    if (failure)
        throw InputError(folder_.string() + ": cannot be created (" + failure.message() + ")");
    PendingFile trial(folder_ / "writable");  // a run that could not leave its results should not start
}

Report::~Report()
{
    std::error_code ignored;
    for (const auto& [name, growing] : growing_)
        if (growing.rows == 0)
            std::filesystem::remove(unfinished(name), ignored);
    if (made_folder_)  // with files in it, it stays
        std::filesystem::remove(folder_, ignored);
}

void Report::table(const std::string& name, const Table& table)
{
    write_file(file(name + ".csv"), csv(table));
    growing_.erase(name);
    std::error_code ignored;  // there is none as a rule
    std::filesystem::remove(unfinished(name), ignored);
}

void Report::rows_so_far(const std::string& name, const Table& table)
{
    auto growing = growing_.find(name);
    if (growing == growing_.end()) {
        growing = growing_.try_emplace(name).first;
        growing->second.file = std::make_unique<RowsFile>(unfinished(name));
        growing->second.file->append(csv_head(table));
    }
    auto& [out, rows] = growing->second;
    out->append(csv_rows(table, rows));
    rows = table.rows().size();
}

std::filesystem::path Report::unfinished(const std::string& table) const
{
    return folder_ / (table + ".unfinished.csv");
}

void Report::page_table(const std::string& name, const Table& table, int digits)
{
    write_file(file(name + ".md"), markdown(table, digits));
}

void Report::fact(const std::string& experiment, const std::string& name, double value, int digits)
{
    write_facts(experiment, {name, value, readable(value, digits)});
}

void Report::fact(const std::string& experiment, const std::string& name, const std::string& text)
{
    write_facts(experiment, {name, std::string(), text});
}

void Report::write_facts(const std::string& experiment, std::vector<Cell> fact)
{
    auto& facts = facts_[experiment];
    const auto same = std::find_if(facts.begin(), facts.end(),
                                   [&](const auto& told) { return told[0] == fact[0]; });
    if (same == facts.end())
        facts.push_back(std::move(fact));
    else
        *same = std::move(fact);

    Table all({"name", "value", "text"});
    for (const auto& told : facts)
        all.add(told);
    table("facts_" + experiment, all);
}

void Report::plot(const std::filesystem::path& script_in_sources, const std::string& name)
{
    const std::filesystem::path sources = source_directory(), script = sources / script_in_sources;
    if (!std::filesystem::is_regular_file(script))
        throw InputError(script.string() + ": no such gnuplot script");
    const std::filesystem::path place = file((name.empty() ? script.stem().string() : name) + ".svg");
    if (!pictures_wanted()) {
        std::filesystem::remove(place);
        return;
    }
    if (!is_installed("gnuplot")) {
        warn_once("plots are left out: gnuplot is not installed. On Debian: apt-get install gnuplot-nox");
        std::filesystem::remove(place);
        return;
    }
    PendingFile picture(place);
    const std::string variables = "folder=" + gnuplot_quoted(folder_) + "; style=" +
                                  gnuplot_quoted(sources / "common/experiments/report/plot_style.gp") +
                                  "; output=" + gnuplot_quoted(picture.neighbour());
    Subprocess gnuplot({"gnuplot", "-e", variables, script.string()}, "gnuplot-nox");
    gnuplot.finish();
    if (std::filesystem::file_size(picture.neighbour()) == 0)
        throw std::runtime_error(script.string() + ": gnuplot drew nothing");
    if (!ends_as_svg(picture.neighbour()))  // gnuplot does not tell of a full disk
        throw InputError(place.string() + ": cannot be written to its end (is the disk full?)");
    picture.publish();
}

std::filesystem::path Report::file(const std::string& name)
{
    const std::filesystem::path place = folder_ / name;
    if (std::find(written_.begin(), written_.end(), place) == written_.end())
        written_.push_back(place);
    return place;
}

}  // namespace enduring
