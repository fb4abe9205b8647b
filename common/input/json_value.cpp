#include "common/input/json_value.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <sstream>

namespace enduring {
namespace {

std::string shown(double x)
{
    std::ostringstream text;
    text << x;
    return text.str();
}

/// As much of a text as fits in a message.
std::string beginning(const std::string& text)
{
    constexpr std::size_t longest = 60;
    return text.size() > longest ? text.substr(0, longest) + "..." : text;
}

/// What stands in the file, cut to what fits in a message.
std::string excerpt(const nlohmann::json& value)
{
    return beginning(value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace));
}

std::string with_article(const nlohmann::json& value)
{
    if (value.is_object() || value.is_array())
        return std::string(value.is_object() ? "the object " : "the list ") + excerpt(value);
    return excerpt(value);
}

/// Number of single-character changes between two words (Levenshtein).
std::size_t word_distance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

template <class Words>
std::string joined(const Words& words)
{
    std::string text;
    for (const std::string_view word : words)
        text += (text.empty() ? "\"" : ", \"") + std::string(word) + "\"";
    return text;
}

/// " (did you mean "density"?)" when one of the words is close, else the list of them.
std::string advice(const std::string& found, std::initializer_list<std::string_view> allowed)
{
    constexpr std::size_t longest_compared = 40;
    const auto nearest = std::min_element(allowed.begin(), allowed.end(),
                                          [&](std::string_view a, std::string_view b) {
                                              return word_distance(a, found.substr(0, longest_compared)) <
                                                     word_distance(b, found.substr(0, longest_compared));
                                          });
    if (nearest != allowed.end() &&
        word_distance(*nearest, found.substr(0, longest_compared)) <= 1 + nearest->size() / 4)
        return "did you mean \"" + std::string(*nearest) + "\"?";
    return "allowed here: " + joined(allowed);
}

/// JSON pointers write '~' and '/' inside a key as "~0" and "~1".
std::string escaped(const std::string& key)
{
    std::string text;
    for (const char c : key)
        text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return text;
}

}  // namespace

std::string NumberRange::text() const
{
    std::string text = "a number";
    if (std::isfinite(low))
        text += (low_allowed ? " from " : " above ") + shown(low);
    if (std::isfinite(high))
        text += (std::isfinite(low) ? std::string(low_allowed && high_allowed ? " to "
                                                  : high_allowed              ? " up to "
                                                                              : " and below ")
                                    : std::string(high_allowed ? " up to " : " below ")) +
                shown(high);
    return unit.empty() ? text : text + " [" + unit + "]";
}

JsonValue::JsonValue(const nlohmann::json& value, std::string file, std::string path)
    : value_(&value), file_(std::move(file)), path_(std::move(path))
{}

void JsonValue::complain(const std::string& message) const
{
    throw InputError(file_ + ": " + (path_.empty() ? "/" : path_) + ": " + message);
}

void JsonValue::pass_on(const InputError& error) const
{
    if (std::string(error.what()).rfind(file_ + ": /", 0) == 0)
        throw error;
    complain(error.what());
}

void JsonValue::fail(const std::string& expected) const
{
    complain("expected " + expected + ", found " + with_article(*value_));
}

void JsonValue::require_keys(std::initializer_list<std::string_view> allowed) const
{
    if (!value_->is_object())
        fail("an object with the keys " + joined(allowed));
    for (const auto& [key, value] : value_->items())
        if (std::find(allowed.begin(), allowed.end(), key) == allowed.end())
            JsonValue(value, file_, path_ + "/" + escaped(beginning(key)))
                .complain("unknown key; " + advice(key, allowed));
}

std::optional<JsonValue> JsonValue::find(const std::string& key) const
{
    if (!value_->is_object())
        fail("an object");
    const auto found = value_->find(key);
    if (found == value_->end())
        return std::nullopt;
    return JsonValue(*found, file_, path_ + "/" + escaped(key));
}

JsonValue JsonValue::at(const std::string& key) const
{
    const std::optional<JsonValue> found = find(key);
    if (!found)
        complain("the key \"" + key + "\" is missing");
    return *found;
}

std::vector<std::pair<std::string, JsonValue>> JsonValue::members() const
{
    if (!value_->is_object())
        fail("an object");
    std::vector<std::pair<std::string, JsonValue>> all;
    for (const auto& [key, value] : value_->items())
        all.emplace_back(key, JsonValue(value, file_, path_ + "/" + escaped(key)));
    return all;
}

std::vector<JsonValue> JsonValue::items(std::size_t at_least, std::size_t at_most) const
{
    if (!value_->is_array() || value_->size() < at_least || value_->size() > at_most)
        fail(at_least == at_most
                 ? "a list of " + std::to_string(at_least)
                 : "a list of " + std::to_string(at_least) + " to " + std::to_string(at_most) + " entries");
    std::vector<JsonValue> all;
    for (std::size_t i = 0; i < value_->size(); ++i)
        all.emplace_back((*value_)[i], file_, path_ + "/" + std::to_string(i));
    return all;
}

double JsonValue::number(const NumberRange& range) const
{
    if (!value_->is_number() || !range.contains(value_->get<double>()))
        fail(range.text());
    return value_->get<double>();
}

double JsonValue::angle(NumberRange degrees) const
{
    degrees.unit = "degrees";
    return number(degrees) * std::numbers::pi / 180;
}

int JsonValue::integer(int low, int high) const
{
    const bool whole = value_->is_number_integer() &&
                       (!value_->is_number_unsigned() || value_->get<std::uint64_t>() <= INT64_MAX);
    if (!whole || value_->get<std::int64_t>() < low || value_->get<std::int64_t>() > high)
        fail("a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    return static_cast<int>(value_->get<std::int64_t>());
}

bool JsonValue::flag() const
{
    if (!value_->is_boolean())
        fail("true or false");
    return value_->get<bool>();
}

std::string JsonValue::text() const
{
    if (!value_->is_string() || value_->get_ref<const std::string&>().empty())
        fail("a text in quotes that is not empty");
    return value_->get<std::string>();
}

std::size_t JsonValue::choice(std::span<const std::string_view> words) const
{
    if (value_->is_string()) {
        const auto found = std::find(words.begin(), words.end(), value_->get_ref<const std::string&>());
        if (found != words.end())
            return static_cast<std::size_t>(found - words.begin());
    }
    fail("one of " + joined(words));
}

Vec3 JsonValue::vector(const NumberRange& each) const
{
    if (!value_->is_array() || value_->size() != 3)
        fail("a list of three numbers");
    Vec3 v;
    for (int i = 0; i < 3; ++i)
        v[i] = JsonValue((*value_)[i], file_, path_ + "/" + std::to_string(i)).number(each);
    return v;
}

Vec3 JsonValue::direction() const
{
    const Vec3 v = vector({-1e6, 1e6});
    if (!(v.norm() > 1e-9))
        fail("three numbers that are not all zero");
    return v.normalized();
}

double JsonValue::number_or(const std::string& key, const NumberRange& range, double otherwise) const
{
    const std::optional<JsonValue> found = find(key);
    return found ? found->number(range) : otherwise;
}

Vec3 JsonValue::vector_or(const std::string& key, const NumberRange& each, const Vec3& otherwise) const
{
    const std::optional<JsonValue> found = find(key);
    return found ? found->vector(each) : otherwise;
}

std::string JsonValue::text_or(const std::string& key, const std::string& otherwise) const
{
    const std::optional<JsonValue> found = find(key);
    return found ? found->text() : otherwise;
}

bool JsonValue::flag_or(const std::string& key, bool otherwise) const
{
    const std::optional<JsonValue> found = find(key);
    return found ? found->flag() : otherwise;
}

}  // namespace enduring
