#pragma once

#include <span>
#include <vector>

#include "core/animation/head/head_motion.h"

namespace penpose::animation {

/// Tremor is spread evenly over its reach; the standard deviation of that is 1 / sqrt(3).
constexpr double k_tremor_deviation = 0.58;

/// Takes the tremor of a tracker out of the offsets of points that belong together: each of their movements (principal
/// components, Hotelling 1933) follows its own trend (trend.h), and what is none of the few large ones goes. A movement
/// that is larger than tremor, such as a blink, stays on time and nearly as sharp as it is. Frames without a face stay
/// empty. Many points are taken in runs of up to 64, one after the other. `tremor_px`: how far a point that stands
/// still may seem to move along each axis, px of the track; 0 changes nothing.
void denoise(StillTrack& track, std::span<const std::size_t> points, double tremor_px);

/// Takes tremor out of rows of numbers, one row a frame, each column for itself: they follow their trends. `strength`:
/// what bends by no more is taken for tremor; 0 changes nothing. `confidence`: one a frame, 0 to 1.
void denoise_rows(std::span<const double> confidence, double strength, std::vector<std::vector<double>>& rows);

/// Offsets are taken from a frame that trembles as all others do. Once steadied, what they say of that frame is its
/// tremor, which every other frame is off by, and as much doubt of their own: half of it is taken out of all.
void measure_from(StillTrack& track, std::size_t frame);
/// The same from several frames that show the same: their mean trembles less, and all of it is taken out.
void measure_from(StillTrack& track, std::span<const std::size_t> frames);

/// As denoise() on single values, one row a frame and one column a parameter: what remains of the tremor where
/// parameters work against each other. `tremor`: in units of the column, one a column; 0 leaves a column alone.
/// `confidence`: one a frame, 0 to 1.
void denoise_parameters(std::span<const double> tremor, std::span<const double> confidence,
                        std::vector<std::vector<double>>& rows);

/// Rounds the corners of movements: where a line bends, tremor decides in which frame it does, and a parameter that
/// starts a frame early is a jump. A few steps of diffusion over time, each value a quarter of its bend towards its
/// neighbours, which bends near and above `sharp` are spared, as the edges of pictures are (Perona and Malik 1990): a
/// blink keeps its peak. One row a frame and one column a parameter; `sharp`: in units of the column, one a column; 0
/// leaves a column alone.
void round_corners(std::span<const double> sharp, std::vector<std::vector<double>>& rows);

/// Smooths values over the whole clip without lag: a triangle filter over time, `width_s` from its middle to its end,
/// on one row of numbers a frame. Rows keep their count and width; a width below the frame distance changes nothing.
void smooth_over_time(std::span<const double> times_s, double width_s, std::vector<std::vector<double>>& rows);

}  // namespace penpose::animation
