#include "core/model_io/track_rows.h"

#include <algorithm>
#include <cmath>

#include "core/model_io/read_track.h"

namespace penpose::model_io {
namespace {

/// Whether the file's frame numbers say where each row belongs.
bool numbers_grow(const std::vector<TrackRow>& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].frame || (i > 0 && *rows[i].frame <= *rows[i - 1].frame)) return false;
  }
  return true;
}

/// Seconds a frame by the rows' own times; 0 where they have none that grow.
double frame_time(const std::vector<TrackRow>& rows, bool numbered) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].time_s || (i > 0 && !(*rows[i].time_s > *rows[i - 1].time_s))) return 0;
  }
  if (rows.size() < 2) return 0;
  const double frames =
      numbered ? static_cast<double>(*rows.back().frame - *rows.front().frame) : static_cast<double>(rows.size() - 1);
  return (*rows.back().time_s - *rows.front().time_s) / frames;
}

constexpr std::size_t k_most_notes = 20;

}  // namespace

void take_milliseconds(std::vector<TrackRow>& rows) {
  if (rows.size() < 2 || !rows.front().time_s || !rows.back().time_s) return;
  const double step = (*rows.back().time_s - *rows.front().time_s) / static_cast<double>(rows.size() - 1);
  if (step < 5) return;
  for (TrackRow& row : rows) {
    if (row.time_s) *row.time_s /= 1000.0;
  }
}

base::Result<animation::PointTrack> make_track(std::vector<TrackRow> rows, std::size_t point_count, double fps,
                                               RowName name) {
  const auto place = [&](const TrackRow& row) {
    return (name == RowName::line ? "line " : "frame ") + std::to_string(row.line);
  };
  const bool any = std::any_of(rows.begin(), rows.end(), [](const TrackRow& row) { return row.why_held.empty(); });
  if (!any) {
    const std::string why = rows.empty() ? "the file has no frame" : rows.front().why_held;
    return base::Error{"no frame shows a face: " + why, rows.empty() ? "" : place(rows.front()),
                       "track the video again"};
  }
  animation::PointTrack track;
  track.point_count = point_count;
  const bool numbered = numbers_grow(rows);
  const double own = frame_time(rows, numbered);
  const double step = own > 0 ? own : 1.0 / (fps > 0 ? fps : k_common_fps);
  std::size_t held = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    TrackRow& row = rows[i];
    if (numbered && i > 0) {
      const auto missing = static_cast<std::uint64_t>(*row.frame) - static_cast<std::uint64_t>(*rows[i - 1].frame) - 1;
      if (missing > k_most_track_frames - std::min(k_most_track_frames, track.frames.size())) {
        return base::Error{"frames are left out up to frame " + std::to_string(*row.frame), place(row),
                           "a track has at most 1,000,000 frames"};
      }
      const double before = track.frames.back().time_s;
      for (std::uint64_t k = 1; k <= missing; ++k) {
        animation::TrackFrame gap;
        gap.time_s = before + step * static_cast<double>(k);
        track.frames.push_back(std::move(gap));
      }
      if (missing > 0 && track.notes.size() < k_most_notes) {
        track.notes.push_back(place(row) + ": " + std::to_string(missing) + " frames before frame " +
                              std::to_string(*row.frame) + " are left out and held");
      }
    }
    if (track.frames.size() >= k_most_track_frames) {
      return base::Error{"a track has at most 1,000,000 frames", place(row), "cut the video"};
    }
    animation::TrackFrame frame;
    frame.time_s = own > 0 ? *row.time_s : step * static_cast<double>(track.frames.size());
    if (!track.frames.empty()) frame.time_s = std::max(frame.time_s, track.frames.back().time_s);
    if (row.why_held.empty()) {
      frame.confidence = std::clamp(row.confidence, 0.0, 1.0);
      frame.points = std::move(row.points);
      frame.depths = std::move(row.depths);
      frame.rotation = row.rotation;
    } else if (++held <= k_most_notes) {
      track.notes.push_back(place(row) + ": " + row.why_held + "; the frame is held");
    }
    track.frames.push_back(std::move(frame));
  }
  if (held > k_most_notes) {
    track.notes.push_back("and " + std::to_string(held - k_most_notes) + " frames more are held");
  }
  return track;
}

}  // namespace penpose::model_io
