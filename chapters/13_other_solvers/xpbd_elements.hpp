#pragma once

#include "chapters/13_other_solvers/soft_elements.hpp"

namespace enduring {

//! [xpbd_elements]
/// Elements of soft bodies as constraints of XPBD. The six strains C of an element are to vanish, with the
/// compliance alpha = (V E)^-1 of Hooke's matrix E: then 1/2 C alpha^-1 C is the corotated energy of the
/// base. All six are solved for together,
///   (J M^-1 J^T + alpha / h^2) dlambda = -C - alpha lambda / h^2,   dx = M^-1 J^T dlambda,
/// in the frame R of the element as it is now.
/// @see Macklin, Mueller, Chentanez 2016, "XPBD", (18), and section on finite elements: the strains of an
///     element as one constraint
class XpbdElements {
public:
    /// @param step  outlives this; its soft bodies stay what they are
    explicit XpbdElements(MethodStep& step);
    /// A substep of h [s] begins: no element has a multiplier.
    void begin(double h);
    /// One sweep over all elements, in one order or the other.
    void sweep(bool backwards);

private:
    using Strains = Eigen::Matrix<double, 6, 1>;
    /// An element, by its body.
    struct Element {
        std::size_t body, index;
        Strains lambda;
    };
    void solve(Element& element);

    MethodStep& step_;
    std::vector<SoftElements> bodies_;
    std::vector<Eigen::Matrix<double, 6, 6>> compliances_;  ///< of each body, times volume [1/Pa]
    std::vector<Element> elements_;
    double h_ = 0;
};
//! [xpbd_elements]

}  // namespace enduring
