#include "chapters/07_implicit_contact/anderson_mixing.hpp"

#include <Eigen/QR>

namespace enduring {
namespace {

Eigen::MatrixXd as_columns(const std::vector<Eigen::VectorXd>& columns)
{
    Eigen::MatrixXd matrix(columns.front().size(), static_cast<Eigen::Index>(columns.size()));
    for (std::size_t i = 0; i < columns.size(); ++i)
        matrix.col(static_cast<Eigen::Index>(i)) = columns[i];
    return matrix;
}

}  // namespace

//! [next]
Eigen::VectorXd AndersonMixing::next(const Eigen::VectorXd& x, const Eigen::VectorXd& image)
{
    const Eigen::VectorXd error = image - x;
    if (last_error_.size() > 0) {
        images_.push_back(image - last_image_);
        errors_.push_back(error - last_error_);
        // What was learned while other pairs were in touch, or slipped, leads astray.
        if (error.norm() > 2 * last_error_.norm()) {
            images_.clear();
            errors_.clear();
        }
    }
    if (images_.size() > rounds_) {
        images_.erase(images_.begin());
        errors_.erase(errors_.begin());
    }
    last_image_ = image;
    last_error_ = error;
    if (errors_.empty())
        return image;
    const Eigen::VectorXd shares = as_columns(errors_).colPivHouseholderQr().solve(error);
    Eigen::VectorXd mixed = image - as_columns(images_) * shares;
    if (mixed.allFinite())
        return mixed;
    // rounds that hardly change any more have no shares that numbers could tell
    *this = AndersonMixing(static_cast<int>(rounds_));
    return image;
}
//! [next]

}  // namespace enduring
