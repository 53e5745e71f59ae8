#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/animation/animate_track.h"
#include "core/base/result.h"
#include "core/document/document.h"
#include "core/io/project/landmark_file.h"
#include "core/io/tracks/map_file.h"
#include "core/io/tracks/track_formats.h"

namespace penpose::tracking {

/// How `animate` plays a track.
struct AnimateOptions {
  std::optional<bool> apply_head;      ///< the head's turn becomes part of the animation; by default as the map says
  std::optional<std::size_t> neutral;  ///< frame, from 0, in which the face is at rest; by default one of a clip of
                                       ///< points, and none of a clip of values
  std::optional<double> tremor_px;     ///< 0..1000, as animation::TrackSetup
  double smooth_s = 0;                 ///< 0..60, as animation::smooth_over_time
  double least_confidence = 0.2;       ///< 0..1; frames below are held
  double fps = 0;                      ///< 0.1..10000: the track is seen at so many even frames a second; 0: at its own
  double stretch = 0;  ///< 0.1..10000: its frames follow each other at that rate, whatever their times; 0: their times
  bool units = false;  ///< action units of the track are evidence beside its points
  std::vector<io::VertexCurve> curves;  ///< of the model, that the map may name beside the model's own
};

/// What an error of `animate` is about.
enum class AnimateInput : std::uint8_t { model, track, map };

/// One entry a frame of the track in `times_s`, `poses` and, where the track is of points, `head`.
struct Animated {
  document::Document document;  ///< with the animation "tracked" first; keys that it had are an animation after it
  std::vector<double> times_s;  ///< on whole frames where the track has an even rate
  std::vector<rig::Pose> poses;
  std::vector<std::size_t> held;  ///< frames that show no face and keep the pose before
  double fps = 0;
  bool whole_frames = false;
  std::vector<std::string> notes;         ///< what was left out or held, one line each
  std::vector<std::string> unmatched;     ///< names of the track that the model has no control for
  std::vector<std::string> nearest;       ///< a control's name for each of these; empty: none is near
  std::vector<animation::HeadTurn> head;  ///< as seen in the picture; empty for tracks of values
  std::optional<animation::RestChoice> rest;
  animation::EyeMotion eyes;
};

/// The document with an animation from tracked points or values, or from the motion of a figure. The watch is called
/// around each frame of a track of points. Precondition: the track is as its reader gave it. Errors (the place is of
/// the map where it is a JSON pointer; `blamed` takes what the error is about): an option out of its range, a model
/// without controls, a frame that the track lacks, names of the map that the track or the model lacks, a track that
/// drives no control, those of animation::animate_track and document::with_placements.
[[nodiscard]] base::Result<Animated> animate(const document::Document& document, io::Track track,
                                             const io::MapFile& map, const AnimateOptions& options = {},
                                             const animation::FrameWatch& watch = {}, AnimateInput* blamed = nullptr);

}  // namespace penpose::tracking
