#pragma once

#include <span>
#include <vector>

#include "core/animation/head_motion.h"

namespace penpose::animation {

/// Takes the tremor of a tracker out of the offsets of one curve's points: each frame becomes a weighted mean of the
/// frames within `reach` before and after it that differ from it by no more than tremor does (a bilateral filter over
/// time, Tomasi and Manduchi 1998, on whole curves). Being symmetric in time it does not lag, and a movement that is
/// larger than tremor, such as a blink, stays as sharp as it is. `tremor_px`: how far a point that stands still may
/// seem to move, px of the track; 0 changes nothing.
void steady(StillTrack& track, std::span<const std::size_t> points, double tremor_px, std::size_t reach = 4);

/// The same filter on single values, one row a frame and one column a parameter: what remains of the tremor in a
/// parameter that moves few points. `tremor`: in units of the column, one a column; 0 leaves a column alone.
void settle(std::span<const double> tremor, std::vector<std::vector<double>>& rows, std::size_t reach = 4);

/// Smooths values over the whole clip without lag: a triangle filter over time, `width_s` from its middle to its end,
/// on one row of numbers a frame. Rows keep their count and width; a width below the frame distance changes nothing.
void smooth_over_time(std::span<const double> times_s, double width_s, std::vector<std::vector<double>>& rows);

}  // namespace penpose::animation
