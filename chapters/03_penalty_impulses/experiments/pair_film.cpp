#include "chapters/03_penalty_impulses/experiments/pair_film.hpp"

#include <algorithm>
#include <iterator>

namespace enduring::chapter03 {
namespace {

/// A body's vertices in the ground would hide what this chapter is about.
void mark_pairs(Stage& stage, const World& world, const Contacts& contacts)
{
    Contacts pairs;
    std::copy_if(contacts.begin(), contacts.end(), std::back_inserter(pairs),
                 [](const Contact& contact) { return !contact.on_plane(); });
    mark_contacts(stage, world, pairs);
}

}  // namespace

PairFilm::PairFilm(const Scene& scene, std::vector<double> times, Report& report, const std::string& name,
                   bool quick)
    : strip_file_(report.file(name + ".png")), strip_(scene, std::move(times), mark_pairs, 560, 400),
      clip_(scene, report.file(name + ".mp4"), quick ? 3 : 20)
{}

void PairFilm::finish()
{
    write_png(strip_.all(3), strip_file_);
    clip_.finish();
}

}  // namespace enduring::chapter03
