#include <algorithm>
#include <cmath>

#include "core/base/numbers.h"
#include "core/model_io/csv_reader.h"
#include "core/model_io/read_track.h"
#include "core/model_io/timecode.h"

namespace penpose::model_io {
namespace {

/// Seconds from the first row; a clock that passes midnight goes on. Empty unless every row has a timecode.
std::vector<double> times_of(const std::vector<std::optional<Timecode>>& codes) {
  std::vector<Timecode> known;
  for (const auto& code : codes) {
    if (!code) return {};
    known.push_back(*code);
  }
  const double fps = counted_rate(known).count;
  std::vector<double> times;
  double day = 0;
  for (const auto& code : codes) {
    double time = code->whole_s + code->frames / fps + day;
    if (!times.empty() && time < times.back() - 43200.0) {
      day += 86400.0;
      time += 86400.0;
    }
    // Timecodes of dropped frames may step back a little; time does not.
    times.push_back(times.empty() ? time : std::max(time, times.back()));
  }
  const double first = times.front();
  for (double& time : times) time -= first;
  return times;
}

}  // namespace

base::Result<animation::WeightTrack> read_arkit_track(base::Bytes bytes) {
  auto table = CsvReader::open(base::as_text(bytes));
  if (!table) return table.error();
  const auto timecode = table->find("Timecode");
  const auto count = table->find("BlendShapeCount");
  if (!timecode) return table->error("the column Timecode is missing", "export the take as Live Link Face CSV");
  std::vector<std::size_t> columns;
  animation::WeightTrack track;
  for (std::size_t i = 0; i < table->columns().size(); ++i) {
    if (i == *timecode || (count && i == *count) || table->columns()[i].empty()) continue;
    columns.push_back(i);
    track.names.emplace_back(table->columns()[i]);
  }
  if (columns.empty()) return table->error("there is no column of a blend shape", "export the take again");
  std::vector<std::optional<Timecode>> codes;
  std::vector<std::string_view> cells;
  bool any = false;
  while (table->next(cells)) {
    if (cells.size() > table->columns().size()) {
      return table->error("the row has " + std::to_string(cells.size()) + " cells for " +
                              std::to_string(table->columns().size()) + " columns",
                          "write numbers with a decimal point, or separate the cells by semicolons");
    }
    if (track.frames.size() >= k_most_track_frames) return table->error("the take has too many frames", "cut it");
    codes.push_back(*timecode < cells.size() ? parse_timecode(cells[*timecode]) : std::nullopt);
    animation::WeightFrame& frame = track.frames.emplace_back();
    const bool counted = !count || (*count < cells.size() && table->number(cells[*count]).value_or(0) > 0);
    std::string why = counted ? "" : "the tracker found no face";
    if (counted && cells.size() < table->columns().size()) why = "the row is short";
    for (const std::size_t c : columns) {
      if (!why.empty()) break;
      const auto value = table->number(cells[c]);
      if (!value && !cells[c].empty()) {
        std::string what = "\"";
        what += cells[c].substr(0, 20);
        what += "\" in column ";
        what += table->columns()[c];
        what += " is not a number";
        return table->error(std::move(what), "write numbers with a decimal point");
      }
      if (!value || !(std::abs(*value) < 1e6)) why = "a value is missing or no number";
      frame.values.push_back(value.value_or(0));
    }
    frame.found = why.empty();
    any = any || frame.found;
    if (frame.found) continue;
    frame.values.clear();
    constexpr std::size_t k_most_notes = 20;
    if (track.notes.size() < k_most_notes)
      track.notes.push_back("line " + std::to_string(table->line()) + ": " + why + "; the frame is held");
  }
  if (!any) return table->error("no frame shows a face", "record the take again");
  const auto times = times_of(codes);
  constexpr double k_live_link_fps = 60;
  for (std::size_t f = 0; f < track.frames.size(); ++f) {
    track.frames[f].time_s = times.empty() ? static_cast<double>(f) / k_live_link_fps : times[f];
  }
  return track;
}

}  // namespace penpose::model_io
