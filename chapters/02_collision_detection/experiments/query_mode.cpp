#include "chapters/02_collision_detection/certified.hpp"
#include "chapters/02_collision_detection/experiments/experiments.hpp"
#include "chapters/02_collision_detection/query_files.hpp"
#include "common/input/input_error.hpp"
#include "common/input/number_text.hpp"

#include <CLI/CLI.hpp>

#include <iostream>

namespace enduring::chapter02 {

void QueryMode::add_options(CLI::App& app)
{
    app.add_option("--queries", file,
                   "answer the queries of a file instead (8 lines a query: num,den for x, y, z[,answer])")
        ->type_name("FILE.csv");
    app.add_option(
           "--kind", kind,
           "of those queries: vf (v f0 f1 f2) or ee (a0 a1 b0 b1), at the start, then at the end of the step")
        ->type_name("vf|ee");
}

bool QueryMode::run() const
{
    if (file.empty() && kind.empty())
        return false;
    if (file.empty())
        throw InputError("--kind says what the queries of a file are: --queries FILE.csv is missing");
    if (kind != "vf" && kind != "ee")
        throw InputError("--kind must be vf or ee" + (kind.empty() ? std::string() : ", not '" + kind + "'"));
    for (const FileQuery& query : read_queries(file)) {
        const auto time = kind == "vf" ? time_of_impact(query.vertex_face())
                                       : time_of_impact(query.edge_edge());
        std::cout << (time ? "1 " + shortest(*time) : "0") << '\n';
    }
    return true;
}

}  // namespace enduring::chapter02
