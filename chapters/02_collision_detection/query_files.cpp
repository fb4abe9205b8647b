#include "chapters/02_collision_detection/query_files.hpp"

#include "common/input/input_error.hpp"
#include "common/input/input_file.hpp"
#include "common/input/text_lines.hpp"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace enduring {
namespace {

using boost::multiprecision::cpp_int;
using boost::multiprecision::cpp_rational;

std::vector<std::string_view> fields_of(std::string_view line)
{
    std::vector<std::string_view> fields;
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find(',', begin), line.size());
        fields.push_back(line.substr(begin, end - begin));
        begin = end + 1;
    }
    return fields;
}

/// The smallest double is a fraction with 324 digits. The time of reading grows with the square of their
/// number: three million take minutes.
constexpr std::size_t most_digits = 1000;

cpp_int integer(std::string_view field, const TextLines& lines)
{
    const std::size_t sign = field.substr(0, 1) == "-" || field.substr(0, 1) == "+";
    const std::string_view digits = field.substr(sign);
    if (digits.empty() || digits.find_first_not_of("0123456789") != std::string_view::npos)
        lines.fail(TextLines::quoted(field) + " is not an integer");
    if (digits.size() > most_digits)
        lines.fail("an integer of " + std::to_string(digits.size()) + " digits; at most " +
                   std::to_string(most_digits) + " are read");
    // A leading zero would mean octal to the library.
    const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
    const cpp_int value{std::string(digits.substr(first))};
    return field.substr(0, 1) == "-" ? cpp_int(-value) : value;
}

/// The quotient, which must be a double exactly.
double quotient(std::string_view numerator, std::string_view denominator, const TextLines& lines)
{
    const cpp_int den = integer(denominator, lines);
    if (den == 0)
        lines.fail("a denominator is 0");
    const cpp_rational exact(integer(numerator, lines), den);
    const double value = exact.convert_to<double>();
    if (!std::isfinite(value) || cpp_rational(value) != exact)
        lines.fail("the quotient of " + TextLines::quoted(numerator) + " and " +
                   TextLines::quoted(denominator) + " is not a double");
    return value;
}

std::optional<bool> answer(std::string_view field, const TextLines& lines)
{
    if (field != "0" && field != "1")
        lines.fail("the answer must be 0 or 1, but is " + TextLines::quoted(field));
    return field == "1";
}

/// Reads one line into a corner of the query.
void read_point(const TextLines& lines, FileQuery& query, std::size_t corner)
{
    const std::vector<std::string_view> fields = fields_of(lines.line());
    if (fields.size() != 6 && fields.size() != 7)
        lines.fail("expected num,den for x, y and z, and at most an answer: 6 or 7 fields, but there are " +
                   std::to_string(fields.size()));
    for (std::size_t axis = 0; axis < 3; ++axis)
        query.points[corner][static_cast<Eigen::Index>(axis)] = quotient(fields[2 * axis],
                                                                         fields[2 * axis + 1], lines);
    const std::optional<bool> collides = fields.size() == 7 ? answer(fields[6], lines) : std::nullopt;
    if (corner > 0 && collides != query.collides)
        lines.fail("the answer differs from that on the query's first line");
    query.collides = collides;
}

}  // namespace

VertexFaceStep FileQuery::vertex_face() const
{
    return {points[0], points[1], points[2], points[3], points[4], points[5], points[6], points[7]};
}

EdgeEdgeStep FileQuery::edge_edge() const
{
    return {points[0], points[1], points[2], points[3], points[4], points[5], points[6], points[7]};
}

std::vector<FileQuery> read_queries(std::istream& stream, const std::string& name)
{
    TextLines lines(stream, name);
    std::vector<FileQuery> queries;
    std::size_t corner = 0;
    for (; lines.next(); corner = (corner + 1) % 8) {
        if (corner == 0)
            queries.emplace_back();
        read_point(lines, queries.back(), corner);
    }
    if (corner != 0)
        lines.fail("the file ends inside a query: " + std::to_string(corner) + " of 8 points");
    return queries;
}

std::vector<FileQuery> read_queries(const std::filesystem::path& file)
{
    std::ifstream stream = open_file(file);
    return read_queries(stream, file.string());
}

}  // namespace enduring
