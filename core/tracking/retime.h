#pragma once

#include "core/animation/track.h"
#include "core/base/result.h"

namespace penpose::tracking {

/// Puts frames at an even rate, one after the other, whatever times the file gives: a take of another length.
/// `fps`: frames a second, above 0.
void stretch(animation::WeightTrack& track, double fps);
void stretch(animation::PointTrack& track, double fps);

/// Frames at an even rate that show what the track shows at their times, from its first frame to its last; between two
/// frames in which a face was found, values and points go evenly. `fps`: frames a second, above 0.
/// Errors (place "fps"): over a million frames.
[[nodiscard]] base::Status resample(animation::WeightTrack& track, double fps);
[[nodiscard]] base::Status resample(animation::PointTrack& track, double fps);

/// Takes the values of a frame for rest: subtracts them from all frames, down to 0 where a value is never below 0.
/// Errors (place "neutral"): there is no such frame, or no face was found in it.
[[nodiscard]] base::Status subtract_neutral(animation::WeightTrack& track, std::size_t frame);

/// Divides values by 100 where they are percent: most columns that move go beyond 2, and none beyond 100. Columns of
/// turns stay. Returns whether they were.
bool divide_percent(animation::WeightTrack& track);

/// Reads turns of the head and the eyes (HeadYaw, LeftEyePitch, ...) in degrees as radians, where one goes beyond a
/// half turn, all are whole numbers, or a tenth of the steps from frame to frame is faster than a head can turn.
/// Returns whether they were.
bool take_degrees(animation::WeightTrack& track);

}  // namespace penpose::tracking
