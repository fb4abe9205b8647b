#include "experiments/experiments.hpp"

int main(int argc, char** argv)
{
    using namespace enduring;
    ChapterProgram program{
        "06_redefinition",
        "Chapter 6: redefinition",
        {
            {"sliding", "a cube slides over triangles and over a soft bar without friction (thesis figures 7.8-7.12)", chapter06::sliding},
        },
    };
    return run_chapter(argc, argv, program);
}
