#pragma once

#include <string>

namespace enduring {

/// A column's name in words, for a page: "dpf_depth_mm" becomes "DPF depth [mm]",
/// "mg_over_k_mm" "mg/k [mm]". The last part is a unit if it names one and something stands
/// before it. A name that has a blank is in words already and stays.
std::string column_words(const std::string& name);

}  // namespace enduring
