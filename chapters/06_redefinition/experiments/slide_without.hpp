#pragma once

#include "common/scenes/scene.hpp"

#include <array>
#include <string>

namespace enduring::chapter06 {

/// Rules of the layer that can be left out, to see what each is worth.
enum class Omission {
    none,
    edges_behind_exits,  ///< edge pairs follow redefinitions alone, as the thesis has it
    all_edge_pairs,      ///< no edge pair is ever made: vertices carry everything
    edge_handover,       ///< edge pairs come from detection alone
    hooked_are_held      ///< a hooked vertex without a regular face pushes, as in the thesis
};

inline constexpr std::array<Omission, 5> all_omissions{Omission::none, Omission::edges_behind_exits,
                                                       Omission::edge_handover, Omission::all_edge_pairs,
                                                       Omission::hooked_are_held};
std::string name_of(Omission omission);

/// Chapter 6's solver with one rule left out.
Solver solver_without(Omission omission, const ContactParameters& parameters);

}  // namespace enduring::chapter06
