#include "common/experiments/report/column_words.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace enduring {
namespace {

using Pair = std::pair<std::string_view, std::string_view>;

/// The units that tables use; a unit of several parts stands before the one that it ends with.
constexpr std::array<Pair, 18> units{{{"_n_per_m", "N/m"},
                                      {"_um_per_s", "µm/s"},
                                      {"_m_per_s", "m/s"},
                                      {"_percent", "%"},
                                      {"_deg", "°"},
                                      {"_kg", "kg"},
                                      {"_hz", "Hz"},
                                      {"_pa", "Pa"},
                                      {"_kn", "kN"},
                                      {"_n", "N"},
                                      {"_j", "J"},
                                      {"_mm", "mm"},
                                      {"_m", "m"},
                                      {"_um", "µm"},
                                      {"_ms", "ms"},
                                      {"_us", "µs"},
                                      {"_ns", "ns"},
                                      {"_s", "s"}}};

constexpr std::array<Pair, 10> spelled{{{"dpf", "DPF"},
                                        {"cpf", "CPF"},
                                        {"dcd", "DCD"},
                                        {"ccd", "CCD"},
                                        {"l2", "L2"},
                                        {"rho", "ρ"},
                                        {"tau", "τ"},
                                        {"omega", "ω"},
                                        {"dt", "Δt"},
                                        {"young", "Young's modulus"}}};

std::string_view spelled_out(std::string_view word)
{
    const auto* found = std::find_if(spelled.begin(), spelled.end(),
                                     [&](const Pair& p) { return p.first == word; });
    return found == spelled.end() ? word : found->second;
}

std::string in_words(std::string_view name)
{
    std::string words;
    while (true) {
        const std::size_t end = name.find('_');
        const std::string_view word = name.substr(0, end);
        if (word == "over" && !words.empty())
            words.back() = '/';
        else
            words += std::string(spelled_out(word)) + (end == std::string_view::npos ? "" : " ");
        if (end == std::string_view::npos)
            return words;
        name.remove_prefix(end + 1);
    }
}

}  // namespace

std::string column_words(const std::string& name)
{
    if (name.find_first_of(" [") != std::string::npos)
        return name;
    const std::string_view all = name;
    for (const auto& [suffix, unit] : units)
        if (all.size() > suffix.size() && all.substr(all.size() - suffix.size()) == suffix)
            return in_words(all.substr(0, all.size() - suffix.size())) + " [" + std::string(unit) + "]";
    return in_words(all);
}

}  // namespace enduring
