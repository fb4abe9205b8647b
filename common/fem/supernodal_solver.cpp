#include "common/fem/supernodal_solver.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <mutex>
#include <new>

namespace enduring {
namespace {

const int* ints(const void* array) { return static_cast<const int*>(array); }

/// Eigen's arrays as CHOLMOD sees them. Nothing is copied, and CHOLMOD does not write here.
cholmod_sparse lower_triangle(const Eigen::SparseMatrix<double>& matrix)
{
    cholmod_sparse view{};
    view.nrow = view.ncol = static_cast<std::size_t>(matrix.rows());
    view.nzmax = static_cast<std::size_t>(matrix.nonZeros());
    view.p = const_cast<int*>(matrix.outerIndexPtr());
    view.i = const_cast<int*>(matrix.innerIndexPtr());
    view.x = const_cast<double*>(matrix.valuePtr());
    view.stype = -1;  // symmetric, the lower triangle is stored
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = view.packed = 1;
    return view;
}

/// Where most entries are there, no order fills in less than another. As it stands, nothing is permuted
/// before each factor, which takes a fifth of the time of a soft body in contact.
bool is_nearly_full(const Eigen::SparseMatrix<double>& lower)
{
    return 4 * lower.nonZeros() > lower.rows() * (lower.rows() + 1);
}

/// While it lives, CHOLMOD's own loops (OpenMP) and OpenBLAS, where that is the system's BLAS, keep to one
/// thread: a sum must not depend on how many there are, and the blocks are too small to gain. Neither has to
/// be there: both are asked for by name. The settings are those of the whole program, so two bodies that are
/// factored on two threads wait for each other.
class OneThread {
public:
    OneThread()
    {
        for (Setting& setting : settings_)
            if (setting.get && setting.set) {
                setting.before = setting.get();
                setting.set(setting.one);
            }
    }
    ~OneThread()
    {
        for (const Setting& setting : settings_)
            if (setting.get && setting.set)
                setting.set(setting.before);
    }
    OneThread(const OneThread&) = delete;
    OneThread& operator=(const OneThread&) = delete;

private:
    static inline std::mutex only_one;
    const std::lock_guard<std::mutex> lock_{only_one};
    struct Setting {
        Setting(const char* getter, const char* setter, int one_thread)
            : get(reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, getter))),
              set(reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, setter))), one(one_thread)
        {}
        int (*get)();
        void (*set)(int);
        int one, before = 0;
    };
    Setting settings_[2] = {{"openblas_get_num_threads", "openblas_set_num_threads", 1},
                            {"omp_get_max_active_levels", "omp_set_max_active_levels", 0}};
};

}  // namespace

template <class Real>
SupernodalSolver<Real>::SupernodalSolver(const Eigen::SparseMatrix<double>& pattern, bool dissects)
{
    const OneThread one_thread;  // METIS draws from the program's random numbers
    cholmod_start(&cholmod_);
    cholmod_.print = 0;  // factor() says by its result what CHOLMOD would print
    cholmod_.supernodal = CHOLMOD_SUPERNODAL;
    // Of two orderings the one with the smaller factor; minimum degree
    // alone where CHOLMOD was built without METIS.
    cholmod_.nmethods = dissects ? 2 : 1;
    cholmod_.method[0].ordering = dissects ? CHOLMOD_METIS : CHOLMOD_AMD;
    cholmod_.method[1].ordering = CHOLMOD_AMD;
    if (is_nearly_full(pattern)) {
        cholmod_.nmethods = 1;
        cholmod_.method[0].ordering = CHOLMOD_NATURAL;
        cholmod_.postorder = 0;
    }
    cholmod_sparse view = lower_triangle(pattern);
    factor_ = cholmod_analyze(&view, &cholmod_);
    if (!factor_)
        throw std::bad_alloc();
    operations_ = cholmod_.fl;
    order_.assign(ints(factor_->Perm), ints(factor_->Perm) + factor_->n);
}

template <class Real>
SupernodalSolver<Real>::~SupernodalSolver()
{
    cholmod_free_factor(&factor_, &cholmod_);
    cholmod_finish(&cholmod_);
}

template <class Real>
bool SupernodalSolver<Real>::factor(const Eigen::SparseMatrix<double>& matrix)
{
    const OneThread one_thread;
    cholmod_sparse view = lower_triangle(matrix);
    cholmod_factorize(&view, factor_, &cholmod_);
    if (cholmod_.status != CHOLMOD_OK)
        return false;
    copy_supernodes();
    return true;
}

/// A supernode s has the columns super[s] .. super[s + 1] - 1 of L. Its rows (its columns themselves, then
/// those below) stand from pi[s] in `s`, and its entries, column by column, from px[s] in `x`.
template <class Real>
void SupernodalSolver<Real>::copy_supernodes()
{
    supernodes_.clear();
    for (std::size_t node = 0; node < factor_->nsuper; ++node) {
        const int first = ints(factor_->super)[node], columns = ints(factor_->super)[node + 1] - first;
        const int* rows = ints(factor_->s) + ints(factor_->pi)[node];
        const int* rows_end = ints(factor_->s) + ints(factor_->pi)[node + 1];
        const double* entries = static_cast<const double*>(factor_->x) + ints(factor_->px)[node];
        const Eigen::Map<const Eigen::MatrixXd> block(entries, rows_end - rows, columns);
        supernodes_.push_back({first, columns, {rows + columns, rows_end}, block.template cast<Real>()});
    }
}

//! [block_solve]
/// @param x  unknowns in the factor's order: a vector, or one in each column
template <class Real>
template <class Floats>
void SupernodalSolver<Real>::solve_ordered(Floats& x) const
{
    Floats below(x.rows(), x.cols());
    for (const auto& [first, columns, rows, block] : supernodes_) {
        auto here = x.middleRows(first, columns);
        block.topRows(columns).template triangularView<Eigen::Lower>().solveInPlace(here);
        const auto count = static_cast<Eigen::Index>(rows.size());
        below.topRows(count).noalias() = block.bottomRows(count) * here;
        for (Eigen::Index i = 0; i < count; ++i)
            x.row(rows[i]) -= below.row(i);
    }
    for (auto node = supernodes_.rbegin(); node != supernodes_.rend(); ++node) {
        const auto& [first, columns, rows, block] = *node;
        auto here = x.middleRows(first, columns);
        const auto count = static_cast<Eigen::Index>(rows.size());
        for (Eigen::Index i = 0; i < count; ++i)
            below.row(i) = x.row(rows[i]);
        here.noalias() -= block.bottomRows(count).transpose() * below.topRows(count);
        block.topRows(columns).transpose().template triangularView<Eigen::Upper>().solveInPlace(here);
    }
}
//! [block_solve]

template <class Real>
void SupernodalSolver<Real>::solve(Eigen::VectorXd& b) const
{
    Eigen::VectorX<Real> x(b.size());
    for (Eigen::Index i = 0; i < b.size(); ++i)
        x[i] = static_cast<Real>(b[order_[i]]);
    solve_ordered(x);
    for (Eigen::Index i = 0; i < b.size(); ++i)
        b[order_[i]] = static_cast<double>(x[i]);
}

template <class Real>
void SupernodalSolver<Real>::solve(Eigen::MatrixXd& b) const
{
    constexpr Eigen::Index max_columns = 48;  // at once: they and a large block fit a cache
    for (Eigen::Index first = 0; first < b.cols(); first += max_columns) {
        const Eigen::Index count = std::min(max_columns, b.cols() - first);
        Eigen::MatrixX<Real> x(b.rows(), count);
        for (Eigen::Index i = 0; i < b.rows(); ++i)
            x.row(i) = b.row(order_[i]).segment(first, count).template cast<Real>();
        solve_ordered(x);
        for (Eigen::Index i = 0; i < b.rows(); ++i)
            b.row(order_[i]).segment(first, count) = x.row(i).template cast<double>();
    }
}

template class SupernodalSolver<float>;
template class SupernodalSolver<double>;

}  // namespace enduring
