#include "common/input/json_document.hpp"

#include "common/input/input_error.hpp"
#include "common/input/input_file.hpp"
#include "common/input/json_value.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <sstream>

namespace enduring {
namespace {

using Json = nlohmann::json;

/// Deeper nesting than any scene needs would only exhaust the parser's stack.
constexpr int deepest_nesting = 32;

/// Walks over a text and counts its lines, since the library tells the place of a syntax error only.
class LineCounter {
public:
    // NOLINTBEGIN(readability-identifier-naming): the names of std::iterator_traits
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;
    // NOLINTEND(readability-identifier-naming)

    LineCounter(const char* at, int& line) : at_(at), line_(&line) {}
    reference operator*() const { return *at_; }
    LineCounter& operator++()
    {
        *line_ += *at_ == '\n' ? 1 : 0;
        ++at_;
        return *this;
    }
    bool operator==(const LineCounter& other) const { return at_ == other.at_; }
    bool operator!=(const LineCounter& other) const { return at_ != other.at_; }

private:
    const char* at_;
    int* line_;
};

/// What fits in a line, the middle left out: a number may have a million digits.
std::string cut(const std::string& message)
{
    constexpr std::size_t longest = 200, kept = 90;
    if (message.size() <= longest)
        return message;
    return message.substr(0, kept) + " ... " + message.substr(message.size() - kept);
}

/// The library keeps the last of two equal keys without a word; a scene
/// where one was meant to count is a mistake.
class KeyCheck {
public:
    /// @param line  the one that the parser has come to
    KeyCheck(const std::string& file, const int& line) : file_(file), line_(line) {}

    bool operator()(int depth, Json::parse_event_t event, Json& parsed)
    {
        const auto fail = [&](const std::string& reason) {
            throw InputError(file_ + ":" + std::to_string(line_) + ": " + reason);
        };
        if (depth > deepest_nesting)
            fail("lists and objects are nested more than " + std::to_string(deepest_nesting) + " deep");
        if (event == Json::parse_event_t::object_start)
            open_.emplace_back();
        else if (event == Json::parse_event_t::object_end)
            open_.pop_back();
        else if (event == Json::parse_event_t::key && !open_.back().insert(parsed.get<std::string>()).second)
            fail("the key " + cut(parsed.dump()) + " stands twice in the same object");
        return true;
    }

private:
    const std::string& file_;
    const int& line_;
    std::vector<std::set<std::string>> open_;
};

/// "parse error at line 3, column 7: ..." without the library's own error number.
std::string plain_message(const Json::exception& error)
{
    const std::string text = error.what();
    const std::size_t bracket = text.find("] ");
    return bracket == std::string::npos ? text : text.substr(bracket + 2);
}

/// The entry of a list by index or by its "name"; of an object by key, which the last step may create.
Json* child(Json& parent, const std::string& step, bool may_create)
{
    if (parent.is_object()) {
        const auto found = parent.find(step);
        if (found != parent.end())
            return &*found;
        return may_create ? &parent[step] : nullptr;
    }
    if (!parent.is_array())
        return nullptr;
    for (std::size_t i = 0; i < parent.size(); ++i)
        if (step == std::to_string(i) ||
            (parent[i].is_object() && parent[i].contains("name") && parent[i]["name"] == step))
            return &parent[i];
    return nullptr;
}

Json& resolve(Json& document, const std::string& path, const std::string& file)
{
    Json* place = &document;
    std::size_t begin = 1;
    while (begin <= path.size()) {
        const std::size_t end = std::min(path.find('/', begin), path.size());
        place = child(*place, path.substr(begin, end - begin), end == path.size());
        if (!place)
            throw InputError(std::string(file)
                                 .append(": the change at ")
                                 .append(path)
                                 .append(" leads nowhere: there is no ")
                                 .append(path, 0, end));
        begin = end + 1;
    }
    return *place;
}

}  // namespace

Json parse_json(const std::string& text, const std::string& file)
{
    int line = 1;
    // the library takes a zero for the end of the text
    if (const auto zero = std::find(text.begin(), text.end(), '\0'); zero != text.end())
        throw InputError(file + ":" + std::to_string(1 + std::count(text.begin(), zero, '\n')) +
                         ": a byte that is zero; only text can be read");
    try {
        const LineCounter begin(text.data(), line), end(text.data() + text.size(), line);
        return Json::parse(begin, end, KeyCheck(file, line));
    } catch (const Json::out_of_range& error) {
        throw InputError(file + ":" + std::to_string(line) + ": " + cut(plain_message(error)));
    } catch (const Json::exception& error) {
        throw InputError(file + ": not valid JSON: " + cut(plain_message(error)));
    }
}

std::string read_text_file(const std::filesystem::path& path)
{
    std::ifstream stream = open_file(path);
    std::ostringstream text;
    if (!(text << stream.rdbuf()))
        throw InputError(path.string() + ": cannot be read, or is empty");
    return text.str();
}

void apply_patch(Json& document, const Json& patch, const std::string& file)
{
    if (!patch.is_object())
        throw InputError(file + ": a change must be a JSON object, found " + patch.dump());
    Json plain = Json::object();
    for (const auto& [key, value] : patch.items()) {
        if (!key.empty() && key.front() == '/')
            resolve(document, key, file).merge_patch(value);
        else
            plain[key] = value;
    }
    document.merge_patch(plain);
}

}  // namespace enduring
