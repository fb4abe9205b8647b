#include "common/experiments/report/pictures_wanted.hpp"

namespace enduring {
namespace {

bool wanted_now = true;

}  // namespace

bool pictures_wanted() { return wanted_now; }

void want_pictures(bool wanted) { wanted_now = wanted; }

}  // namespace enduring
