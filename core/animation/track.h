#pragma once

#include <cstddef>
#include <glm/mat3x3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::animation {

using geometry::PxPoint;

/// Where an eye looks, radians from straight out of the face: to the picture's right, and down.
struct Gaze {
  double right = 0, down = 0;
};

/// What a tracker reports about a face besides its points.
struct TrackerSays {
  std::optional<double> closing = std::nullopt;  ///< how far the eyes close, in its own unit (AU45 of OpenFace)
  std::vector<Gaze> gaze = {};                   ///< one an eye, the picture's left one first; empty where unknown
  std::vector<double> units = {};                ///< one a name of PointTrack::unit_names, 0..1; empty where unknown
};

/// What a tracker found in one picture of a video.
struct TrackFrame {
  double time_s = 0;
  double confidence = 0;        ///< 0..1; 0: no face was found, and `points` may be empty
  std::vector<PxPoint> points;  ///< px of the video, y down; one a point of the format
  std::vector<double> depths;   ///< px towards the camera, one a point; empty where unknown
  /// The head's rotation from a face that looks into the camera (x right, y down, z away), if the tracker reports it.
  std::optional<glm::dmat3> rotation = std::nullopt;
  TrackerSays says = {};
  std::string why_held = {};  ///< why the frame shows no face; empty where it does or the file does not say

  [[nodiscard]] bool found() const { return confidence > 0 && !points.empty(); }
};

/// Points of a frame that form a curve with a name.
struct TrackGroup {
  std::string name;
  std::size_t first = 0;
  std::size_t count = 0;
};

/// Tracked points over time. Every frame with a face has `point_count` points.
struct PointTrack {
  std::size_t point_count = 0;
  std::vector<TrackFrame> frames;       ///< in order of time
  std::vector<TrackGroup> groups;       ///< for formats that name their curves; empty otherwise
  std::vector<std::string> unit_names;  ///< of action units ("AU12"); empty where the file has none
  std::vector<std::string> notes;       ///< frames left out or held, one line each
  std::string rate_note;                ///< the assumed frame rate, where the file has none
};

struct WeightFrame {
  double time_s = 0;
  bool found = false;
  std::vector<double> values;  ///< one a name; empty where not found
};

/// Values of named controls over time, from a tracker with a rig of its own.
struct WeightTrack {
  std::vector<std::string> names;
  std::vector<WeightFrame> frames;
  std::vector<std::string> notes;
  std::string rate_note;
};

/// Frames a second of evenly spaced times; 0 for fewer than two frames or times that do not increase.
[[nodiscard]] double frames_per_second(double first_s, double last_s, std::size_t frames);

/// The frame rate for which all these times (ascending, s) are whole frames to within a share of one: a standard video
/// rate if one fits, or lies within 0.05 % of the rate that does (29.99 is 30; 29.97, a rate of its own, stays), else
/// the rate of most steps; 0 where there is none.
[[nodiscard]] double whole_frame_rate(std::span<const double> times_s, double within);
/// The times rounded to whole frames of that rate, which whole_frame_rate gave.
[[nodiscard]] std::vector<double> at_whole_frames(std::span<const double> times_s, double fps);

}  // namespace penpose::animation
