#include "chapters/11_exact_contact/matrix_text.hpp"
#include "chapters/11_exact_contact/problem_file.hpp"
#include "common/input/input_error.hpp"

#ifdef ENDURING_HDF5
#include "chapters/11_exact_contact/hdf5_handle.hpp"

#include <string>
#include <vector>

namespace enduring {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// An open file that reads whole datasets, and names them where something is wrong.
class FclibFile {
public:
    explicit FclibFile(const std::filesystem::path& path) : name_(path.string()), file_(open(path), H5Fclose)
    {
        if (!file_.valid())
            throw InputError(name_ + ": cannot be read as an HDF5 file");
    }
    bool has(const std::string& place) const
    {
        std::size_t end = 0;
        do {  // libhdf5 asks for each group on the way by itself
            end = place.find('/', end + 1);
            if (H5Lexists(file_.id(), place.substr(0, end).c_str(), H5P_DEFAULT) <= 0)
                return false;
        } while (end != std::string::npos);
        return true;
    }
    std::vector<int> integers(const std::string& place) const { return read<int>(place, H5T_NATIVE_INT); }
    std::vector<double> numbers(const std::string& place) const
    {
        return read<double>(place, H5T_NATIVE_DOUBLE);
    }
    int integer(const std::string& place, int least, int most) const
    {
        const std::vector<int> one = integers(place);
        if (one.size() != 1 || one[0] < least || one[0] > most)
            fail(place,
                 "expected one whole number from " + std::to_string(least) + " to " + std::to_string(most));
        return one[0];
    }
    [[noreturn]] void fail(const std::string& place, const std::string& message) const
    {
        throw InputError(name_ + ": " + place + ": " + message);
    }

private:
    static hid_t open(const std::filesystem::path& path)
    {
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // our own messages say what is wrong
        return H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    }
    template <class Number>
    std::vector<Number> read(const std::string& place, hid_t type) const
    {
        if (!has(place))
            fail(place, "is missing");
        const Hdf5Handle data(H5Dopen2(file_.id(), place.c_str(), H5P_DEFAULT), H5Dclose);
        if (!data.valid())
            fail(place, "is not a list of numbers");
        const Hdf5Handle space(H5Dget_space(data.id()), H5Sclose);
        const hssize_t size = H5Sget_simple_extent_npoints(space.id());
        if (size < 0 || size > 100'000'000)
            fail(place, "has " + std::to_string(size) + " numbers");
        std::vector<Number> numbers(static_cast<std::size_t>(size));
        if (size > 0 && H5Dread(data.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) < 0)
            fail(place, "cannot be read as numbers");
        return numbers;
    }

    std::string name_;
    Hdf5Handle file_;
};

//! [matrix]
/// nz tells the form: at least 0, so many triplets (row i, column p); -1 compressed columns (starts p, rows
/// i); -2 compressed rows.
Matrix read_matrix(const FclibFile& file, const std::string& place)
{
    const int rows = file.integer(place + "/m", 1, most_rows),
              columns = file.integer(place + "/n", 1, most_rows);
    const int form = file.integer(place + "/nz", -2, 100'000'000);
    const std::vector<int> i = file.integers(place + "/i"), p = file.integers(place + "/p");
    const std::vector<double> x = file.numbers(place + "/x");
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](int row, int column, std::size_t entry) {
        if (row < 0 || row >= rows || column < 0 || column >= columns)
            file.fail(place, "entry " + std::to_string(entry) + " is in row " + std::to_string(row) +
                                 ", column " + std::to_string(column) + " of " + std::to_string(rows) +
                                 " x " + std::to_string(columns));
        entries.emplace_back(row, column, x[entry]);
    };
    if (form >= 0) {
        const auto count = static_cast<std::size_t>(form);
        if (count > i.size() || count > p.size() || count > x.size())
            file.fail(place, "has fewer than its nz = " + std::to_string(form) + " entries");
        for (std::size_t entry = 0; entry < count; ++entry)
            add(i[entry], p[entry], entry);
    } else {
        const int lines = form == -1 ? columns : rows;
        if (p.size() < static_cast<std::size_t>(lines) + 1)
            file.fail(place + "/p", "has fewer than " + std::to_string(lines + 1) + " numbers");
        for (int line = 0; line < lines; ++line) {
            const int first = p[static_cast<std::size_t>(line)], last = p[static_cast<std::size_t>(line) + 1];
            if (first < 0 || last < first || static_cast<std::size_t>(last) > std::min(i.size(), x.size()))
                file.fail(place + "/p",
                          "number " + std::to_string(line + 1) + " points outside of the entries");
            for (auto entry = static_cast<std::size_t>(first); entry < static_cast<std::size_t>(last);
                 ++entry)
                form == -1 ? add(i[entry], line, entry) : add(line, i[entry], entry);
        }
    }
    Matrix matrix(rows, columns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}
//! [matrix]

Eigen::VectorXd read_vector(const FclibFile& file, const std::string& place)
{
    const std::vector<double> numbers = file.numbers(place);
    return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

void refuse(const FclibFile& file, const std::string& place)
{
    if (file.has(place))
        file.fail(place, "contacts that hold in both directions are not solved here");
}

}  // namespace

FrictionProblem read_fclib(const std::filesystem::path& path)
{
    const FclibFile file(path);
    FrictionProblem problem;
    if (file.has("/fclib_local")) {
        const std::string at = "/fclib_local/";
        refuse(file, at + "V");
        problem.dimension = file.integer(at + "spacedim", 2, 3);
        problem.response = read_matrix(file, at + "W");
        problem.free_velocity = read_vector(file, at + "vectors/q");
        problem.mu = read_vector(file, at + "vectors/mu");
    } else if (file.has("/fclib_global")) {
        const std::string at = "/fclib_global/";
        refuse(file, at + "G");
        problem.dimension = file.integer(at + "spacedim", 2, 3);
        problem.bodies = BodyEquations{read_matrix(file, at + "M"), read_matrix(file, at + "H"),
                                       read_vector(file, at + "vectors/f"),
                                       read_vector(file, at + "vectors/w")};
        problem.mu = read_vector(file, at + "vectors/mu");
    } else {
        file.fail("/", "has neither fclib_local nor fclib_global");
    }
    complete(problem, path);
    return problem;
}

}  // namespace enduring

#else

namespace enduring {

FrictionProblem read_fclib(const std::filesystem::path& path)
{
    throw InputError(path.string() +
                     ": an HDF5 file, and this program was built without libhdf5. On Debian: "
                     "apt-get install libhdf5-dev, and build again");
}

}  // namespace enduring

#endif
