#include "core/io/tracks/track_rows.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/numbers.h"
#include "core/io/tracks/increasing_values.h"
#include "core/io/tracks/read_track.h"

namespace penpose::io {
namespace {

constexpr std::size_t k_most_notes = 20;

}  // namespace

void FrameNotes::add(std::string note) {
  if (++count_ <= k_most_notes) notes_.push_back(std::move(note));
}

std::vector<std::string> FrameNotes::take() {
  if (count_ > k_most_notes)
    notes_.push_back("and " + std::to_string(count_ - k_most_notes) + " frames more like these");
  return std::move(notes_);
}

namespace {

std::vector<std::optional<double>> times_in(const std::vector<TrackRow>& rows) {
  std::vector<std::optional<double>> times;
  for (const TrackRow& row : rows) {
    times.push_back(row.time_s && std::isfinite(*row.time_s) ? row.time_s : std::nullopt);
  }
  return times;
}

}  // namespace

void take_small_units(std::vector<TrackRow>& rows) {
  double step = typical_step(times_in(rows));
  double unit = 1;
  for (; step >= 5 && unit < 1e9; step /= 1000.0) unit *= 1000.0;
  if (unit == 1) return;
  for (TrackRow& row : rows) {
    if (row.time_s) *row.time_s /= unit;
  }
}

namespace {

std::string text_of(const TrackRow& row, RowName name) {
  return (name == RowName::line ? "line " : "frame ") + std::to_string(row.line);
}

/// Whether all that are there are the same: a column that was never filled.
bool says_nothing(std::span<const std::optional<double>> values) {
  const auto differs = [&](const auto& value) { return value && value != values.front(); };
  return values.empty() || std::none_of(values.begin(), values.end(), differs);
}

/// Rows a second: by the usual step of their times, else `fps`.
double typical_rate(const std::vector<TrackRow>& rows, double fps) {
  const double step = typical_step(times_in(rows));
  return step > 0 ? 1 / step : fps > 0 ? fps : k_common_fps;
}

/// Leaves out rows whose frame numbers come again or step back. Returns whether the numbers say where a row belongs.
bool take_numbers(std::vector<TrackRow>& rows, double fps, RowName name, FrameNotes& notes) {
  std::vector<std::optional<double>> numbers;
  for (const TrackRow& row : rows) {
    numbers.push_back(row.frame ? std::optional(static_cast<double>(*row.frame)) : std::nullopt);
  }
  const IncreasingValues increasing = find_increasing(numbers);
  if (increasing.known < rows.size() || says_nothing(numbers)) return rows.size() == 1 && increasing.known == 1;
  const auto out_of_order = std::find(increasing.in_order.begin(), increasing.in_order.end(), false);
  const auto first = static_cast<std::size_t>(out_of_order - increasing.in_order.begin());
  if (!increasing.trusted()) {
    notes.add(text_of(rows[first], name) + ": the frame numbers do not grow; rows are taken one after the other");
    return false;
  }
  // Without times numbers count frames; with times they count what they do.
  const double a_row = typical_step(times_in(rows)) > 0 ? typical_step(numbers) : 1;
  const double least = k_longest_pause_s * typical_rate(rows, fps) * a_row;
  if (const auto leap = find_leap(numbers, increasing, least)) {
    notes.add(text_of(rows[*leap], name) + ": the frame number leaps to " + std::to_string(*rows[*leap].frame) +
              "; rows are taken one after the other");
    return false;
  }
  if (out_of_order == increasing.in_order.end()) return true;
  std::vector<TrackRow> kept;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (increasing.in_order[i]) {
      kept.push_back(std::move(rows[i]));
    } else {
      notes.add(text_of(rows[i], name) + ": frame " + std::to_string(*rows[i].frame) +
                " comes again or out of order; the row is skipped");
    }
  }
  rows = std::move(kept);
  return true;
}

/// One time a row. `places`: the rows' frames. Rows out of order of time are held unless `numbered`.
std::vector<double> take_times(std::vector<TrackRow>& rows, std::span<const double> places, bool numbered, double fps,
                               RowName name, FrameNotes& notes, std::string& rate_note) {
  const auto times = times_in(rows);
  const IncreasingValues increasing = find_increasing(times);
  // A few rows may be anything, such as pictures of a story.
  const auto leap = rows.size() < 10 ? std::nullopt : find_leap(times, increasing, k_longest_pause_s);
  if (leap || !increasing.trusted() || increasing.known - increasing.out_of_order < 2) {
    const double rate = leap ? typical_rate(rows, fps) : fps > 0 ? fps : k_common_fps;
    if (increasing.known > 0 && !says_nothing(times)) {
      std::string why = increasing.out_of_order > 0 ? "the times do not grow" : "most times are missing";
      if (leap) why = "the time leaps by far in " + text_of(rows[*leap], name);
      rate_note = why + ": " + base::format_fixed(rate, 2) + " frames a second are taken; --stretch sets another rate";
    }
    std::vector<double> even;
    for (const double place : places) even.push_back(place / rate);
    return even;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (increasing.in_order[i] || !times[i]) continue;
    const char* what = "its time does not come after the ones before";
    if (numbered) {
      notes.add(text_of(rows[i], name) + ": " + what + "; it is placed by its frame number");
    } else if (rows[i].why_held.empty()) {
      rows[i].why_held = what;
    }
  }
  return interpolate_missing(times, increasing, places);
}

}  // namespace

base::Result<animation::PointTrack> make_track(std::vector<TrackRow> rows, std::size_t point_count, double fps,
                                               RowName name) {
  const bool any = std::any_of(rows.begin(), rows.end(), [](const TrackRow& row) { return row.why_held.empty(); });
  if (!any) {
    const std::string why = rows.empty() ? "the file has no frame" : rows.front().why_held;
    return base::Error{"no frame shows a face: " + why,
                       rows.empty() ? (name == RowName::line ? "line 1" : "") : text_of(rows.front(), name),
                       "track the video again"};
  }
  animation::PointTrack track;
  track.point_count = point_count;
  FrameNotes notes;
  const bool numbered = take_numbers(rows, fps, name, notes);
  std::vector<double> places;
  for (const TrackRow& row : rows) {
    places.push_back(numbered ? static_cast<double>(*row.frame - *rows.front().frame)
                              : static_cast<double>(places.size()));
  }
  const auto times = take_times(rows, places, numbered, fps, name, notes, track.rate_note);
  std::size_t shown = 0;
  double gaps = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    shown += rows[i].points.size();
    if (i > 0) gaps += places[i] - places[i - 1] - 1;
    // A frame of a list may be a word alone, a line has its cells.
    if (name == RowName::frame && !rows[i].why_held.empty()) ++gaps;
  }
  if (gaps > static_cast<double>(most_gap_frames(shown))) {
    return base::Error{"far more frames show no face than frames show one: " +
                           std::to_string(static_cast<std::int64_t>(gaps)) + " are left out or empty",
                       "", "cut the video to where the face is, and track it again"};
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    TrackRow& row = rows[i];
    const double missing = i == 0 ? 0 : places[i] - places[i - 1] - 1;
    if (missing > static_cast<double>(k_most_track_frames - track.frames.size())) {
      return base::Error{"frames are left out up to frame " + std::to_string(*row.frame), text_of(row, name),
                         "a track has at most 1,000,000 frames"};
    }
    for (double k = 1; k <= missing; ++k) {
      animation::TrackFrame gap;
      gap.time_s = times[i - 1] + (times[i] - times[i - 1]) * k / (missing + 1);
      track.frames.push_back(std::move(gap));
    }
    if (missing > 0) {
      notes.add(text_of(row, name) + ": " + std::to_string(static_cast<std::int64_t>(missing)) +
                " frames before frame " + std::to_string(*row.frame) + " are left out and held");
    }
    if (track.frames.size() >= k_most_track_frames) {
      return base::Error{"a track has at most 1,000,000 frames", text_of(row, name), "cut the video"};
    }
    animation::TrackFrame frame;
    frame.time_s = times[i];
    if (row.why_held.empty()) {
      frame.confidence = std::clamp(row.confidence, 0.0, 1.0);
      frame.points = std::move(row.points);
      frame.depths = std::move(row.depths);
      frame.rotation = row.rotation;
      frame.says = std::move(row.says);
    } else {
      notes.add(text_of(row, name) + ": " + row.why_held + "; the frame is held");
      frame.why_held = std::move(row.why_held);
    }
    track.frames.push_back(std::move(frame));
  }
  track.notes = notes.take();
  return track;
}

base::Result<animation::PointTrack> noted(base::Result<animation::PointTrack> track,
                                          std::span<const std::string> notes) {
  if (track) track->notes.insert(track->notes.begin(), notes.begin(), notes.end());
  return track;
}

}  // namespace penpose::io
