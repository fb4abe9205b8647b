#pragma once

#include "common/input/input_error.hpp"

#include <string>

namespace enduring {

/// What is said to an input that is refused, or "no complaint".
template <class Work>
std::string complaint_of(const Work& work)
{
    try {
        work();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no complaint";
}

}  // namespace enduring
