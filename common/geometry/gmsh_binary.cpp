#include "common/geometry/gmsh_binary.hpp"

#include "common/geometry/raw_number.hpp"
#include "common/input/input_error.hpp"
#include "common/input/number_text.hpp"

#include <charconv>
#include <cstdint>
#include <sstream>

namespace enduring {
namespace {

/// Of Gmsh's element types, from 0 on; no element has the type 0.
constexpr std::array<int, 22> nodes_of_type{0,  2,  3,  4,  4, 8, 6,  5,  3,  6, 9,
                                            10, 27, 18, 14, 1, 8, 20, 15, 13, 9, 10};

/// Takes numbers from a binary file and writes each as a word of text.
class GmshCopy {
public:
    GmshCopy(const std::string& bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

    [[noreturn]] void fail(const std::string& reason) const
    {
        throw InputError(name_ + ", byte " + std::to_string(at_) + ": " + reason);
    }
    bool at_end() const { return at_ == bytes_.size(); }
    std::string take_line()
    {
        const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size()), begin = at_;
        at_ = std::min(end + 1, bytes_.size());
        return bytes_.substr(begin, end - begin);
    }
    void pass_over_to(const std::string& line)
    {
        const std::size_t found = bytes_.find(line, at_);
        if (found == std::string::npos)
            fail("the file ends where " + line + " is missing");
        at_ = found;
        take_line();
    }
    /// It is 1 in the order of bytes that the file has.
    void find_order()
    {
        const std::size_t begin = at_;
        if (take<std::int32_t>() == 1)
            return;
        order_ = std::endian::big;
        at_ = begin;
        if (take<std::int32_t>() != 1)
            fail("the number 1 was expected, which tells the order of bytes");
    }
    template <class Number>
    Number take()
    {
        if (bytes_.size() - at_ < sizeof(Number))
            fail("the file ends where a number is missing");
        const auto number = raw_number<Number>(bytes_.data() + at_, order_);
        at_ += sizeof(Number);
        return number;
    }
    std::int64_t copy_int() { return write(take<std::int32_t>()); }
    std::uint64_t copy_size() { return write(take<std::uint64_t>()); }
    void copy_real() { text << shortest(take<double>()) << ' '; }

    std::ostringstream text{};

private:
    template <class Number>
    Number write(Number number)
    {
        text << number << ' ';
        return number;
    }

    const std::string& bytes_;
    std::string name_;
    std::size_t at_ = 0;
    std::endian order_ = std::endian::little;
};

int node_count(const GmshCopy& copy, std::int64_t type)
{
    if (type < 1 || type >= static_cast<std::int64_t>(nodes_of_type.size()))
        copy.fail("an element of type " + std::to_string(type) +
                  "; of solid elements only tetrahedra (4 and 11) can be read");
    return nodes_of_type[static_cast<std::size_t>(type)];
}

void copy_coordinates(GmshCopy& copy)
{
    for (int i = 0; i < 3; ++i)
        copy.copy_real();
    copy.text << '\n';
}

/// Version 4.1: counts of blocks and entries, smallest and largest number; then blocks, each with the
/// dimension and number of its entity, one number of its own and a count.
/// @param copy_entries  is given the dimension, that number and that count
template <class CopyEntries>
void copy_blocks(GmshCopy& copy, const CopyEntries& copy_entries)
{
    const std::uint64_t blocks = copy.copy_size();
    for (int i = 0; i < 3; ++i)
        copy.copy_size();
    copy.text << '\n';
    for (std::uint64_t block = 0; block < blocks; ++block) {
        const std::int64_t dimension = copy.copy_int();
        copy.copy_int();
        const std::int64_t own = copy.copy_int();
        const std::uint64_t count = copy.copy_size();
        copy.text << '\n';
        copy_entries(dimension, own, count);
    }
}

void copy_nodes_in_blocks(GmshCopy& copy)
{
    copy_blocks(copy, [&](std::int64_t dimension, std::int64_t parametric, std::uint64_t count) {
        for (std::uint64_t i = 0; i < count; ++i) {
            copy.copy_size();
            copy.text << '\n';
        }
        for (std::uint64_t i = 0; i < count; ++i) {
            copy_coordinates(copy);
            for (std::int64_t p = 0; parametric != 0 && p < dimension; ++p)
                copy.take<double>();
        }
    });
}

void copy_elements_in_blocks(GmshCopy& copy)
{
    copy_blocks(copy, [&](std::int64_t, std::int64_t type, std::uint64_t count) {
        const int numbers = 1 + node_count(copy, type);
        for (std::uint64_t i = 0; i < count; ++i) {
            for (int n = 0; n < numbers; ++n)
                copy.copy_size();
            copy.text << '\n';
        }
    });
}

/// Version 2.2 has the count of a section as text.
std::int64_t copy_count(GmshCopy& copy)
{
    const std::string line = copy.take_line();
    std::int64_t count = 0;
    std::from_chars(line.data(), line.data() + line.size(), count);
    copy.text << count << '\n';
    return count;
}

void copy_nodes(GmshCopy& copy)
{
    for (std::int64_t left = copy_count(copy); left > 0; --left) {
        copy.copy_int();
        copy_coordinates(copy);
    }
}

/// Elements of one type, with equally many tags, follow each other.
void copy_elements(GmshCopy& copy)
{
    for (std::int64_t left = copy_count(copy); left > 0;) {
        const std::int64_t type = copy.take<std::int32_t>(), count = copy.take<std::int32_t>(),
                           tags = copy.take<std::int32_t>();
        if (count < 1 || tags < 0)
            copy.fail("a block of " + std::to_string(count) + " elements with " + std::to_string(tags) +
                      " tags");
        const std::int64_t numbers = tags + node_count(copy, type);
        for (std::int64_t i = 0; i < count; ++i, --left) {
            copy.copy_int();
            copy.text << type << ' ' << tags << ' ';
            for (std::int64_t n = 0; n < numbers; ++n)
                copy.copy_int();
            copy.text << '\n';
        }
    }
}

/// One line for each entity: its number, its place, and the groups that it belongs to; what bounds it is left
/// out.
void copy_entities(GmshCopy& copy)
{
    std::array<std::uint64_t, 4> counts{};
    for (std::uint64_t& count : counts)
        count = copy.copy_size();
    copy.text << '\n';
    for (std::size_t dimension = 0; dimension < counts.size(); ++dimension)
        for (std::uint64_t i = 0; i < counts[dimension]; ++i) {
            copy.copy_int();
            for (int n = dimension == 0 ? 3 : 6; n > 0; --n)
                copy.copy_real();
            for (std::uint64_t groups = copy.copy_size(); groups > 0; --groups)
                copy.copy_int();
            for (std::uint64_t bounds = dimension == 0 ? 0 : copy.take<std::uint64_t>(); bounds > 0; --bounds)
                copy.take<std::int32_t>();
            copy.text << '\n';
        }
}

/// A section that is text in a binary file, too.
void copy_lines(GmshCopy& copy, const std::string& end)
{
    std::string line = copy.take_line();
    for (; line != end && !copy.at_end(); line = copy.take_line())
        copy.text << line << '\n';
    if (line != end)
        copy.fail("the file ends where " + end + " is missing");
}

}  // namespace

bool is_binary_gmsh(const std::string& bytes)
{
    std::istringstream head(bytes.substr(0, 100));
    std::string section, version, type;
    head >> section >> version >> type;
    return section == "$MeshFormat" && type == "1";
}

std::string gmsh_as_text(const std::string& bytes, const std::string& name)
{
    GmshCopy copy(bytes, name);
    copy.take_line();
    const std::string format = copy.take_line();
    const bool in_blocks = format.rfind("4.1 1 8", 0) == 0;
    if (!in_blocks && format.rfind("2.2 1 8", 0) != 0)
        copy.fail("this binary Gmsh format is not supported; save the mesh as version 4.1 or 2.2");
    copy.find_order();
    copy.pass_over_to("$EndMeshFormat");
    copy.text << "$MeshFormat\n" << format.substr(0, 3) << " 0 8\n$EndMeshFormat\n";
    while (!copy.at_end()) {
        const std::string section = copy.take_line();
        if (section.empty() || section[0] != '$')
            copy.fail("a section such as $Nodes expected");
        const std::string end = "$End" + section.substr(1);
        if (section == "$PhysicalNames") {
            copy.text << section << '\n';
            copy_lines(copy, end);
            copy.text << end << '\n';
            continue;
        }
        const bool is_entities = section == "$Entities" && in_blocks;
        if (is_entities || section == "$Nodes" || section == "$Elements") {
            copy.text << section << '\n';
            if (is_entities)
                copy_entities(copy);
            else if (section == "$Nodes")
                in_blocks ? copy_nodes_in_blocks(copy) : copy_nodes(copy);
            else
                in_blocks ? copy_elements_in_blocks(copy) : copy_elements(copy);
            copy.text << end << '\n';
        }
        copy.pass_over_to(end);
    }
    return copy.text.str();
}

}  // namespace enduring
