#include "chapters/11_exact_contact/experiments/siconos_scores.hpp"

#include "common/experiments/report/report.hpp"
#include "common/input/number_text.hpp"
#include "common/input/source_directory.hpp"

#include <sys/wait.h>
#include <unistd.h>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace enduring::chapter11 {
namespace {

namespace fs = std::filesystem;

/// A folder that goes with its files.
class ExchangeFolder {
public:
    ExchangeFolder() : path_(fs::temp_directory_path() / ("enduring_siconos_" + std::to_string(getpid())))
    {
        fs::create_directories(path_);
    }
    ~ExchangeFolder()
    {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    ExchangeFolder(const ExchangeFolder&) = delete;
    ExchangeFolder& operator=(const ExchangeFolder&) = delete;
    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

std::string file_of(std::size_t problem) { return std::to_string(problem) + ".dat"; }

/// "SOLVER FILE SECONDS STEPS r...", behind the word "answer".
/// @throws std::runtime_error  the line is cut
SiconosAnswer answer_from(std::istream& line, const std::vector<NamedProblem>& problems)
{
    SiconosAnswer answer;
    std::string file;
    long steps = 0;
    line >> answer.solver >> file >> answer.seconds >> steps;
    answer.problem = std::stoul(file);
    answer.impulses.resize(3 * problems[answer.problem].problem.contacts());
    for (double& x : answer.impulses)
        line >> x;
    if (!line)
        throw std::runtime_error("Siconos' solvers: an answer to " + problems[answer.problem].name +
                                 " is cut");
    return answer;
}

/// Whether the script's solvers were there.
/// @param status  with which it ended, as the system tells it
/// @throws std::runtime_error  they were, and something else went wrong
bool were_there(int status)
{
    constexpr int not_installed = 3, no_python = 127;
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    if (code == not_installed || code == no_python)
        return false;
    if (code != 0)
        throw std::runtime_error("Siconos' solvers ended with exit status " + std::to_string(code) +
                                 ", and without all answers");
    return true;
}

}  // namespace

std::string blocks_text(const FrictionProblem& problem)
{
    using Blocks = std::map<int, Eigen::Matrix3d>;  // of a row, by their column
    const int contacts = problem.contacts();
    std::vector<Blocks> rows(static_cast<std::size_t>(contacts));
    std::size_t count = 0;
    for (int column = 0; column < problem.response.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(problem.response, column); entry; ++entry) {
            auto [block, is_new] = rows[static_cast<std::size_t>(entry.row() / 3)].try_emplace(
                column / 3, Eigen::Matrix3d::Zero());
            count += is_new;
            block->second(entry.row() % 3, column % 3) = entry.value();
        }
    std::ostringstream out, starts, columns, numbers;
    out << "3\n"
        << contacts << "\n1\n"
        << 3 * contacts << ' ' << 3 * contacts << '\n'
        << count << '\n'
        << contacts << ' ' << contacts << '\n';
    for (int i = 0; i < 2 * contacts; ++i)  // where rows of blocks end, and columns
        out << 3 * (i % contacts + 1) << ' ';
    out << '\n';
    std::size_t place = 0;
    for (const Blocks& row : rows) {
        starts << place << ' ';
        for (const auto& [column, block] : row) {
            columns << column << ' ';
            numbers << place++ << '\n';
            for (const double x : block.reshaped())
                numbers << shortest(x) << '\n';
        }
    }
    out << contacts + 1 << ' ' << count << '\n'
        << starts.str() << place << '\n'
        << columns.str() << '\n'
        << numbers.str();
    for (const double x : problem.free_velocity)
        out << shortest(x) << '\n';
    for (const double x : problem.mu)
        out << shortest(x) << '\n';
    return out.str();
}

std::vector<SiconosAnswer> solve_by_siconos(const std::vector<NamedProblem>& problems, double tolerance)
{
    const ExchangeFolder folder;
    for (std::size_t i = 0; i < problems.size(); ++i)
        if (problems[i].problem.dimension == 3)
            write_file(folder.path() / file_of(i), blocks_text(problems[i].problem));
    const fs::path script = source_directory() / "chapters/11_exact_contact/experiments/siconos_solvers.py",
                   output = folder.path() / "answers";
    const std::string command = "/usr/bin/python3 '" + script.string() + "' '" + folder.path().string() +
                                "' " + shortest(tolerance) + " > '" + output.string() + "' 2> /dev/null";
    if (!were_there(std::system(command.c_str())))
        return {};
    std::vector<SiconosAnswer> answers;
    std::ifstream file(output);
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string first;
        if (words >> first && first == "answer")
            answers.push_back(answer_from(words, problems));
    }
    return answers;
}

}  // namespace enduring::chapter11
