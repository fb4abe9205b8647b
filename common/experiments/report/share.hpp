#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace enduring {

/// Which of an experiment's independent runs a program makes, and where it keeps what they found (sweep.hpp).
struct Share {
    std::filesystem::path folder;  ///< empty: nothing is kept
    std::size_t which = 1, of = 1;

    bool is_part() const { return of > 1; }
    /// @param i  of a run, from 0
    bool holds(std::size_t i) const { return i % of == which - 1; }
    std::size_t count_of(std::size_t runs) const { return (runs + of - which) / of; }
};

/// @param part  "K/N" with 1 <= K <= N; empty for all
/// @throws InputError  it is anything else
Share read_share(const std::string& folder, const std::string& part);

}  // namespace enduring
