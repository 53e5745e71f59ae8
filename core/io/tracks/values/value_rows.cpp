#include "core/io/tracks/values/value_rows.h"

#include <algorithm>

#include "core/io/tracks/read_track.h"

namespace penpose::io {

namespace {

/// A value that a row does not tell stays as it was; a row that tells none shows no face.
void fill_holes(ValueRows& rows) {
  if (rows.holes.empty()) return;
  std::vector<double> before(rows.names.size(), 0.0);
  std::size_t filled = 0;
  std::size_t hole = 0;
  for (std::size_t r = 0; r < rows.values.size(); ++r) {
    const std::size_t first = hole;
    while (hole < rows.holes.size() && rows.holes[hole].row == r) ++hole;
    std::vector<double>& values = rows.values[r];
    if (!rows.why[r].empty()) continue;
    if (hole - first >= rows.names.size()) {
      rows.why[r] = "the tracker found no face";
      continue;
    }
    for (std::size_t i = first; i < hole; ++i) values[rows.holes[i].name] = before[rows.holes[i].name];
    filled += hole - first;
    before = values;
  }
  if (filled > 0) rows.notes.push_back(std::to_string(filled) + " cells have no value: the one before stays");
}

/// If rows repeat a time, the last one that shows a face counts.
ValueClock without_repeats(ValueRows& rows, const ValueClock& clock) {
  const std::vector<bool> repeats = clock.repeated();
  std::size_t count = 0;
  std::string first;
  ValueRows kept;
  for (std::size_t r = 0; r < rows.values.size(); ++r) {
    if (r > 0 && repeats[r]) {
      if (count++ == 0) first = rows.named[r];
      if (rows.why[r].empty()) {
        kept.values.back() = std::move(rows.values[r]);
        kept.why.back().clear();
      }
      continue;
    }
    kept.values.push_back(std::move(rows.values[r]));
    kept.named.push_back(std::move(rows.named[r]));
    kept.why.push_back(std::move(rows.why[r]));
  }
  rows.values = std::move(kept.values);
  rows.named = std::move(kept.named);
  rows.why = std::move(kept.why);
  if (count == 0) return clock;
  rows.notes.push_back(std::to_string(count) + (count == 1 ? " row repeats" : " rows repeat") +
                       " the time of the one before, the first in " + first + ": the last counts");
  return clock.without(repeats);
}

}  // namespace

base::Result<animation::WeightTrack> make_value_track(ValueRows rows, const ValueClock& told) {
  fill_holes(rows);
  const ValueClock clock = without_repeats(rows, told);
  if (std::find(rows.why.begin(), rows.why.end(), "") == rows.why.end()) {
    return base::Error{"no frame shows a face: " + (rows.why.empty() ? "the file has no frame" : rows.why.front()),
                       rows.named.empty() ? "line 1" : rows.named.front(), "record the take again"};
  }
  animation::WeightTrack track;
  track.names = std::move(rows.names);
  FrameNotes notes;
  PlacedRows placed = clock.place(rows.named, rows.why, notes);
  track.rate_note = std::move(placed.rate_note);
  for (std::size_t f = 0; f < rows.values.size(); ++f) {
    const double missing = f == 0 ? 0 : placed.places[f] - placed.places[f - 1] - 1;
    if (missing + 1 > static_cast<double>(k_most_track_frames - track.frames.size())) {
      return base::Error{"with the frames that are left out the take has more than 1,000,000", rows.named[f], "cut it"};
    }
    for (double k = 1; k <= missing; ++k) {
      const double passed = placed.times[f] - placed.times[f - 1];
      track.frames.push_back({placed.times[f - 1] + passed * k / (missing + 1), false, {}});
    }
    if (missing > 0) {
      notes.add(rows.named[f] + ": " + std::to_string(static_cast<std::int64_t>(missing)) +
                " frames before it are left out and held");
    }
    animation::WeightFrame& frame = track.frames.emplace_back();
    frame.time_s = placed.times[f];
    frame.found = rows.why[f].empty();
    if (frame.found) frame.values = std::move(rows.values[f]);
    if (!frame.found) notes.add(rows.named[f] + ": " + rows.why[f] + "; the frame is held");
  }
  track.notes = notes.take();
  track.notes.insert(track.notes.begin(), rows.notes.begin(), rows.notes.end());
  return track;
}

}  // namespace penpose::io
