#include "common/experiments/report/warn_once.hpp"

#include <iostream>
#include <set>

namespace enduring {

void warn_once(const std::string& sentence) { warn_once(sentence, sentence); }

void warn_once(const std::string& subject, const std::string& sentence)
{
    static std::set<std::string> told;
    if (told.insert(subject).second)
        std::cerr << "warning: " << sentence << '\n';
}

}  // namespace enduring
