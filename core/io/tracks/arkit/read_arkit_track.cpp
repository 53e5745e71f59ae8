#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "core/base/numbers.h"
#include "core/io/text/csv_reader.h"
#include "core/io/tracks/arkit/timecode.h"
#include "core/io/tracks/increasing_values.h"
#include "core/io/tracks/read_track.h"
#include "core/io/tracks/track_formats.h"
#include "core/io/tracks/track_rows.h"
#include "core/rig/control_names.h"

namespace penpose::io {
namespace {

constexpr double k_live_link_fps = 60;

std::string taken(double fps) {
  return base::format_fixed(fps, 2) + " frames a second are taken; --fps sets another rate";
}

/// Seconds on a clock that passes midnight and goes on; nothing where a row has no timecode.
std::vector<std::optional<double>> seconds_of(const std::vector<std::optional<Timecode>>& codes, double count) {
  constexpr double k_day_s = 86400;
  std::vector<std::optional<double>> times;
  double day = 0;
  double before = 0;
  for (const auto& code : codes) {
    if (!code) {
      times.emplace_back();
      continue;
    }
    const double time = code->whole_s + code->frames / count;
    if (time + day < before - k_day_s / 2) day += k_day_s;
    before = time + day;
    times.emplace_back(before);
  }
  return times;
}

/// Where rows lie in time.
struct Placed {
  std::vector<double> times;   ///< seconds from the first row, one a row
  std::vector<double> places;  ///< numbers of frames from 0, one a row; those in between are left out
};

/// Numbers of frames of rows whose times are a multiple of the usual step apart: what a take leaves out counts as well.
std::vector<double> places_of(const std::vector<std::optional<double>>& seconds, const IncreasingValues& increasing) {
  const double step = typical_step(seconds);
  std::vector<double> places(seconds.size());
  std::iota(places.begin(), places.end(), 0.0);
  std::vector<std::size_t> sure;
  std::size_t pairs = 0;
  std::size_t usual = 0;
  for (std::size_t i = 0; i < seconds.size(); ++i) {
    if (!increasing.in_order[i]) continue;
    if (!sure.empty() && sure.back() + 1 == i) {
      ++pairs;
      if (std::abs(*seconds[i] - *seconds[i - 1] - step) < step / 2) ++usual;
    }
    sure.push_back(i);
  }
  // Where fewer steps are the usual one, the rows come at a rate that the timecodes do not count, or as they please.
  if (5 * usual < 4 * pairs || pairs < 2) return places;
  double missing = 0;
  for (std::size_t k = 1; k < sure.size(); ++k) {
    const std::size_t a = sure[k - 1];
    const std::size_t b = sure[k];
    double frames = std::round((*seconds[b] - *seconds[a]) / step);
    if (k + 1 < sure.size()) {
      // A row that is late only leaves nothing out: the next one is in time.
      const std::size_t c = sure[k + 1];
      frames = std::min(frames, std::round((*seconds[c] - *seconds[a]) / step) - static_cast<double>(c - b));
    }
    for (std::size_t i = a + 1; i < b; ++i) places[i] += missing;
    missing += std::max(0.0, frames - static_cast<double>(b - a));
    places[b] += missing;
  }
  if (sure.empty()) return places;
  for (std::size_t i = sure.back() + 1; i < places.size(); ++i) places[i] += missing;
  return places;
}

/// Says in `why`, one a row, what holds a frame, and in the notes what else there is to say.
Placed place_rows(const std::vector<std::optional<Timecode>>& codes, const std::vector<std::size_t>& lines,
                  std::vector<std::string>& why, FrameNotes& notes, std::string& rate_note) {
  std::vector<Timecode> known;
  for (const auto& code : codes) {
    if (code) known.push_back(*code);
  }
  const CountedRate rate = counted_rate(known);
  const auto seconds = seconds_of(codes, rate.count);
  const IncreasingValues increasing = find_increasing(seconds);
  Placed rows;
  rows.places.resize(codes.size());
  std::iota(rows.places.begin(), rows.places.end(), 0.0);
  std::size_t first = 0;
  while (first < codes.size() && !increasing.in_order[first]) ++first;
  std::size_t last = codes.size();
  while (last > first && !increasing.in_order[last - 1]) --last;
  const auto leap = find_leap(seconds, increasing, k_longest_pause_s);
  if (leap || !increasing.trusted() || last - first < 2) {
    // Timecodes that stand still for some rows, such as those of 30 a second for 60 faces, still tell how long it took.
    const bool grow = last - first >= 2;
    const double fps = leap   ? 1 / typical_step(seconds)
                       : grow ? static_cast<double>(last - 1 - first) / (*seconds[last - 1] - *seconds[first])
                              : k_live_link_fps;
    for (const double place : rows.places) rows.times.push_back(place / fps);
    std::string what = known.empty() ? "no timecode can be read" : "the timecodes do not grow";
    if (leap) what = "the timecode leaps by far in line " + std::to_string(lines[*leap]);
    if (codes.size() > 1) rate_note = what + ": " + taken(fps);
    return rows;
  }
  if (!rate.told) rate_note = "the timecodes do not tell how many frames make a second: " + taken(rate.count);
  rows.places = places_of(seconds, increasing);
  for (std::size_t f = 0; f < codes.size(); ++f) {
    if (!codes[f]) {
      notes.add("line " + std::to_string(lines[f]) +
                ": its timecode cannot be read; the frame is placed between its neighbours");
    } else if (!increasing.in_order[f] && why[f].empty()) {
      why[f] = "its timecode does not come after the ones before";
    }
  }
  rows.times = interpolate_missing(seconds, increasing, rows.places);
  const double begin = rows.times.front();
  for (double& time : rows.times) time -= begin;
  return rows;
}

}  // namespace

base::Result<animation::WeightTrack> read_arkit_track(base::Bytes bytes) {
  auto table = CsvReader::open(base::as_text(bytes));
  if (!table) return table.error();
  const auto timecode = table->find("Timecode");
  const auto count = table->find("BlendShapeCount");
  if (!timecode) return table->error("the column Timecode is missing", "export the take as Live Link Face CSV");
  std::vector<std::size_t> columns;
  std::vector<std::string> repeated;
  std::set<std::string, std::less<>> names;
  animation::WeightTrack track;
  for (std::size_t i = 0; i < table->columns().size(); ++i) {
    if (i == *timecode || (count && i == *count) || table->columns()[i].empty()) continue;
    const std::string folded = rig::folded_name(table->columns()[i]);
    if (!names.insert(folded.empty() ? std::string(table->columns()[i]) : folded).second) {
      if (repeated.size() < 5) repeated.push_back(repeats(table->columns()[i]));
      continue;
    }
    columns.push_back(i);
    track.names.emplace_back(table->columns()[i]);
  }
  if (columns.empty()) return table->error("there is no column of a blend shape", "export the take again");
  std::vector<std::optional<Timecode>> codes;
  std::vector<std::size_t> lines;
  std::vector<std::string> why;  // one a row, as the others; empty: nothing holds it
  std::vector<std::string_view> cells;
  while (table->next(cells)) {
    if (cells.size() > table->columns().size()) {
      return table->error("the row has " + std::to_string(cells.size()) + " cells for " +
                              std::to_string(table->columns().size()) + " columns",
                          "write numbers with a decimal point, or separate the cells by semicolons");
    }
    if (track.frames.size() >= k_most_track_frames) return table->error("the take has too many frames", "cut it");
    codes.push_back(*timecode < cells.size() ? parse_timecode(cells[*timecode]) : std::nullopt);
    lines.push_back(table->line());
    std::string& held = why.emplace_back();
    animation::WeightFrame& frame = track.frames.emplace_back();
    const bool counted = !count || (*count < cells.size() && table->number(cells[*count]).value_or(0) > 0);
    if (!counted) held = "the tracker found no face";
    if (counted && cells.size() < table->columns().size()) held = "the row is short";
    for (const std::size_t c : columns) {
      if (!held.empty()) break;
      const auto value = table->number(cells[c]);
      if (!value && !cells[c].empty()) {
        std::string what = "\"";
        what += cells[c].substr(0, 20);
        what += "\" in column ";
        what += table->columns()[c];
        what += " is not a number";
        return table->error(std::move(what), "write numbers with a decimal point");
      }
      if (!value || !(std::abs(*value) < 1e6)) held = "a value is missing or no number";
      frame.values.push_back(value.value_or(0));
    }
  }
  if (std::find(why.begin(), why.end(), "") == why.end()) {
    return base::Error{"no frame shows a face: " + (why.empty() ? "the file has no frame" : why.front()),
                       "line " + std::to_string(lines.empty() ? 1 : lines.front()), "record the take again"};
  }
  FrameNotes notes;
  const Placed placed = place_rows(codes, lines, why, notes, track.rate_note);
  std::vector<animation::WeightFrame> seen = std::move(track.frames);
  track.frames.clear();
  for (std::size_t f = 0; f < seen.size(); ++f) {
    const std::string line = "line " + std::to_string(lines[f]);
    const double missing = f == 0 ? 0 : placed.places[f] - placed.places[f - 1] - 1;
    if (missing + 1 > static_cast<double>(k_most_track_frames - track.frames.size())) {
      return base::Error{"with the frames that are left out the take has more than 1,000,000", line, "cut it"};
    }
    for (double k = 1; k <= missing; ++k) {
      const double passed = placed.times[f] - placed.times[f - 1];
      track.frames.push_back({placed.times[f - 1] + passed * k / (missing + 1), false, {}});
    }
    if (missing > 0) {
      notes.add(line + ": " + std::to_string(static_cast<std::int64_t>(missing)) +
                " frames before it are left out and held");
    }
    animation::WeightFrame& frame = track.frames.emplace_back(std::move(seen[f]));
    frame.time_s = placed.times[f];
    frame.found = why[f].empty();
    if (frame.found) continue;
    frame.values.clear();
    notes.add(line + ": " + why[f] + "; the frame is held");
  }
  track.notes = notes.take();
  track.notes.insert(track.notes.begin(), repeated.begin(), repeated.end());
  return track;
}

TrackFormat arkit_format() {
  return {"arkit", 5, true, [](const TrackText& text) { return !text.json && text.has("Timecode"); },
          [](base::Bytes bytes, std::optional<PictureSize>) { return as_track(read_arkit_track(bytes)); }};
}

}  // namespace penpose::io
