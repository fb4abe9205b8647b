#pragma once

namespace enduring {

/// Your prediction: how many turns around a round post hold a thousandfold pull with a coefficient of 0.2.
/// Not judged; positive.
double predicted_turns();

/// The largest ratio of the two pulls that friction holds at a corner, where the rope turns by `turn` [rad],
/// from 0 to below pi. Infinity, where every pull is held.
double corner_factor(double mu, double turn);

/// The same for a rope that turns by `angle` [rad] in all, in equal parts at some corners.
double post_factor(double mu, double angle, int corners);

/// The same for a round post.
double capstan_factor(double mu, double angle);

/// How many turns around a round post hold this ratio, which is at least 1.
double turns_for(double mu, double ratio);

/// The least number of corners of a post that holds at most `error` more than a round one does, as a part of
/// what that holds; 10000 if fewer are not enough.
int corners_needed(double mu, double angle, double error);

}  // namespace enduring
