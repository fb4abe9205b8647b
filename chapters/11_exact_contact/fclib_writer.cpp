#include "chapters/11_exact_contact/problem_file.hpp"
#include "common/input/input_error.hpp"

#ifdef ENDURING_HDF5
#include "chapters/11_exact_contact/hdf5_handle.hpp"
#include "common/input/pending_file.hpp"

#include <Eigen/SparseCholesky>

#include <string>
#include <vector>

namespace enduring {
namespace {

using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

/// A new file, and what is written into it. Groups come with the first thing in them. It is made in memory: a
/// library that meets a full disk while it closes a file tells nobody, and tries again when the program ends.
class NewFile {
public:
    explicit NewFile(const std::filesystem::path& path)
        : path_(path), in_memory_(H5Pcreate(H5P_FILE_ACCESS), H5Pclose),
          file_(open(path, in_memory_.id()), H5Fclose), with_groups_(H5Pcreate(H5P_LINK_CREATE), H5Pclose)
    {
        require(file_.valid() && with_groups_.valid());
        require(H5Pset_create_intermediate_group(with_groups_.id(), 1) >= 0);
    }
    void write(const std::string& place, const std::vector<int>& numbers)
    {
        write(place, H5T_STD_I32LE, H5T_NATIVE_INT, numbers.data(), numbers.size());
    }
    void write(const std::string& place, int number) { write(place, std::vector<int>{number}); }
    void write(const std::string& place, const VectorXd& numbers)
    {
        write(place, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, numbers.data(),
              static_cast<std::size_t>(numbers.size()));
    }
    /// Puts the whole file into its place.
    /// @throws InputError  it cannot be written there
    void publish() const
    {
        require(H5Fflush(file_.id(), H5F_SCOPE_GLOBAL) >= 0);
        const ssize_t size = H5Fget_file_image(file_.id(), nullptr, 0);
        require(size > 0);
        std::string bytes(static_cast<std::size_t>(size), '\0');
        require(H5Fget_file_image(file_.id(), bytes.data(), bytes.size()) == size);
        write_file(path_, bytes);
    }

private:
    static hid_t open(const std::filesystem::path& path, hid_t in_memory)
    {
        constexpr std::size_t grows_by = 1U << 16;
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // our own message says what is wrong
        if (H5Pset_fapl_core(in_memory, grows_by, 0) < 0)
            return -1;
        return H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, in_memory);
    }
    void require(bool done) const
    {
        if (!done)
            throw InputError(path_.string() + ": cannot be written as an HDF5 file");
    }
    void write(const std::string& place, hid_t in_file, hid_t in_memory, const void* numbers,
               std::size_t count)
    {
        const hsize_t size = count;
        const Hdf5Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
        const Hdf5Handle data(H5Dcreate2(file_.id(), place.c_str(), in_file, space.id(), with_groups_.id(),
                                         H5P_DEFAULT, H5P_DEFAULT),
                              H5Dclose);
        require(data.valid() && H5Dwrite(data.id(), in_memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers) >= 0);
    }

    std::filesystem::path path_;
    Hdf5Handle in_memory_, file_, with_groups_;
};

//! [write_matrix]
/// In compressed columns, which FCLIB tells by nz = -1.
void write_matrix(NewFile& file, const std::string& place, Matrix matrix)
{
    matrix.makeCompressed();
    const auto entries = static_cast<int>(matrix.nonZeros()), columns = static_cast<int>(matrix.cols());
    file.write(place + "/nzmax", entries);
    file.write(place + "/m", static_cast<int>(matrix.rows()));
    file.write(place + "/n", columns);
    file.write(place + "/nz", -1);
    file.write(place + "/p", std::vector<int>(matrix.outerIndexPtr(), matrix.outerIndexPtr() + columns + 1));
    file.write(place + "/i", std::vector<int>(matrix.innerIndexPtr(), matrix.innerIndexPtr() + entries));
    file.write(place + "/x", Eigen::Map<const VectorXd>(matrix.valuePtr(), entries));
}
//! [write_matrix]

/// The velocities of all coordinates by these impulses: M v = f + H r.
VectorXd body_velocities(const BodyEquations& bodies, const VectorXd& impulses)
{
    return Eigen::SimplicialLDLT<Matrix>(bodies.mass).solve(bodies.force + bodies.levers * impulses);
}

}  // namespace

bool knows_fclib() { return true; }

void write_fclib(const FrictionProblem& problem, const std::filesystem::path& path, const VectorXd& impulses)
{
    NewFile file(path);
    const std::string at = problem.bodies ? "/fclib_global/" : "/fclib_local/";
    file.write(at + "spacedim", problem.dimension);
    if (problem.bodies) {
        write_matrix(file, at + "M", problem.bodies->mass);
        write_matrix(file, at + "H", problem.bodies->levers);
        file.write(at + "vectors/f", problem.bodies->force);
        file.write(at + "vectors/w", problem.bodies->given_velocity);
    } else {
        write_matrix(file, at + "W", problem.response);
        file.write(at + "vectors/q", problem.free_velocity);
    }
    file.write(at + "vectors/mu", problem.mu);
    if (impulses.size() > 0) {
        if (problem.bodies)
            file.write("/solution/v", body_velocities(*problem.bodies, impulses));
        file.write("/solution/u", contact_velocities(problem, impulses));
        file.write("/solution/r", impulses);
    }
    file.publish();
}

}  // namespace enduring

#else

namespace enduring {

bool knows_fclib() { return false; }

void write_fclib(const FrictionProblem&, const std::filesystem::path& path, const Eigen::VectorXd&)
{
    throw InputError(path.string() +
                     ": an HDF5 file, and this program was built without libhdf5. On Debian: "
                     "apt-get install libhdf5-dev, and build again");
}

}  // namespace enduring

#endif
