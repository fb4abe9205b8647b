#include "chapters/01_particle_plane/experiments/experiments.hpp"

/// One experiment of the chapter that knows a particle and no body. It needs nothing of the base but tables
/// and plots, so `./course run` has a picture to show minutes before the chapter's own program is compiled.
int main(int argc, char** argv)
{
    using namespace enduring;
    return run_chapter(argc, argv,
                       {"01_particle_plane",
                        "Chapter 1: a first picture",
                        {{"drop", "a particle dropped below and above the stable step", chapter01::drop}}});
}
