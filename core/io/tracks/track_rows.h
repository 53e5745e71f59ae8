#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/animation/track.h"
#include "core/base/result.h"

namespace penpose::io {

/// One row of a table of points, as read: what a file says of one face in one frame.
struct TrackRow {
  std::size_t line = 0;
  std::optional<std::int64_t> frame;  ///< the file's own number
  std::optional<double> time_s;
  double confidence = 1;
  std::string why_held;                    ///< not empty: the row shows no face, and why
  std::vector<animation::PxPoint> points;  ///< empty where held
  std::vector<double> depths;              ///< or empty
  std::optional<glm::dmat3> rotation;      ///< of the head, as TrackFrame
  animation::TrackerSays says = {};
};

/// Notes on single frames: the first of them, and how many more there are.
class FrameNotes {
 public:
  void add(std::string note);
  [[nodiscard]] std::vector<std::string> take();

 private:
  std::vector<std::string> notes_;
  std::size_t count_ = 0;
};

/// What `line` counts: lines from 1, or frames of a list from 0.
enum class RowName : std::uint8_t { line, frame };

/// Puts rows in the order of the file into a track. Frames whose numbers are left out are filled with frames that show
/// no face. Rows whose number comes again or steps back are skipped; rows whose time does are placed by their number,
/// or held where they have none. Numbers or times of which many do so are not gone by, nor are those of which one leaps
/// away (find_leap, by more than 10 s): then rows follow each other, and `fps` or the usual step tells the times. All
/// of that is noted. Errors: no row with a face, more frames than k_most_track_frames, and far more of them without a
/// face that the file says nothing of than most_gap_frames.
[[nodiscard]] base::Result<animation::PointTrack> make_track(std::vector<TrackRow> rows, std::size_t point_count,
                                                             double fps, RowName name = RowName::line);

/// The track, if there is one, with what was noted before it was made.
[[nodiscard]] base::Result<animation::PointTrack> noted(base::Result<animation::PointTrack> track,
                                                        std::span<const std::string> notes);

/// Divides times by 1000 as long as their usual step is 5 a row or more: no video shows a frame so rarely, they are
/// milliseconds, or micro- or nanoseconds.
void take_small_units(std::vector<TrackRow>& rows);

/// A face may be gone for this long in any file, s; for longer only if the gap is not out of proportion (find_leap).
inline constexpr double k_longest_pause_s = 10;

/// Frame rate of a track whose file says nothing of time.
inline constexpr double k_common_fps = 30;

}  // namespace penpose::io
