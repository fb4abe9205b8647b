#pragma once

#include <string>

namespace enduring {

/// Says a warning on stderr, each sentence once a program: an experiment reads its scene many times.
void warn_once(const std::string& sentence);

/// The same once a subject, whatever its sentence: a sweep meets its mistake in every run.
void warn_once(const std::string& subject, const std::string& sentence);

}  // namespace enduring
