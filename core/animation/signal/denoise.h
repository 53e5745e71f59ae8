#pragma once

#include <span>
#include <vector>

#include "core/animation/head/head_motion.h"

namespace penpose::animation {

/// Tremor is uniform over its range; its standard deviation is 1 / sqrt(3) of it.
constexpr double k_tremor_deviation = 0.58;

/// Removes a tracker's tremor from the offsets of points that belong together: each of their large movements (principal
/// components, Hotelling 1933) follows its own trend (trend.h), and small components are dropped. A movement larger
/// than the tremor, such as a blink, keeps its timing and nearly its sharpness. Frames without a face stay empty. Many
/// points are processed in runs of up to 64. `tremor_px`: how far a point that does not move may seem to move along
/// each axis, px of the track; 0 changes nothing.
void denoise(StillTrack& track, std::span<const std::size_t> points, double tremor_px);

/// Removes tremor from rows of numbers, one row a frame: each column follows its own trend. `strength`: smaller bends
/// count as tremor; 0 changes nothing. `confidence`: one a frame, 0 to 1.
void denoise_rows(std::span<const double> confidence, double strength, std::vector<std::vector<double>>& rows);

/// Offsets are relative to a frame that has tremor itself. After denoising, that frame's own offset estimates its
/// tremor, by which every other frame is off, with equal uncertainty: so half of it is subtracted from all.
void measure_from(StillTrack& track, std::size_t frame);
/// The same for several equal frames: their mean has less tremor, and all of it is subtracted.
void measure_from(StillTrack& track, std::span<const std::size_t> frames);

/// As denoise(), for parameters, one row a frame and one column a parameter: removes the tremor that remains where
/// parameters work against each other. `tremor`: in units of the column, one a column; 0 leaves a column alone.
/// `confidence`: one a frame, 0 to 1.
void denoise_parameters(std::span<const double> tremor, std::span<const double> confidence,
                        std::vector<std::vector<double>>& rows);

/// Rounds the corners of movements: tremor decides in which frame a line bends, and a parameter that starts a frame
/// early is a jump. Takes a few steps of diffusion over time, each value a quarter of its bend towards its neighbours.
/// Bends near and above `sharp` are spared, like edges in pictures (Perona and Malik 1990): a blink keeps its peak. One
/// row a frame and one column a parameter; `sharp`: in units of the column, one a column; 0 leaves a column alone.
void round_corners(std::span<const double> sharp, std::vector<std::vector<double>>& rows);

/// Smooths values over the whole clip without lag: a triangle filter over time, `width_s` from its middle to its end,
/// on one row of numbers a frame. Rows keep their count and width; a width below the frame distance changes nothing.
void smooth_over_time(std::span<const double> times_s, double width_s, std::vector<std::vector<double>>& rows);

}  // namespace penpose::animation
