#include "common/input/json_document.hpp"

#include "common/input/input_error.hpp"
#include "common/input/json_value.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

namespace enduring {
namespace {

using Json = nlohmann::json;

/// Deeper nesting than any scene needs would only exhaust the parser's stack.
constexpr int deepest_nesting = 32;

/// The library keeps the last of two equal keys without a word; a scene
/// where one was meant to count is a mistake.
class KeyCheck {
public:
    explicit KeyCheck(const std::string& file) : file_(file) {}

    bool operator()(int depth, Json::parse_event_t event, Json& parsed)
    {
        if (depth > deepest_nesting)
            throw InputError(file_ + ": lists and objects are nested more than " +
                             std::to_string(deepest_nesting) + " deep");
        if (event == Json::parse_event_t::object_start)
            open_.emplace_back();
        else if (event == Json::parse_event_t::object_end)
            open_.pop_back();
        else if (event == Json::parse_event_t::key && !open_.back().insert(parsed.get<std::string>()).second)
            throw InputError(file_ + ": the key " + parsed.dump() + " stands twice in the same object");
        return true;
    }

private:
    const std::string& file_;
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
    try {
        return Json::parse(text, KeyCheck(file));
    } catch (const Json::exception& error) {
        throw InputError(file + ": not valid JSON: " + plain_message(error));
    }
}

std::string read_text_file(const std::filesystem::path& path)
{
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored))
        throw InputError(path.string() + ": no such file");
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    if (std::filesystem::is_directory(path, ignored) || !(text << stream.rdbuf()))
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
