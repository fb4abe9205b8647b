#pragma once

#include <algorithm>

namespace enduring {

/// What a step has cost, or one attempt at it. Counts alone and no clock, so they are the same for any number
/// of threads.
struct StepWork {
    long attempts = 0;      ///< at the step and at its parts
    long parts = 0;         ///< attempts that were kept: 1 where nothing was halved
    long ended_badly = 0;   ///< parts that could not be halved any more
    long responses = 0;     ///< rounds of detection and response, of all attempts
    long islands = 0;       ///< the most that were solved side by side
    long rounds = 0;        ///< problems that were set up, of all islands in all responses of all attempts
    long newton_steps = 0;  ///< of all of these
    long unsolved = 0;      ///< islands that a part has kept without solving them to the tolerance
    double residual = 0;    ///< the worst one with which a part has kept an island [1]

    /// Takes an attempt that has ended: what it cost counts in any case, how well it was solved only if it is
    /// kept.
    void add(const StepWork& attempt, bool kept)
    {
        ++attempts;
        responses += attempt.responses;
        islands = std::max(islands, attempt.islands);
        rounds += attempt.rounds;
        newton_steps += attempt.newton_steps;
        if (!kept)
            return;
        ++parts;
        unsolved += attempt.unsolved;
        residual = std::max(residual, attempt.residual);
    }
};

/// Tells each number with its name, in the order in which tables have them.
template <class Visit>
void visit_work(const StepWork& work, Visit&& visit)
{
    visit("attempts", work.attempts);
    visit("parts", work.parts);
    visit("ended_badly", work.ended_badly);
    visit("responses", work.responses);
    visit("islands", work.islands);
    visit("rounds", work.rounds);
    visit("newton_steps", work.newton_steps);
    visit("unsolved", work.unsolved);
    visit("residual", work.residual);
}

}  // namespace enduring
