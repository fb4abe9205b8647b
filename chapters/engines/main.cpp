#include "chapters/engines/experiments/experiments.hpp"

int main(int argc, char** argv)
{
    using namespace enduring;
    return run_chapter(
        argc, argv,
        {"engines",
         "The same scenes under other physics engines",
         {
             {"measured", "the tables of the book, from what is kept in chapters/engines/measured",
              engines::measured},
             {"rows", "every scene under every engine that is installed, at its default and at its best",
              engines::rows},
             {"curves", "error over processor time, as steps and iterations are varied", engines::curves},
             {"growth", "a pyramid of more and more cubes: how far it moves, and the time of a frame",
              engines::growth},
         }});
}
