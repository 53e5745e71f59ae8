#include "core/io/tracks/values/value_rows.h"

#include <algorithm>

#include "core/io/tracks/read_track.h"

namespace penpose::io {

base::Result<animation::WeightTrack> make_value_track(ValueRows rows, const ValueClock& clock) {
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
