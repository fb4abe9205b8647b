#pragma once

#include <string>

namespace enduring {

/// Says a warning on stderr, each sentence once a program: an experiment reads its scene many times.
void warn_once(const std::string& sentence);

}  // namespace enduring
