#include "common/experiments/run/saved_run.hpp"
#include "common/experiments/report/report.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/input/input_error.hpp"
#include "common/input/json_document.hpp"
#include "common/simulation/contact_state.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

#include <functional>

using namespace enduring;

namespace {

World boxes(const std::vector<std::string>& names)
{
    World world;
    for (const std::string& name : names) {
        const SurfaceMesh mesh = box(Vec3(1, 0.5, 0.25));
        world.bodies.push_back(
            std::make_unique<RigidBody>(name, mesh, mass_properties(mesh, 3), Vec3(1, 2, 3), Vec3(-3, 1, 2)));
    }
    return world;
}

/// Each of its numbers is another one.
Contact full_contact()
{
    Contact contact{ContactKind::edge_edge, 1, 0, 3, 4, {5, 6, 7, 2}, {1.0 / 3, -2.0 / 7, 0.1, -0.4}};
    contact.orientation = -1;
    contact.start = 0.7;
    contact.impulse = Vec3(1e-300, 0.1, 3);
    contact.friction = Vec3(0.2, -5, 1e17 / 3);
    contact.spring.stretch = Vec3(1, -1.1, 1.2);
    contact.spring.slip = 0.3;
    contact.spring.stiffness = 4e9 / 7;
    contact.spring.rest_offset = -0.011;
    contact.spring.load = 99.9;
    contact.sliding_normal = Vec3(0.6, 0.8, -0.0);
    contact.category = ContactCategory::hooked;
    contact.state = ContactState::held;
    contact.resolved = true;
    return contact;
}

/// Most of its numbers are those of a new pair.
Contact face_contact() { return {ContactKind::vertex_face, 0, 1, 7, 11, {7, 0, 1, 2}}; }

std::vector<double> numbers_of(Contact contact)
{
    StateArchive archive;
    visit_state(archive, contact);
    return archive.numbers();
}

/// What is complained of when a world of these bodies goes on from a file.
std::string refusal(const std::filesystem::path& file, const std::vector<std::string>& names)
{
    World world = boxes(names);
    try {
        resume_run(file, world);
    } catch (const InputError& mistake) {
        CHECK(world.step == 0);
        return mistake.what();
    }
    return "";
}

}  // namespace

TEST_CASE("saved run: bodies, pairs, time and step come back to the last bit")
{
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path / "state.json";
    World world = boxes({"one", "two"});
    Contacts contacts;
    for (int step = 0; step < 3; ++step)
        advance(world, contacts, Solver(), 1.0 / 300);
    contacts = {full_contact(), face_contact()};
    save_run(file, world, contacts);

    World other = boxes({"one", "two"});
    const Contacts pairs = resume_run(file, other);
    CHECK(other.time == world.time);
    CHECK(other.step == 3);
    REQUIRE(pairs.size() == 2);
    CHECK(numbers_of(pairs[0]) == numbers_of(full_contact()));
    CHECK(numbers_of(pairs[1]) == numbers_of(face_contact()));
    CHECK(pairs[0].kind == ContactKind::edge_edge);
    CHECK(pairs[0].sliding_normal == full_contact().sliding_normal);
    CHECK(pairs[0].held());
    for (const double dt : {0.01, 0.003}) {
        Contacts none;
        advance(world, none, Solver(), dt);
        advance(other, none, Solver(), dt);
        for (std::size_t body = 0; body < 2; ++body)
            for (std::size_t v = 0; v < 8; ++v)
                CHECK(other.bodies[body]->positions_t0()[v] == world.bodies[body]->positions_t0()[v]);
    }
}

TEST_CASE(
    "saved run: a file that does not fit is refused with its name and what differs, and changes nothing")
{
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path / "state.json";
    World world = boxes({"one", "two"});
    save_run(file, world, {full_contact()});
    const std::string name = file.string(), text = read_text_file(file);
    CHECK(refusal(file, {"one", "two"}).empty());
    CHECK(refusal(file, {"one"}) == name + ": has 2 bodies, and the scene has 1");
    CHECK(refusal(file, {"one", "three"}) == name + ": /bodies/1 is 'two', and the scene has 'three' there");
    const auto with = [&](const std::string& what, const std::string& other) {
        std::string changed = text;
        changed.replace(changed.find(what), what.size(), other);
        write_file(file, changed);
        return refusal(file, {"one", "two"});
    };
    CHECK(with("\"step\"", "\"stop\"") == name + ": /stop: unknown key; did you mean \"step\"?");
    CHECK(with("\"time\":0.0", "\"time\":\"now\"") ==
          name + ": /time: expected a number from 0 to 3600 [s], found \"now\"");
    CHECK(with("\"time\":0.0", "\"time\":-1e308").find(name + ": /time: expected a number from 0") == 0);
    CHECK(with("\"step\":0", "\"step\":1000000000000000").find(name + ": /step: expected a whole number") ==
          0);
    CHECK(with("run, 1", "run, 7").find(name + ": /format: expected") == 0);
    CHECK(with("\"pairs\":[[", "\"pairs\":[[1.0,").find(name + ": /pairs/0 has ") == 0);
    CHECK(with("[\"one\",[", "[\"one\",[1.0,").find(name + ": /bodies/0 ('one') has ") == 0);
    CHECK(with("{", "").find(name) == 0);
    CHECK(refusal(folder.path / "nothing.json", {"one", "two"}).find("nothing.json") != std::string::npos);
}

TEST_CASE("saved run: a pair of bodies, features or vertices that the scene does not have is refused")
{
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path / "state.json";
    const auto refused = [&](const std::function<void(Contact&)>& change, Contact contact) {
        World world = boxes({"one", "two"});
        change(contact);
        save_run(file, world, {face_contact(), contact});
        const std::string said = refusal(file, {"one", "two"}), start = file.string() + ": /pairs/1 ";
        return said.starts_with(start) ? said.substr(start.size()) : said;
    };
    const std::string body = "is of a body or plane that the scene does not have";
    for (const int place : {-1, 2, 2000000000}) {
        CHECK(refused([&](Contact& c) { c.body_a = place; }, full_contact()) == body);
        CHECK(refused([&](Contact& c) { c.body_b = place; }, face_contact()) == body);
    }
    CHECK(refused([](Contact& c) { c.vertices[3] = 8; }, full_contact()) ==
          "names a vertex that its body does not have");
    CHECK(refused([](Contact& c) { c.feature_a = 18; }, full_contact()) ==
          "names a vertex or an edge that its first body does not have");
    CHECK(refused([](Contact& c) { c.feature_b = 12 + 18 + 8; }, face_contact()) ==
          "names a face or an edge that its second body does not have");
    CHECK(refused([](Contact& c) { c.kind = ContactKind::vertex_plane; }, face_contact()) == body);
    CHECK(refused([](Contact& c) { c.kind = static_cast<ContactKind>(7); }, face_contact()) ==
          "is of a kind or in a state that there is not");
    CHECK(refused([](Contact&) {}, face_contact()).empty());
}

TEST_CASE(
    "saved run: the world forgets into how many parts its last steps were taken, as one that is resumed")
{
    const TemporaryFolder folder;
    World world = boxes({"one"}), resumed = boxes({"one"});
    world.learned_halvings = 2;
    save_run(folder.path / "state.json", world, {});
    resume_run(folder.path / "state.json", resumed);
    CHECK(world.learned_halvings == resumed.learned_halvings);
}

TEST_CASE("saved run: skins are kept, and skins that do not fit the bodies are refused")
{
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path / "state.json";
    const auto saved = [&](std::vector<double> skins) {
        World world = boxes({"one", "two"});
        world.skins = std::move(skins);
        save_run(file, world, {});
    };
    saved({1e-4, 2e-4});
    World world = boxes({"one", "two"});
    resume_run(file, world);
    CHECK(world.skins == std::vector{1e-4, 2e-4});
    saved({1e-4});
    CHECK(refusal(file, {"one", "two"}) ==
          file.string() + ": /skins has 1 numbers, and the scene has 2 bodies");
    saved({1e-4, -1});
    CHECK(refusal(file, {"one", "two"}) ==
          file.string() + ": /skins/1 is not between 0 and the size of its body");
}

TEST_CASE("saved run: an index that is no whole number is refused, and the world is as it was")
{
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path / "state.json";
    World world = boxes({"one", "two"});
    save_run(file, world, {face_contact()});
    const std::string text = read_text_file(file), first = "\"pairs\":[[1.0,0.0,";
    REQUIRE(text.find(first) != std::string::npos);
    for (const char* index : {"0.5", "1e15", "-1e308"}) {
        std::string changed = text;
        changed.replace(changed.find(first), first.size(), std::string("\"pairs\":[[1.0,") + index + ",");
        write_file(file, changed);
        CHECK(refusal(file, {"one", "two"}) ==
              file.string() + ": /pairs/0 is no whole number of the kind that stands there");
    }
}
