#include "python/pairs.hpp"

#include "common/simulation/contact_forces.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "python/arrays.hpp"

#include <utility>

namespace enduring::python {

namespace py = pybind11;

Pairs::Pairs(const World& world, std::shared_ptr<const Contacts> of_moment, double dt)
    : contacts(std::move(of_moment)), part(last_part(world, dt))
{
    for (const Contact& contact : *contacts) {
        const ContactGeometry geometry = contact_geometry(world, contact, 1);
        p.push_back(geometry.p);
        q.push_back(geometry.q);
        normals.push_back(geometry.normal);
        depths.push_back(geometry.depth);
    }
}

namespace {

/// A member of every pair, as an array over the pairs' own memory.
template <auto member, class T, py::ssize_t columns>
py::array column(const py::object& self)
{
    const Contacts& contacts = *self.cast<const Pairs&>().contacts;
    const T* first = contacts.empty() ? nullptr : reinterpret_cast<const T*>(&(contacts.front().*member));
    return view(first, contacts.size(), columns, sizeof(Contact), self);
}

}  // namespace

void declare_pairs(py::module_& module)
{
    const auto forces = [](const Pairs& pairs, auto part_of) {
        std::vector<Vec3> rows;
        for (const Contact& contact : *pairs.contacts)
            rows.push_back(part_of(pair_force(contact, pairs.part)));
        return copy(rows);
    };
    py::class_<Pairs>(module, "Pairs", "The pairs in contact at one moment, a row each.")
        .def("__len__", [](const Pairs& pairs) { return pairs.contacts->size(); })
        .def_property_readonly("impulse", column<&Contact::impulse, double, 3>,
                               "along the normal, on A, in the last part of the step [N s]; no copy")
        .def_property_readonly("friction_impulse", column<&Contact::friction, double, 3>,
                               "the same along the surface; no copy")
        .def_property_readonly("bodies", column<&Contact::body_a, int, 2>,
                               "A and B; for a pair with a plane B is the plane; no copy")
        .def_property_readonly("vertices", column<&Contact::vertices, int, 4>,
                               "-1 where there is none; no copy")
        .def_property_readonly("weights", column<&Contact::weights, double, 4>,
                               "with which an impulse reaches them; no copy")
        .def_property_readonly("kind", column<&Contact::kind, std::uint8_t, 1>,
                               "0 plane, 1 vertex-face, 2 edge-edge; no copy")
        .def_property_readonly(
            "p", [](const Pairs& pairs) { return copy(pairs.p); }, "point of A [m]")
        .def_property_readonly(
            "q", [](const Pairs& pairs) { return copy(pairs.q); }, "point of B [m]")
        .def_property_readonly(
            "normal", [](const Pairs& pairs) { return copy(pairs.normals); }, "out of B")
        .def_property_readonly(
            "depth", [](const Pairs& pairs) { return py::array(py::cast(pairs.depths)); },
            "[m], negative inside")
        .def_property_readonly(
            "force",
            [forces](const Pairs& pairs) {
                return forces(pairs, [](const PairForce& force) { return force.normal; });
            },
            "along the normal, on A [N]")
        .def_property_readonly(
            "friction",
            [forces](const Pairs& pairs) {
                return forces(pairs, [](const PairForce& force) { return force.friction; });
            },
            "along the surface, on A [N]");
}

}  // namespace enduring::python
