#include "chapters/11_exact_contact/experiments/problem_folder.hpp"

#include "chapters/11_exact_contact/problem_file.hpp"
#include "common/input/input_error.hpp"
#include "common/input/source_directory.hpp"

#include <algorithm>

namespace enduring::chapter11 {

std::filesystem::path public_problems() { return source_directory() / "chapters/11_exact_contact/problems"; }

std::filesystem::path own_problems() { return public_problems() / "ours"; }

ProblemFolder read_problems(const std::filesystem::path& folder)
{
    if (!std::filesystem::is_directory(folder))
        throw InputError(folder.string() + ": is not a folder");
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".dat" || entry.path().extension() == ".hdf5")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    ProblemFolder result;
    for (const std::filesystem::path& file : files)
        try {
            result.problems.push_back({file.filename().string(), read_problem(file)});
        } catch (const InputError& error) {
            result.refused.emplace_back(error.what());
        }
    return result;
}

}  // namespace enduring::chapter11
