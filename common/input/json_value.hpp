#pragma once

#include "common/geometry/vector.hpp"
#include "common/input/input_error.hpp"

#include <nlohmann/json_fwd.hpp>

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace enduring {

/// The numbers a value may take, with the unit for the message: "a
/// number above 0 and at most 1e+06 [kg/m^3]".
struct NumberRange {
    double low, high;
    bool low_allowed = true, high_allowed = true;
    std::string unit{};

    bool contains(double x) const
    {
        return (low_allowed ? x >= low : x > low) && (high_allowed ? x <= high : x < high);
    }
    std::string text() const;
};

/// One value of a JSON document that knows where it stands, so that every complaint can say so:
/// "ball.json: /bodies/0/density: expected a number above 0 and at most 1e+06 [kg/m^3], found -3".
class JsonValue {
public:
    /// @param value  stays alive as long as this view of it
    /// @param file   named in every message
    /// @param path   JSON pointer of the value, empty for the whole document
    JsonValue(const nlohmann::json& value, std::string file, std::string path = "");

    const std::string& path() const { return path_; }
    const std::string& file() const { return file_; }

    /// An object with none but these keys; a complaint names the nearest of them.
    void require_keys(std::initializer_list<std::string_view> allowed) const;
    JsonValue at(const std::string& key) const;                   ///< complains when it is missing
    std::optional<JsonValue> find(const std::string& key) const;  ///< empty when it is missing
    std::vector<std::pair<std::string, JsonValue>> members() const;

    std::vector<JsonValue> items(std::size_t at_least, std::size_t at_most) const;

    double number(const NumberRange& range) const;
    double angle(NumberRange degrees) const;  ///< stands in degrees, returned in radians
    int integer(int low, int high) const;
    bool flag() const;
    std::string text() const;
    /// Index of the word that stands here among those allowed.
    std::size_t choice(std::span<const std::string_view> words) const;
    std::size_t choice(std::initializer_list<std::string_view> words) const
    {
        return choice(std::span(words.begin(), words.size()));
    }
    Vec3 vector(const NumberRange& each) const;
    Vec3 direction() const;  ///< three numbers, not all zero; returned with unit length

    /// With a value for a missing key.
    double number_or(const std::string& key, const NumberRange& range, double otherwise) const;
    Vec3 vector_or(const std::string& key, const NumberRange& each, const Vec3& otherwise) const;
    std::string text_or(const std::string& key, const std::string& otherwise) const;
    bool flag_or(const std::string& key, bool otherwise) const;

    /// @throws InputError  "FILE: PATH: expected EXPECTED, found VALUE"
    [[noreturn]] void fail(const std::string& expected) const;
    /// @throws InputError  "FILE: PATH: MESSAGE"
    [[noreturn]] void complain(const std::string& message) const;
    /// For a mistake found elsewhere, as in a mesh file: puts file and
    /// path before it, unless it has them already.
    [[noreturn]] void pass_on(const InputError& error) const;

private:
    const nlohmann::json* value_;  ///< never null; a pointer so that values can be assigned
    std::string file_, path_;
};

}  // namespace enduring
