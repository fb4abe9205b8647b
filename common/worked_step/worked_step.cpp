#include "common/worked_step/worked_step.hpp"

#include "common/geometry/triangle_foot.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/point_masses.hpp"

#include <algorithm>
#include <memory>

namespace enduring {

//! [start]
static Contact on_face_0(int vertex, const std::array<double, 4>& weights, double last_impulse)
{
    const std::array<int, 4> vertices{vertex, 0, 1, 2};
    Contact contact{ContactKind::vertex_face, 0, 1, vertex, 0, vertices, weights};
    contact.state = ContactState::answered;  // in the step before
    contact.impulse = {0, last_impulse, 0};
    return contact;
}

WorkedStep worked_step()
{
    const std::vector<Vec3> triangle{{0.5, 0.1, 0.5}, {0.5, -0.1, 1}, {1.5, -0.2, 1.5}};
    const std::vector<Vec3> sheet{{0, 0, 0}, {0, 0, 2}, {2, 0, 0}, {2, 0, 2}};
    const std::vector<Face> one_face{{0, 2, 1}}, two_faces{{0, 1, 2}, {3, 2, 1}};
    const double mass = 1;  // of each point
    auto above = std::make_unique<PointMasses>("above", triangle, one_face, mass);
    auto below = std::make_unique<PointMasses>("below", sheet, two_faces, mass);
    above->set_velocity(0, {0, -2, 0});

    WorkedStep step;
    step.world.gravity.setZero();
    step.world.bodies.push_back(std::move(above));
    step.world.bodies.push_back(std::move(below));
    step.contacts = {on_face_0(1, {1, -0.25, -0.5, -0.25}, 0.1), on_face_0(2, {1, 0, -0.5, -0.5}, 0.2)};
    return step;
}
//! [start]

namespace {

using Weights = std::array<double, 3>;

std::array<Vec3, 3> face_at(const Body& body, int face, double tau)
{
    std::array<Vec3, 3> corners;
    const Face& vertices = body.surface().faces()[face];
    for (std::size_t i = 0; i < 3; ++i)
        corners[i] = body.position(vertices[i], tau);
    return corners;
}

Weights foot_weights(const Vec3& point, const std::array<Vec3, 3>& f)
{
    return foot_on_triangle(point, f[0], f[1], f[2])->weights;
}

double height(const Vec3& point, const std::array<Vec3, 3>& f)
{
    return (f[1] - f[0]).cross(f[2] - f[0]).normalized().dot(point - f[0]);
}

void put_on_face(Contact& contact, const Body& below, int face, const Weights& weights)
{
    const Face& vertices = below.surface().faces()[face];
    contact.feature_b = face;
    for (std::size_t i = 0; i < 3; ++i) {
        contact.vertices[i + 1] = vertices[i];
        contact.weights[i + 1] = -weights[i];
    }
}

/// The face across the edge opposite to the corner whose weight is most
/// negative; -1 at a border or if none is negative.
int face_across(const SurfaceTopology& surface, int face, const Weights& weights)
{
    const std::size_t worst =
        static_cast<std::size_t>(std::min_element(weights.begin(), weights.end()) - weights.begin());
    if (weights[worst] >= 0)
        return -1;
    const int edge = surface.edges_of_face(face)[(worst + 1) % 3];  // edge i runs from corner i to i + 1
    const std::array<int, 2>& faces = surface.faces_at_edge(edge);
    return faces[0] == face ? faces[1] : faces[0];
}

bool known(const Contacts& contacts, int vertex, int face)
{
    return std::any_of(contacts.begin(), contacts.end(),
                       [&](const Contact& c) { return c.feature_a == vertex && c.feature_b == face; });
}

/// Appends the pair if the vertex goes through the face from outside.
void detect_pair(const Body& above, const Body& below, int vertex, int face, Contacts& contacts)
{
    const double h0 = height(above.position(vertex, 0), face_at(below, face, 0));
    const double h1 = height(above.position(vertex, 1), face_at(below, face, 1));
    if (h0 < 0 || h1 >= 0 || known(contacts, vertex, face))
        return;
    const double impact = h0 / (h0 - h1);
    const Weights weights = foot_weights(above.position(vertex, impact), face_at(below, face, impact));
    if (*std::min_element(weights.begin(), weights.end()) < 0)
        return;
    Contact contact{ContactKind::vertex_face, 0, 1, vertex, face, {vertex, -1, -1, -1}, {1, 0, 0, 0}};
    put_on_face(contact, below, face, weights);
    contact.start = impact;
    contacts.push_back(contact);
}

}  // namespace

Pass stand_in_resolve()
{
    return {"resolve", [](World& world, Contacts& contacts, double) {
                const auto resolved = [&](const Contact& contact) {
                    return contact_geometry(world, contact, 0).depth > 0;
                };
                contacts.erase(std::remove_if(contacts.begin(), contacts.end(), resolved), contacts.end());
            }};
}

//! [redefine]
Pass stand_in_redefine()
{
    return {"redefine", [](World& world, Contacts& contacts, double) {
                const Body &above = *world.bodies[0], &below = *world.bodies[1];
                for (Contact& contact : contacts) {
                    const Vec3 vertex = above.position(contact.feature_a, 0);
                    const Weights weights = foot_weights(vertex, face_at(below, contact.feature_b, 0));
                    const int neighbour = face_across(below.surface(), contact.feature_b, weights);
                    if (neighbour >= 0)
                        put_on_face(contact, below, neighbour,
                                    foot_weights(vertex, face_at(below, neighbour, 0)));
                }
            }};
}
//! [redefine]

Pass stand_in_detect()
{
    return {"detect", [](World& world, Contacts& contacts, double) {
                const Body &above = *world.bodies[0], &below = *world.bodies[1];
                for (int vertex = 0; vertex < above.surface().vertex_count(); ++vertex)
                    for (int face = 0; face < static_cast<int>(below.surface().faces().size()); ++face)
                        detect_pair(above, below, vertex, face, contacts);
            }};
}

//! [respond]
Pass stand_in_respond(double stiffness)
{
    return {"respond", [stiffness](World& world, Contacts& contacts, double dt) {
                for (Contact& contact : contacts) {
                    if (!contact.waiting())
                        continue;
                    const ContactGeometry first = contact_geometry(world, contact, contact.start);
                    const ContactGeometry last = contact_geometry(world, contact, 1);
                    const double area = (1 - contact.start) * (first.depth + last.depth) / 2;
                    contact.impulse = -stiffness * dt * area * last.normal;
                }
            }};
}
//! [respond]

Solver worked_step_solver(double stiffness)
{
    return {"stand-ins",
            {stand_in_resolve(), stand_in_redefine()},
            {stand_in_detect()},
            {stand_in_respond(stiffness)}};
}

}  // namespace enduring
