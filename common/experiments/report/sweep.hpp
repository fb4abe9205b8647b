#pragma once

#include "common/experiments/report/chapter_program.hpp"
#include "common/experiments/report/progress.hpp"
#include "common/input/input_error.hpp"

#include <fstream>
#include <optional>
#include <type_traits>

namespace enduring {

/// What each of many independent runs found, in their order, whoever made them: the program itself, or
/// several beside each other, each with another --part of the runs and with one --parts folder. A run of
/// which that folder holds the outcome is not made again. The reader is told how many are done.
///
///     const auto found = sweep<Outcome>(options, "thin", shots.size(), [&](std::size_t i) { return
///     shoot(shots[i]); }); if (!found)
///         return;  // a part, which leaves no table
///
/// @param name  of the sweep, which is the only one of this name in its experiment
/// @param run   what run i finds: plain numbers, the same ones whichever runs come before
/// @return      all outcomes; none when only a part of the runs was asked for
/// @throws InputError  an outcome cannot be kept, or a kept one is of another size
template <class Outcome, class Run>
std::optional<std::vector<Outcome>> sweep(const RunOptions& options, const std::string& name,
                                          std::size_t count, const Run& run)
{
    static_assert(std::is_trivially_copyable_v<Outcome>, "an outcome is kept as its bytes");
    const Share& share = options.share;
    std::vector<Outcome> all;
    Progress progress("", static_cast<long>(share.count_of(count)), " runs of " + name);
    for (std::size_t i = 0; i < count; ++i) {
        if (!share.holds(i))
            continue;
        const std::filesystem::path place = share.folder / (name + "." + std::to_string(i));
        Outcome outcome;
        if (share.folder.empty()) {
            outcome = run(i);
        } else if (std::ifstream kept(place, std::ios::binary); kept) {
            kept.read(reinterpret_cast<char*>(&outcome), sizeof outcome);
            if (!kept || kept.peek() != std::ifstream::traits_type::eof())
                throw InputError(place.string() + ": was kept by another program; remove it");
        } else {
            outcome = run(i);
            write_file(place, std::string(reinterpret_cast<const char*>(&outcome), sizeof outcome));
        }
        all.push_back(outcome);
        progress.update(static_cast<long>(all.size()));
    }
    return share.is_part() ? std::nullopt : std::optional(std::move(all));
}

}  // namespace enduring
