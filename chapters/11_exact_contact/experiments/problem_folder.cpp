#include "chapters/11_exact_contact/experiments/problem_folder.hpp"

#include "chapters/11_exact_contact/problem_file.hpp"
#include "common/experiments/report/progress.hpp"
#include "common/input/input_error.hpp"
#include "common/input/source_directory.hpp"

#include <algorithm>
#include <new>

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
    Progress progress("", static_cast<long>(files.size()), " files read");
    for (const std::filesystem::path& file : files) {
        progress.update(static_cast<long>(result.problems.size() + result.refused.size()));
        try {
            result.problems.push_back({file.filename().string(), read_problem(file)});
        } catch (const InputError& error) {
            result.refused.push_back({file.filename().string(), error.what()});
        } catch (const std::bad_alloc&) {
            result.refused.push_back(
                {file.filename().string(), file.string() + ": needs more memory than there is"});
        }
    }
    return result;
}

}  // namespace enduring::chapter11
