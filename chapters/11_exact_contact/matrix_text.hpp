#pragma once

#include "chapters/11_exact_contact/file_words.hpp"

#include <Eigen/SparseCore>

namespace enduring {

/// The most rows of a matrix that is read, and the most of contacts: a damaged file is told before it fills
/// the memory.
inline constexpr int most_rows = 200000;

/// A matrix as Siconos writes it. It begins with its kind, its rows and its columns; then
///   kind 0: rows and columns once more, and all numbers, column by column;
///   kind 1: blocks: their number, how many rows and columns of blocks, where each of these ends, two lists
///   as of
///           compressed rows (row starts, columns), and the blocks, each with its place and its numbers
///           column by column;
///   kind 2: sparse, as CSparse prints it: triplets (i j : x), or column by column.
/// @param what  its name for messages, as "the matrix W"
/// @throws InputError
Eigen::SparseMatrix<double> read_matrix(FileWords& words, const char* what);

}  // namespace enduring
