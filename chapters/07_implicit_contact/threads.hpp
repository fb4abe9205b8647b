#pragma once

#include <cstddef>
#include <functional>

namespace enduring {

/// How many threads solve islands: the number in the environment's ENDURING_THREADS, else one for each core
/// that there is; one where the program was built without oneTBB. Results have the same bytes with any
/// number.
/// @throws InputError  ENDURING_THREADS is no whole number from 1 to 1024
int allowed_threads();

/// Calls work(i) once for each i below count, on up to this many threads. What one of them throws comes out.
/// The first call that has several decides how many the program has at most: these, or allowed_threads().
void for_each_index(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

}  // namespace enduring
