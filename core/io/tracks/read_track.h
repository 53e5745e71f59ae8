#pragma once

#include <optional>

#include "core/animation/track.h"
#include "core/base/byte_reader.h"
#include "core/base/result.h"

namespace penpose::io {

// Readers of what face trackers write. A frame without a face, with confidence 0 or with numbers that are none (NaN)
// is kept as a frame that was not found, so that times stay right, and listed in the track's notes. Errors name the
// line ("line N"), or in JSON the place (JSON pointer), and are given for what holding the last value cannot repair: a
// column that is missing, text where a number was expected, more cells than columns (decimal commas between commas), no
// face at all.

/// Most frames of a track, among them those that a file leaves out.
inline constexpr std::size_t k_most_track_frames = 1'000'000;

/// How many frames of a track may be there without a word of the file, which shows so many points in all: a short text
/// could stand for hours otherwise.
[[nodiscard]] constexpr std::size_t most_gap_frames(std::size_t shown_points) { return 10'000 + shown_points / 6; }

/// OpenFace's CSV, 68 points: columns x_0..x_67 and y_0..y_67 (px), and where present frame, face_id, timestamp,
/// confidence and success. Times are seconds; those that take_small_units tells are smaller units. Blanks after commas
/// are taken, as old versions write them. Of several faces one is read as rows_of_best_face says. Frame
/// numbers that are left out between rows are frames without a face; rows out of order are treated as make_track says.
[[nodiscard]] base::Result<animation::PointTrack> read_openface_track(base::Bytes bytes);

/// The picture that normalised coordinates are shares of, px.
struct PictureSize {
  double width = 0;
  double height = 0;
};

/// MediaPipe's 468 or 478 face landmarks as CSV. Either a row a frame with columns x_0, y_0, z_0, x_1, ... (also x0 or
/// landmark_0_x; z is optional), or a row a point with columns frame, landmark (or index, id, point), x, y, z. Optional
/// columns: frame, timestamp (or time; seconds, milliseconds above 1000 a frame), confidence. Coordinates within -1..2
/// are shares of the picture, whose size has to be given or is taken as square, with a note.
[[nodiscard]] base::Result<animation::PointTrack> read_mediapipe_csv(base::Bytes bytes,
                                                                     std::optional<PictureSize> picture);
/// The same as JSON: a list of frames, or an object with "frames" and optional "fps", "width", "height", or a single
/// frame, or a frame a line. A frame is a list of points or an object with "landmarks" (or faceLandmarks,
/// face_landmarks, multi_face_landmarks, multiFaceLandmarks, points, landmark, keypoints, faces) and optional
/// "timestamp" or "time" (seconds), "timestamp_ms", "confidence"; a list of lists of points is several faces, of which
/// the largest is followed. A point is {"x", "y", "z"} or [x, y, z]. null or [] is a frame without a face.
[[nodiscard]] base::Result<animation::PointTrack> read_mediapipe_json(base::Bytes bytes,
                                                                      std::optional<PictureSize> picture);

/// 68 points (iBUG) as text: one or more blocks "version: 1 / n_points: 68 / { / x y ... / }" as .pts files have them,
/// a block a frame; or CSV with columns x_0..x_67, y_0..y_67 and optionally frame, timestamp, confidence; or CSV
/// without a header, rows of 136 numbers x0, y0, x1, y1, ...
[[nodiscard]] base::Result<animation::PointTrack> read_ibug_track(base::Bytes bytes);

/// Whether frames follow each other in time. Labelled pictures do not; their times are ignored.
enum class FrameOrder : std::uint8_t { in_time, none };

/// {"fps": 25, "frames": [{"time": s, "confidence": 1, "curves": {NAME: [[x, y], ...]}}, ...]}: curves by name, px, y
/// down. "time" and "confidence" are optional. null or {} or a frame without "curves" is a frame without a face, and so
/// is one in which a curve is missing, empty or no number. Curves that fewer than half of the frames show are left out,
/// with a note; those of other numbers of points are resampled to the first's. A curve without points in any frame is
/// an error.
[[nodiscard]] base::Result<animation::PointTrack> read_curve_track(base::Bytes bytes,
                                                                   FrameOrder order = FrameOrder::in_time);

/// Values of blend shapes by name, as trackers with ARKit's 52 write them. A table has a column a name, behind whatever
/// prefix ("blendShapes."), and may have a column of time (Timecode, timestamp, time, frame and the like), as
/// ValueClock reads it, and BlendShapeCount; or it has a row a score (frame or time, categoryName, score). Numbers may
/// have a decimal comma, also between commas where each is in two. Live Link Face, MediaPipe and Audio2Face write such
/// tables.
///
/// JSON is a list of frames, an object with "frames", one frame, or a frame a line. A frame has its scores as
/// faceBlendshapes, face_blendshapes, blendShapes, categories, weights or values: an object of numbers, a list of
/// categories ({"categoryName", "score"}), or a list of faces, of which the first counts; or as many numbers as the
/// file names shapes ("facsNames" with "weightMat" and "exportFps" of Audio2Face, "blendShapes" with
/// "blendShapeWeights" of its services); times are "timestamp", "timeCode", "time". A list a name is taken too.
///
/// Rows that are short or have a count of 0, and frames without scores, show no face; so do those whose time does not
/// come after the ones before, and those that are left out where most times are one step apart.
[[nodiscard]] base::Result<animation::WeightTrack> read_arkit_track(base::Bytes bytes);

/// Mouth cues as values over time, names "mouth cue D", of what read_cues reads: at 30 frames a second, or at 24 where
/// the file counts frames. Shapes are Rhubarb's A to H and X, or Preston Blair's AI, E ("mouth cue E."), O, U, etc, L,
/// WQ, MBP, FV and rest. One goes over into the next within 0.04 s to each side. `dictionary`: how words are said.
/// Errors: those of read_cues, over 1,000,000 frames.
[[nodiscard]] base::Result<animation::WeightTrack> read_cue_track(base::Bytes bytes, base::Bytes dictionary = {});

/// The morph keys of a MikuMikuDance motion (.vmd), a frame 1/30 s, linear between keys; names as UTF-8. Morphs that
/// stay at 0 are left out where another moves. Keys of bones, cameras and lights are left out, with a note. Errors: a
/// file that ends too soon, no morph keys, a frame past k_most_track_frames.
[[nodiscard]] base::Result<animation::WeightTrack> read_vmd_track(base::Bytes bytes);

}  // namespace penpose::io
