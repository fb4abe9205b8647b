#include "common/experiments/run/saved_run.hpp"

#include "common/experiments/report/report.hpp"
#include "common/input/input_error.hpp"
#include "common/input/json_document.hpp"
#include "common/simulation/contact_state.hpp"
#include "common/simulation/deformable_body.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <utility>

namespace enduring {
namespace {

using nlohmann::json;
using Numbers = std::vector<double>;

constexpr const char* format = "enduring contacts, state of a run, 1";

Numbers state_of(Contact contact)
{
    StateArchive archive;
    visit_state(archive, contact);
    return archive.numbers();
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

Contacts contacts_of(const json& document, const std::string& file)
{
    Contacts contacts;
    for (Numbers& numbers : part<std::vector<Numbers>>(document, "pairs", file)) {
        const std::size_t right = state_of(Contact()).size();
        if (numbers.size() != right)
            throw InputError(file + ": /pairs/" + std::to_string(contacts.size()) + " has " +
                             std::to_string(numbers.size()) + " numbers, and a pair has " +
                             std::to_string(right));
        StateArchive archive(std::move(numbers));
        visit_state(archive, contacts.emplace_back());
    }
    return contacts;
}

}  // namespace

void save_run(const std::filesystem::path& file, World& world, const Contacts& contacts)
{
    json document = {{"format", format},       {"time", world.time},      {"step", world.step},
                     {"driven", world.driven}, {"bodies", json::array()}, {"pairs", json::array()}};
    for (const auto& body : world.bodies)
        document["bodies"].push_back({body->name(), state_of(*body)});
    for (const Contact& contact : contacts)
        document["pairs"].push_back(state_of(contact));
    write_file(file, document.dump() + "\n");
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
    const auto bodies = bodies_of(document, world, name);
    Contacts contacts = contacts_of(document, name);
    world.time = part<double>(document, "time", name);
    world.step = part<int>(document, "step", name);
    world.driven = part<double>(document, "driven", name);
    for (std::size_t i = 0; i < bodies.size(); ++i)
        restore_state(*world.bodies[i], bodies[i].second);
    return contacts;
}

}  // namespace enduring
