#include "chapters/11_exact_contact/matrix_text.hpp"

#include <string>
#include <vector>

namespace enduring {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

struct Size {
    int rows, columns;
};

/// Numbers column by column, at a place of the matrix.
void read_dense(FileWords& words, const char* what, Size at, Size size, Triplets& entries)
{
    for (int column = 0; column < size.columns; ++column)
        for (int row = 0; row < size.rows; ++row)
            if (const double x = words.next_number(what); x != 0)
                entries.emplace_back(at.rows + row, at.columns + column, x);
}

/// Where rows (or columns) of blocks begin, and behind the last of them where it ends.
std::vector<int> read_ends(FileWords& words, const char* what, int blocks, int size)
{
    std::vector<int> starts{0};
    for (int i = 0; i < blocks; ++i)
        starts.push_back(words.next_integer(what, starts.back() + 1, size));
    if (starts.back() != size)
        words.fail(std::string(what) + ": its blocks end at " + std::to_string(starts.back()) + " of its " +
                   std::to_string(size) + " rows or columns");
    return starts;
}

std::vector<int> read_list(FileWords& words, const char* what, int size, int most)
{
    std::vector<int> list;
    list.reserve(static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i)
        list.push_back(words.next_integer(what, 0, most));
    return list;
}

//! [blocks]
void read_blocks(FileWords& words, const char* what, Size size, Triplets& entries)
{
    const int count = words.next_integer(what, 0, most_rows * 16),
              rows = words.next_integer(what, 1, size.rows),
              columns = words.next_integer(what, 1, size.columns);
    const std::vector<int> row_starts = read_ends(words, what, rows, size.rows),
                           column_starts = read_ends(words, what, columns, size.columns);
    const int starts = words.next_integer(what, rows + 1, rows + 1),
              places = words.next_integer(what, count, count);
    const std::vector<int> first = read_list(words, what, starts, count),
                           column_of = read_list(words, what, places, columns - 1);
    if (first.front() != 0 || first.back() != count)
        words.fail(std::string(what) + ": its rows of blocks do not begin with 0 and end with their number");
    for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row)
        for (int block = first[row]; block < first[row + 1]; ++block) {
            const auto column = static_cast<std::size_t>(column_of[static_cast<std::size_t>(block)]);
            words.next_integer(what, block, block);
            read_dense(
                words, what, {row_starts[row], column_starts[column]},
                {row_starts[row + 1] - row_starts[row], column_starts[column + 1] - column_starts[column]},
                entries);
        }
}
//! [blocks]

void expect(FileWords& words, const char* what, std::string_view wanted)
{
    if (const std::string_view found = words.next(what); found != wanted)
        words.fail(std::string(what) + ": expected " + TextLines::quoted(wanted) + ", found " +
                   TextLines::quoted(found));
}

/// As CSparse prints a matrix: "triplet: 3-by-3, nzmax: 9 nnz: 4", or without the first word by columns.
void read_sparse(FileWords& words, const char* what, Size size, Triplets& entries)
{
    words.next_integer(what, 0, 2);  // where it was made from
    words.skip_line();               // "CSparse Version ..."
    const bool triplets = words.peek() == "triplet:";
    if (triplets)
        words.next(what);
    words.next(what);  // 3-by-3,
    expect(words, what, "nzmax:");
    words.next(what);
    expect(words, what, "nnz:");
    std::string number(words.next(what));
    if (number.ends_with(','))
        number.pop_back();
    if (!triplets)
        words.skip_line();  // 1-norm: ...
    const long count = std::strtol(number.c_str(), nullptr, 10);
    int column = 0;
    for (long i = 0; i < count; ++i) {
        while (!triplets && words.peek() == "col") {
            words.next(what);
            column = words.next_integer(what, 0, size.columns - 1);
            words.skip_line();
        }
        const int row = words.next_integer(what, 0, size.rows - 1);
        if (triplets)
            column = words.next_integer(what, 0, size.columns - 1);
        expect(words, what, ":");
        entries.emplace_back(row, column, words.next_number(what));
    }
    while (!triplets && words.peek() == "col")
        words.skip_line();
}

}  // namespace

Eigen::SparseMatrix<double> read_matrix(FileWords& words, const char* what)
{
    const int kind = words.next_integer(what, 0, 2);
    const int rows = words.next_integer(what, 1, most_rows), columns = words.next_integer(what, 1, most_rows);
    Triplets entries;
    if (kind == 0) {
        words.next_integer(what, rows, rows);
        words.next_integer(what, columns, columns);
        if (static_cast<double>(rows) * columns > static_cast<double>(words.left()))
            words.fail(std::string(what) + ": the file has fewer than its " + std::to_string(rows) + " x " +
                       std::to_string(columns) + " numbers");
        read_dense(words, what, {0, 0}, {rows, columns}, entries);
    } else if (kind == 1) {
        read_blocks(words, what, {rows, columns}, entries);
    } else {
        read_sparse(words, what, {rows, columns}, entries);
    }
    Eigen::SparseMatrix<double> matrix(rows, columns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

}  // namespace enduring
