#pragma once

#include "common/simulation/step.hpp"

#include <filesystem>

namespace enduring {

/// Writes where a run stands between two steps: the state of each body and each pair, time and step, as JSON
/// with all digits. A file that is there already is replaced when the new one is complete. The world and its
/// soft bodies forget what solves have learned, so the run goes on with the same bytes as one that is resumed
/// from the file.
/// @throws InputError  it cannot be written
void save_run(const std::filesystem::path& file, World& world, const Contacts& contacts);

/// Brings a world to where a run of the same scene has been saved.
///
/// @param world  as its scene has it at the start; unchanged where the file does not fit
/// @return       the pairs that live on
/// @throws InputError  the file cannot be read, or is of another scene; names what differs
Contacts resume_run(const std::filesystem::path& file, World& world);

}  // namespace enduring
