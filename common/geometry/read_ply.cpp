#include "common/geometry/polygon_triangles.hpp"
#include "common/geometry/raw_number.hpp"
#include "common/geometry/read_surface.hpp"
#include "common/input/input_error.hpp"
#include "common/input/text_lines.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <sstream>

namespace enduring {
namespace {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
    std::string name;
    PlyType type;
    std::optional<PlyType> count_type;  ///< of a list's length; none for a single number
};

struct PlyElement {
    std::string name;
    long count;
    std::vector<PlyProperty> properties;
};

struct PlyHead {
    bool is_text = true;
    std::endian order = std::endian::little;
    std::vector<PlyElement> elements;
    int last_line = 0;
};

PlyType read_ply_type(TextLines& lines)
{
    const std::string_view word = lines.next_word();
    constexpr std::array<std::array<std::string_view, 2>, 8> words{{{"char", "int8"},
                                                                    {"uchar", "uint8"},
                                                                    {"short", "int16"},
                                                                    {"ushort", "uint16"},
                                                                    {"int", "int32"},
                                                                    {"uint", "uint32"},
                                                                    {"float", "float32"},
                                                                    {"double", "float64"}}};
    for (std::size_t type = 0; type < words.size(); ++type)
        if (word == words[type][0] || word == words[type][1])
            return static_cast<PlyType>(type);
    lines.fail(TextLines::quoted(word) + " is no type of number");
}

void read_ply_format(TextLines& lines, PlyHead& head)
{
    const std::string_view word = lines.next_word();
    head.is_text = word == "ascii";
    head.order = word == "binary_big_endian" ? std::endian::big : std::endian::little;
    if (!head.is_text && word != "binary_little_endian" && word != "binary_big_endian")
        lines.fail("the format " + TextLines::quoted(word) + " is not known");
}

void read_ply_property(TextLines& lines, PlyHead& head)
{
    if (head.elements.empty())
        lines.fail("a property before any element");
    std::optional<PlyType> count_type;
    if (lines.line().find(" list ") != std::string_view::npos) {
        lines.next_word();
        count_type = read_ply_type(lines);
    }
    const PlyType type = read_ply_type(lines);
    head.elements.back().properties.push_back({std::string(lines.next_word()), type, count_type});
}

PlyHead read_ply_head(TextLines& lines)
{
    PlyHead head;
    if (!lines.next() || lines.line() != "ply")
        lines.fail("not a PLY file: it does not start with ply");
    while (lines.next()) {
        const std::string_view keyword = lines.next_word();
        if (keyword == "format") {
            read_ply_format(lines, head);
        } else if (keyword == "element") {
            const std::string name(lines.next_word());
            const long count = lines.next_integer("count");
            if (count < 0)
                lines.fail("the count of " + TextLines::quoted(name) + " is " + std::to_string(count) +
                           ", below zero");
            head.elements.push_back({name, count, {}});
        } else if (keyword == "property") {
            read_ply_property(lines, head);
        } else if (keyword == "end_header") {
            head.last_line = lines.number();
            return head;
        } else if (keyword != "comment" && keyword != "obj_info") {
            lines.fail(TextLines::quoted(keyword) + " is no keyword of a PLY head");
        }
    }
    lines.fail("the file ends where end_header is missing");
}

/// The numbers behind the head, whether text or binary.
class PlyData {
public:
    PlyData(const PlyHead& head, const std::string& bytes, std::size_t first_byte, const std::string& name)
        : bytes_(bytes), name_(name), at_(first_byte), order_(head.order)
    {
        if (!head.is_text)
            return;
        std::istringstream stream(bytes);
        lines_.emplace(stream, name);
        while (lines_->number() < head.last_line)
            lines_->next();
    }

    /// Each entry of a text file has a line of its own.
    void begin_entry(const std::string& element)
    {
        if (lines_ && !lines_->next())
            lines_->fail("the file ends where a " + element + " is missing");
    }
    double number(PlyType type, const std::string& what)
    {
        const double value = lines_ ? lines_->next_finite_number(what.c_str()) : binary_number(type);
        if (!std::isfinite(value))
            fail(what + " is not finite");
        return value;
    }
    long whole(PlyType type, const std::string& what)
    {
        const double value = number(type, what);
        if (value != std::floor(value) || std::abs(value) > 1e15)
            fail(what + " is not a whole number");
        return static_cast<long>(value);
    }
    void pass_over(PlyType type)
    {
        if (lines_)
            lines_->next_word();
        else
            binary_number(type);
    }
    int line() const { return lines_ ? lines_->number() : 0; }
    [[noreturn]] void fail(const std::string& reason) const
    {
        if (lines_)
            lines_->fail(reason);
        throw InputError(name_ + ": byte " + std::to_string(at_) + ": " + reason);
    }
    [[noreturn]] void fail_at(int line, const std::string& reason) const
    {
        if (lines_)
            lines_->fail_at(line, reason);
        throw InputError(name_ + ": " + reason);
    }

private:
    template <class Number>
    double binary()
    {
        if (bytes_.size() - at_ < sizeof(Number))
            fail("the file ends where a number is missing");
        const auto value = raw_number<Number>(bytes_.data() + at_, order_);
        at_ += sizeof(Number);
        return static_cast<double>(value);
    }
    double binary_number(PlyType type)
    {
        switch (type) {
            case PlyType::int8: return binary<std::int8_t>();
            case PlyType::uint8: return binary<std::uint8_t>();
            case PlyType::int16: return binary<std::int16_t>();
            case PlyType::uint16: return binary<std::uint16_t>();
            case PlyType::int32: return binary<std::int32_t>();
            case PlyType::uint32: return binary<std::uint32_t>();
            case PlyType::float32: return binary<float>();
            default: return binary<double>();
        }
    }

    const std::string& bytes_;
    const std::string& name_;
    std::optional<TextLines> lines_;
    std::size_t at_;
    std::endian order_;
};

struct PlyContent {
    std::vector<Vec3> vertices;
    std::vector<std::vector<long>> polygons;
    std::vector<int> line_of;
};

/// One entry of an element: of a vertex its coordinates, of a face its corners, of all others nothing.
void read_ply_entry(const PlyElement& element, PlyData& data, PlyContent& content)
{
    const bool is_vertex = element.name == "vertex", is_face = element.name == "face";
    Vec3 x = Vec3::Constant(NAN);
    data.begin_entry(element.name);
    for (const PlyProperty& property : element.properties) {
        if (property.count_type) {
            const bool is_corners = is_face &&
                                    (property.name == "vertex_indices" || property.name == "vertex_index");
            const long length = data.whole(*property.count_type, "the length of a list");
            if (length < 0)
                data.fail("the length of a list is " + std::to_string(length) + ", below zero");
            if (is_corners) {
                content.polygons.emplace_back();
                content.line_of.push_back(data.line());
            }
            for (long i = 0; i < length; ++i)
                if (is_corners)
                    content.polygons.back().push_back(data.whole(property.type, "a vertex of the face"));
                else
                    data.number(property.type, "a number of a list");
        } else if (is_vertex && property.name.size() == 1 && property.name[0] >= 'x' &&
                   property.name[0] <= 'z') {
            x[property.name[0] - 'x'] = data.number(property.type, "coordinate");
        } else {
            data.pass_over(property.type);
        }
    }
    if (is_vertex && !x.allFinite())
        data.fail("a vertex has no x, y and z");
    if (is_vertex)
        content.vertices.push_back(x);
}

}  // namespace

SurfaceMesh read_ply(const std::string& bytes, const std::string& name)
{
    const std::size_t end = bytes.find('\n', std::min(bytes.find("end_header"), bytes.size()));
    const std::size_t first_byte = end == std::string::npos ? bytes.size() : end + 1;
    std::istringstream stream(bytes.substr(0, first_byte));
    TextLines lines(stream, name);
    const PlyHead head = read_ply_head(lines);
    PlyData data(head, bytes, first_byte, name);
    PlyContent content;
    for (const PlyElement& element : head.elements) {
        if (element.properties.empty())
            lines.fail("the element " + TextLines::quoted(element.name) + " has no properties");
        for (long i = 0; i < element.count; ++i)
            read_ply_entry(element, data, content);
    }
    return surface_from_polygons(std::move(content.vertices), content.polygons,
                                 [&](long polygon, const std::string& reason) {
                                     if (polygon < 0)
                                         data.fail(reason);
                                     data.fail_at(content.line_of[static_cast<std::size_t>(polygon)], reason);
                                 });
}

}  // namespace enduring
