#include "chapters/11_exact_contact/problem_file.hpp"

#include "chapters/11_exact_contact/tests/one_block.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/input/input_error.hpp"
#include "common/input/source_directory.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace enduring;

namespace {

/// What a text is refused for; empty if it is read.
std::string complaint(const std::string& text)
{
    try {
        parse_siconos(text, "problem.dat");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

std::filesystem::path small_file(const std::string& name)
{
    return source_directory() / "chapters/11_exact_contact/tests/files" / (name + ".hdf5");
}

std::string complaint_about_file(const std::string& name)
{
    try {
        read_problem(small_file(name));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// Whether this program reads HDF5 at all; else each such file is refused, with the package's name.
bool reads_hdf5()
{
    const std::string said = complaint_about_file("rows");
    CHECK((said.empty() || said.find("libhdf5-dev") != std::string::npos));
    return said.empty();
}

const std::string sliding = "3\n1\n0\n3\n3\n3 3\n 0.5 0 0  0 0.5 0  0 0 0.5\n -1 1.2 1.6\n 0.5\n";

}  // namespace

TEST_CASE("problem file: a response in text is read, its matrix column by column")
{
    const FrictionProblem problem = parse_siconos(sliding, "problem.dat");
    const HandSolved block = hand_solved_blocks()[1];
    CHECK(problem.dimension == 3);
    CHECK(problem.contacts() == 1);
    CHECK((Eigen::MatrixXd(problem.response) - Eigen::MatrixXd(block.problem.response)).isZero(0));
    CHECK(problem.free_velocity == block.problem.free_velocity);
    CHECK(problem.mu == block.problem.mu);
    const FrictionProblem by_columns = parse_siconos("2 1 0 2 2 2 2  1 0.1 0.2 1  -1 0  0.5", "problem.dat");
    CHECK(by_columns.response.coeff(1, 0) == 0.1);
    CHECK(by_columns.response.coeff(0, 1) == 0.2);
}

TEST_CASE("problem file: blocks and sparse matrices in text are the same matrix")
{
    const std::string blocks =
        "2 2 1 4 4  3 2 2  2 4  2 4  3 3  0 2 3  0 1 1  0 1 3 2 4  1 5 7 6 8  2 9 11 10 12 "
        " -1 0 -1 0  0.1 0.2";
    const std::string sparse =
        "2 2 2 4 4  0\nCSparse Version 3.2.0, Sept 12, 2017.  Copyright\n"
        "triplet: 4-by-4, nzmax: 12 nnz: 12\n"
        "0 0 : 1\n 0 1 : 2\n 1 0 : 3\n 1 1 : 4\n 0 2 : 5\n 0 3 : 6\n 1 2 : 7\n 1 3 : 8\n"
        "2 2 : 9\n 2 3 : 10\n 3 2 : 11\n 3 3 : 12\n -1 0 -1 0  0.1 0.2";
    const std::string columns =
        "2 2 2 4 4  1\nCSparse Version 3.2.0, Sept 12, 2017.  Copyright\n"
        "4-by-4, nzmax: 12 nnz: 12, 1-norm: 36\n"
        " col 0 : locations 0 to 1\n 0 : 1\n 1 : 3\n col 1 : locations 2 to 3\n 0 : 2\n 1 : 4\n"
        " col 2 : locations 4 to 7\n 0 : 5\n 1 : 7\n 2 : 9\n 3 : 11\n"
        " col 3 : locations 8 to 11\n 0 : 6\n 1 : 8\n 2 : 10\n 3 : 12\n"
        " -1 0 -1 0  0.1 0.2";
    Eigen::MatrixXd expected(4, 4);
    expected << 1, 2, 5, 6, 3, 4, 7, 8, 0, 0, 9, 10, 0, 0, 11, 12;
    for (const std::string& text : {blocks, sparse, columns}) {
        const FrictionProblem problem = parse_siconos(text, "problem.dat");
        CHECK(Eigen::MatrixXd(problem.response) == expected);
        CHECK(problem.mu == Eigen::Vector2d(0.1, 0.2));
    }
}

TEST_CASE("problem file: bodies in text make the contacts' response and free velocity")
{
    const FrictionProblem problem = parse_siconos(
        "3 1  0 3 3 3 3  2 0 0 0 2 0 0 0 2   0 3 3 3 3  1 0 0 0 1 0 0 0 1   -2 2 3   0 0.2 0.1   0.5",
        "p.dat");
    REQUIRE(problem.bodies.has_value());
    CHECK((Eigen::MatrixXd(problem.response) - 0.5 * Eigen::Matrix3d::Identity()).norm() <= 1e-15);
    CHECK((problem.free_velocity - Eigen::Vector3d(-1, 1.2, 1.6)).norm() <= 1e-15);
}

TEST_CASE("problem file: what is wrong in a text is told with its line")
{
    CHECK(complaint("7\n1\n") == "problem.dat:1: the dimension is '7', not a whole number from 2 to 3");
    CHECK(complaint("3\n-4\n").starts_with("problem.dat:2: the number of contacts is '-4'"));
    CHECK(complaint("3\n1\n5\n").starts_with("problem.dat:3: the first matrix is '5'"));
    CHECK(complaint("3\n1\n0\n3\n3\n3 3\n1 2")
              .starts_with("problem.dat:6: the first matrix: the file has fewer"));
    CHECK(complaint("3\n1\n0\n3\n3\n3 3\n 1 0 0  0 x 0  0 0 1\n -1 1 1 \n 0.5") ==
          "problem.dat:7: the first matrix has 'x', not a finite number");
    CHECK(complaint("3\n1\n0\n3\n3\n3 3\n 1 0 0  0 nan 0  0 0 1\n -1 1 1 \n 0.5")
              .starts_with("problem.dat:7:"));
    CHECK(complaint("3\n1\n0\n3\n3\n3 3\n 1 0 0  0 1 0  0 0 1\n -1 1 1 \n") ==
          "problem.dat:8: the file ends here: the vector mu is missing");
    CHECK(complaint("3\n2\n0\n3\n3\n3 3\n 1 0 0  0 1 0  0 0 1\n -1 1 1 \n 0.5 ")
              .starts_with("problem.dat:7: the matrix W has 3 rows"));
    CHECK(complaint("3\n1\n0\n3\n3\n3 3\n 1 0 0  0 1 0  0 0 1\n -1 1 1 \n -0.5 ")
              .starts_with("problem.dat: mu of contact 1: expected a number from 0 to 1e6"));
    CHECK(complaint("3\n1\n0\n3\n3\n3 3\n -1 0 0  0 1 0  0 0 1\n -1 1 1 \n 0.5 ")
              .starts_with("problem.dat: the matrix W is negative along the normal of contact 1"));
    CHECK(
        complaint(
            "3 1  0 3 3 3 3  2 0 0 0 -2 0 0 0 2   0 3 3 3 3  1 0 0 0 1 0 0 0 1   -2 2 3   0 0.2 0.1   0.5") ==
        "problem.dat: the matrix M is not positive definite");
    CHECK(complaint("2 2 1 4 4  3 2 2  2 3  2 4 ").find("its blocks end at 3 of its 4") != std::string::npos);
    CHECK(complaint("2 2 1 4 4  3 2 2  2 4  2 4  3 3  0 2 3  0 9 1").find("'9'") != std::string::npos);
    CHECK(complaint("").find("the file is empty") != std::string::npos);
    CHECK(complaint("3\n1\n0\n3\n3\n3 3\n 1 0 0  0 1 0  0 0 1\n -1 1 1e308 \n 0.5 ") ==
          "problem.dat: number 3 of the vector q: expected at most 1e100, found 1e+308");
    CHECK(complaint("3\n1\n0\n3\n3\n3 3\n 1 0 0  0 1e200 0  0 0 1\n -1 1 1 \n 0.5 ") ==
          "problem.dat: the matrix W, row 2, column 2: expected at most 1e100, found 1e+200");
    CHECK(complaint("3\n1\n0\n3\n3\n3 3\n 1 0 0  0 1 0  0 0 1\n -1 1 1 \n 1e300 ") ==
          "problem.dat: mu of contact 1: expected a number from 0 to 1e6, found 1e+300");
    CHECK(
        complaint(
            "3 1  0 3 3 3 3  2 0 0 0 2 0 0 0 2   0 3 3 3 3  1 0 0 0 1 0 0 0 1   -2 2 3   0 1e308 0.1   0.5") ==
        "problem.dat: number 2 of the vector w: expected at most 1e100, found 1e+308");
}

TEST_CASE("problem file: every beginning of a text ends with a message")
{
    for (std::size_t size = 0; size + 5 < sliding.size(); ++size)
        CHECK(complaint(sliding.substr(0, size)) != "");
}

TEST_CASE("problem file: a file that is not there is named")
{
    CHECK_THROWS_WITH_AS(read_problem("no/such/file.dat"), doctest::Contains("no/such/file.dat"), InputError);
}

TEST_CASE("problem file: triplets, compressed columns and compressed rows in HDF5 are the same matrix")
{
    if (!reads_hdf5())
        return;
    Eigen::MatrixXd expected = 0.5 * Eigen::MatrixXd::Identity(6, 6);
    expected.topRightCorner(3, 3) = expected.bottomLeftCorner(3, 3) = 0.1 * Eigen::Matrix3d::Identity();
    expected(0, 1) = 0.02;
    for (const char* name : {"triplets", "columns", "rows"}) {
        const FrictionProblem problem = read_problem(small_file(name));
        CAPTURE(name);
        CHECK(Eigen::MatrixXd(problem.response) == expected);
        CHECK(problem.free_velocity[5] == 0.4);
        CHECK(problem.mu == Eigen::Vector2d(0.5, 0.6));
    }
    const FrictionProblem bodies = read_problem(small_file("bodies"));
    CHECK((bodies.free_velocity - Eigen::Vector3d(-1, 1.2, 1.6)).norm() <= 1e-15);
}

TEST_CASE("problem file: what is written as HDF5 is read as the same problem, to the last bit")
{
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path / "problem.hdf5";
    if (!knows_fclib()) {
        CHECK_THROWS_WITH_AS(write_fclib({}, file), doctest::Contains("libhdf5-dev"), InputError);
        return;
    }
    FrictionProblem contact = hand_solved_blocks()[1].problem;
    contact.response.coeffRef(0, 1) = 0.03;  // not symmetric
    FrictionProblem bodies = parse_siconos(
        "3 1  0 3 3 3 3  2 0 0 0 2 0 0 0 2   0 3 3 3 3  1 0 0 0 1 0.3 0 0 1   -2 2 3   0 0.2 0.1   0.5", "p");
    for (const FrictionProblem& problem : {contact, bodies}) {
        write_fclib(problem, file, Eigen::Vector3d(2, -0.6, -0.8));
        const FrictionProblem read = read_problem(file);
        CHECK(read.dimension == 3);
        CHECK((Eigen::MatrixXd(read.response) - Eigen::MatrixXd(problem.response)).isZero(0));
        CHECK(read.free_velocity == problem.free_velocity);
        CHECK(read.mu == problem.mu);
        REQUIRE(read.bodies.has_value() == problem.bodies.has_value());
        if (read.bodies) {
            CHECK(Eigen::MatrixXd(read.bodies->mass) == Eigen::MatrixXd(problem.bodies->mass));
            CHECK(Eigen::MatrixXd(read.bodies->levers) == Eigen::MatrixXd(problem.bodies->levers));
            CHECK(read.bodies->force == problem.bodies->force);
            CHECK(read.bodies->given_velocity == problem.bodies->given_velocity);
        }
    }
    write_fclib(contact, folder.path / "new/folder.hdf5");  // a missing folder is made
    CHECK(read_problem(folder.path / "new/folder.hdf5").mu == contact.mu);
    CHECK_THROWS_AS(write_fclib(contact, folder.path / "new/folder.hdf5/below_a_file.hdf5"), InputError);
}

TEST_CASE("problem file: what is wrong in an HDF5 file is told with its place")
{
    if (!reads_hdf5())
        return;
    CHECK(complaint_about_file("wrong_index").find("/fclib_local/W: entry 2 is in row 7") !=
          std::string::npos);
    CHECK(complaint_about_file("short_q").find("numbers of the vector q: expected 6, found 4") !=
          std::string::npos);
    CHECK(complaint_about_file("no_mu").find("/fclib_local/vectors/mu: is missing") != std::string::npos);
    CHECK(complaint_about_file("both_directions")
              .find("/fclib_local/V: contacts that hold in both directions") != std::string::npos);
    CHECK(complaint_about_file("empty").find("has neither fclib_local nor fclib_global") !=
          std::string::npos);
    CHECK(complaint_about_file("cut").find("cannot be read as an HDF5 file") != std::string::npos);
}

TEST_CASE(
    "problem file: six thousand contacts of one body, whose W has more numbers than memory, are refused in a line")
{
    FrictionProblem problem;
    BodyEquations body;
    const int contacts = 6602;
    body.mass = Eigen::MatrixXd(Eigen::MatrixXd::Identity(6, 6)).sparseView();
    body.levers = Eigen::MatrixXd(Eigen::MatrixXd::Constant(6, 3 * contacts, 0.5)).sparseView();
    body.force = Eigen::VectorXd::Ones(6);
    body.given_velocity = Eigen::VectorXd::Zero(3 * contacts);
    problem.bodies = body;
    problem.mu = Eigen::VectorXd::Constant(contacts, 0.3);
    CHECK_THROWS_WITH_AS(complete(problem, "island.dat"),
                         doctest::Contains("island.dat: one coordinate is moved by 19806 numbers of r"),
                         InputError);
}
