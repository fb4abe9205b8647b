#include "common/experiments/run/saved_run.hpp"

#include "common/experiments/report/report.hpp"
#include "common/input/input_error.hpp"
#include "common/input/json_document.hpp"
#include "common/input/json_value.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/contact_state.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/step_attempt.hpp"

#include <nlohmann/json.hpp>

#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace enduring {
namespace {

using nlohmann::json;
using Numbers = std::vector<double>;

constexpr double longest_run = 3600;  ///< that a scene may last [s]
constexpr const char* format = "enduring contacts, state of a run, 1";

/// Of a pair or a joint.
template <class Item>
Numbers numbers_of(Item item)
{
    StateArchive archive;
    visit_state(archive, item);
    return archive.numbers();
}

/// To read an item from its numbers.
/// @throws InputError  there are more or fewer than an item of this kind has
template <class Item>
StateArchive archive_of(const Item& item, Numbers numbers, const std::string& place, const std::string& kind)
{
    if (const std::size_t right = numbers_of(item).size(); numbers.size() != right)
        throw InputError(place + " has " + std::to_string(numbers.size()) + " numbers, and a " + kind +
                         " has " + std::to_string(right));
    return StateArchive(std::move(numbers));
}

/// @throws InputError  a part is not there, or is of another kind
template <class Value>
Value part(const json& document, const std::string& key, const std::string& file)
{
    try {
        return document.at(key).get<Value>();
    } catch (const json::exception&) {
        throw InputError(file + ": /" + key + " is missing, or is not what the state of a run has there");
    }
}

std::vector<std::pair<std::string, Numbers>> bodies_of(const json& document, World& world,
                                                       const std::string& file)
{
    auto bodies = part<std::vector<std::pair<std::string, Numbers>>>(document, "bodies", file);
    if (bodies.size() != world.bodies.size())
        throw InputError(file + ": has " + std::to_string(bodies.size()) + " bodies, and the scene has " +
                         std::to_string(world.bodies.size()));
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        Body& body = *world.bodies[i];
        const std::string place = file + ": /bodies/" + std::to_string(i) + " ";
        if (bodies[i].first != body.name())
            throw InputError(place + "is '" + bodies[i].first + "', and the scene has '" + body.name() +
                             "' there");
        if (bodies[i].second.size() != state_of(body).size())
            throw InputError(place + "('" + body.name() + "') has " +
                             std::to_string(bodies[i].second.size()) +
                             " numbers, and that of the scene has " + std::to_string(state_of(body).size()));
    }
    return bodies;
}

bool is_place(int place, std::size_t of_places)
{
    return place >= 0 && static_cast<std::size_t>(place) < of_places;
}

/// What a pair has that this world has not, in words; empty where it fits.
std::string misfit(const Contact& contact, const World& world)
{
    if (contact.kind > ContactKind::edge_edge || contact.category > ContactCategory::hooked ||
        contact.state > ContactState::held)
        return "is of a kind or in a state that there is not";
    const bool on_plane = contact.on_plane();
    if (!is_place(contact.body_a, world.bodies.size()) ||
        !is_place(contact.body_b, on_plane ? world.planes.size() : world.bodies.size()))
        return "is of a body or plane that the scene does not have";
    for (int i = 0; i < contact.vertex_count(); ++i)
        if (!is_place(contact.vertices[static_cast<std::size_t>(i)],
                      body_of_vertex(world, contact, i).positions_t0().size()))
            return "names a vertex that its body does not have";
    const SurfaceTopology& a = world.bodies[static_cast<std::size_t>(contact.body_a)]->surface();
    const bool of_edges = contact.kind == ContactKind::edge_edge;
    if (!is_place(contact.feature_a,
                  of_edges ? a.edges().size() : static_cast<std::size_t>(a.vertex_count())))
        return "names a vertex or an edge that its first body does not have";
    if (on_plane)
        return contact.feature_b == -1 ? "" : "names a feature of a plane";
    const SurfaceTopology& b = world.bodies[static_cast<std::size_t>(contact.body_b)]->surface();
    // of faces a vertex may lie on their edges and corners, too, which are counted behind them
    const auto corners = static_cast<std::size_t>(b.vertex_count());
    return is_place(contact.feature_b,
                    of_edges ? b.edges().size() : b.faces().size() + b.edges().size() + corners)
               ? ""
               : "names a face or an edge that its second body does not have";
}

Contacts contacts_of(const json& document, const World& world, const std::string& file)
{
    Contacts contacts;
    for (Numbers& numbers : part<std::vector<Numbers>>(document, "pairs", file)) {
        const std::string place = file + ": /pairs/" + std::to_string(contacts.size());
        StateArchive archive = archive_of(Contact(), std::move(numbers), place, "pair");
        std::string mistake;
        try {
            visit_state(archive, contacts.emplace_back());
            mistake = misfit(contacts.back(), world);
        } catch (const std::out_of_range& error) {
            mistake = error.what();
        }
        if (!mistake.empty())
            throw InputError(place + " " + mistake);
    }
    return contacts;
}

/// The joints of the world as the document has them; a scene without joints has no such key.
std::vector<Joint> joints_of(const json& document, const World& world, const std::string& file)
{
    std::vector<Joint> joints = world.joints;
    auto states = document.contains("joints") ? part<std::vector<Numbers>>(document, "joints", file)
                                              : std::vector<Numbers>{};
    if (states.size() != joints.size())
        throw InputError(file + ": has " + std::to_string(states.size()) + " joints, and the scene has " +
                         std::to_string(joints.size()));
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const std::string place = file + ": /joints/" + std::to_string(i);
        StateArchive archive = archive_of(joints[i], std::move(states[i]), place, "joint");
        try {
            visit_state(archive, joints[i]);
        } catch (const std::out_of_range& mistake) {
            throw InputError(place + " has a number that " + mistake.what());
        }
    }
    return joints;
}

/// The skins of the bodies; a solver without them has no such key.
Numbers skins_of(const json& document, const World& world, const std::string& file)
{
    if (!document.contains("skins"))
        return {};
    Numbers skins = part<Numbers>(document, "skins", file);
    if (skins.size() != world.bodies.size())
        throw InputError(file + ": /skins has " + std::to_string(skins.size()) +
                         " numbers, and the scene has " + std::to_string(world.bodies.size()) + " bodies");
    for (std::size_t i = 0; i < skins.size(); ++i)
        if (!(skins[i] >= 0 && skins[i] <= world.bodies[i]->size()))
            throw InputError(file + ": /skins/" + std::to_string(i) +
                             " is not between 0 and the size of its body");
    return skins;
}

}  // namespace

void save_run(const std::filesystem::path& file, World& world, const Contacts& contacts)
{
    json document = {{"format", format},       {"time", world.time},      {"step", world.step},
                     {"driven", world.driven}, {"bodies", json::array()}, {"pairs", json::array()}};
    for (const auto& body : world.bodies)
        document["bodies"].push_back({body->name(), state_of(*body)});
    for (const Contact& contact : contacts)
        document["pairs"].push_back(numbers_of(contact));
    for (const Joint& joint : world.joints)
        document["joints"].push_back(numbers_of(joint));
    if (!world.skins.empty())
        document["skins"] = world.skins;
    write_file(file, document.dump() + "\n");
    world.learned_halvings = 0;
    for (const auto& body : world.bodies)
        if (auto* soft = dynamic_cast<DeformableBody*>(body.get()))
            soft->forget_learned();
}

Contacts resume_run(const std::filesystem::path& file, World& world)
{
    const std::string name = file.string();
    const json document = parse_json(read_text_file(file), name);
    if (part<std::string>(document, "format", name) != format)
        throw InputError(name + ": /format: expected \"" + format + "\"");
    const JsonValue root(document, name);
    root.require_keys({"format", "time", "step", "driven", "bodies", "pairs", "joints", "skins"});
    const double time = root.at("time").number({0, longest_run, true, true, "s"});
    const int step = root.at("step").integer(0, std::numeric_limits<int>::max());
    const double driven = part<double>(document, "driven", name);
    const auto bodies = bodies_of(document, world, name);
    Contacts contacts = contacts_of(document, world, name);
    std::vector<Joint> joints = joints_of(document, world, name);
    Numbers skins = skins_of(document, world, name);
    const SavedState before(world, {});
    for (std::size_t i = 0; i < bodies.size(); ++i)
        try {
            restore_state(*world.bodies[i], bodies[i].second);
        } catch (const std::out_of_range& mistake) {
            Contacts none;
            before.restore(world, none);
            throw InputError(name + ": /bodies/" + std::to_string(i) + " has a number that " +
                             mistake.what());
        }
    world.time = time;
    world.step = step;
    world.driven = driven;
    world.joints = std::move(joints);
    world.skins = std::move(skins);
    return contacts;
}

}  // namespace enduring
