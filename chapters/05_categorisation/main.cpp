#include "chapters/05_categorisation/experiments/experiments.hpp"
#include "chapters/05_categorisation/solver.hpp"
#include "common/experiments/own_scene/own_scene.hpp"

int main(int argc, char** argv)
{
    using namespace enduring;
    return run_chapter(
        argc, argv,
        {
            "05_categorisation",
            "Chapter 5: categorisation",
            {
                {"spans", "averaged normals against normal spans (thesis figures 6.5-6.8)", chapter05::spans},
                {"edge_rule", "thesis (6.3) with \"and\" and with \"or\": which lets a cube slide",
                 chapter05::edge_rule, takes_scene},
                {"ambiguity",
                 "three arrangements that look the same to a vertex and a face (thesis figure 6.9)",
                 chapter05::ambiguity},
                {"sliding_categories", "the labels of the sliding cube, and labels against the truth",
                 chapter05::sliding_categories, takes_scene},
                {"dropping", "what becomes of bodies when hooked pairs are simply dropped",
                 chapter05::dropping},
            },
        },
        chapter05_solver);
}
