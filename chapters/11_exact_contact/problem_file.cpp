#include "chapters/11_exact_contact/problem_file.hpp"

#include "common/input/json_document.hpp"

namespace enduring {

FrictionProblem read_problem(const std::filesystem::path& file)
{
    const std::string text = read_text_file(file);
    return text.starts_with("\x89HDF") ? read_fclib(file) : parse_siconos(text, file);
}

}  // namespace enduring
