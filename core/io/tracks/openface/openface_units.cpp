#include "core/io/tracks/openface/openface_units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/text/letters.h"
#include "core/io/tracks/read_track.h"
#include "core/io/tracks/values/value_rows.h"

namespace penpose::io {
namespace {

constexpr double k_most_intensity = 5;

/// "AU12" of AU12_r, and what stands behind it: 'r', 'c' or nothing (0). No unit: an empty name.
struct UnitName {
  std::string name;
  char kind = 0;
};

UnitName unit_of(std::string_view column) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (column.size() < 4 || base::lower(column[0]) != 'a' || base::lower(column[1]) != 'u') return {};
  if (!is_digit(column[2]) || !is_digit(column[3])) return {};
  UnitName unit{"AU" + std::string(column.substr(2, 2)), 0};
  if (column.size() == 4) return unit;
  unit.kind = base::lower(column.back());
  return column.size() == 6 && column[4] == '_' && (unit.kind == 'r' || unit.kind == 'c') ? unit : UnitName{};
}

/// One value of the track: where it is read and what it is multiplied with.
struct Source {
  std::size_t column = 0;
  double factor = 1;
  bool unit = true;  ///< else a turn
};

}  // namespace

bool has_units(const CsvReader& table) {
  return std::any_of(table.columns().begin(), table.columns().end(),
                     [](std::string_view column) { return !unit_of(column).name.empty(); });
}

base::Result<animation::WeightTrack> read_openface_units(base::Bytes bytes) {
  auto table = CsvReader::open(base::as_text(bytes));
  if (!table) return table.error();
  std::map<std::string, std::pair<char, Source>, std::less<>> units;
  for (std::size_t c = 0; c < table->columns().size(); ++c) {
    const UnitName unit = unit_of(table->columns()[c]);
    if (unit.name.empty()) continue;
    const Source source{c, unit.kind == 'r' ? 1 / k_most_intensity : 1.0, true};
    const auto [at, is_new] = units.try_emplace(unit.name, unit.kind, source);
    // How strong a unit is says more than whether it is there.
    if (!is_new && at->second.first == 'c' && unit.kind != 'c') at->second = {unit.kind, source};
  }
  if (units.empty()) return table->error("there is no column of an action unit", "run FeatureExtraction with -aus");
  ValueRows rows;
  std::vector<Source> sources;
  std::vector<std::size_t> bare;  // units whose column does not say what it counts to
  for (const auto& [name, unit] : units) {
    if (unit.first == 0) bare.push_back(sources.size());
    rows.names.push_back(name);
    sources.push_back(unit.second);
  }
  constexpr std::array<std::pair<const char*, const char*>, 3> k_turns{
      {{"pose_Rx", "HeadPitch"}, {"pose_Ry", "HeadYaw"}, {"pose_Rz", "HeadRoll"}}};
  for (std::size_t axis = 0; axis < k_turns.size(); ++axis) {
    const auto column = table->find(k_turns[axis].first);
    if (!column) continue;
    rows.names.emplace_back(k_turns[axis].second);
    sources.push_back({*column, axis == 0 ? 1.0 : -1.0, false});
  }
  const auto success = table->find("success");
  const auto confidence = table->find("confidence");
  const auto face = table->find("face_id");
  auto time = table->find("timestamp");
  if (!time) time = table->find("time");
  if (!time) time = table->find("frame");
  ValueClock when(k_common_fps);
  std::vector<std::string_view> cells;
  std::optional<double> followed;
  bool several = false;
  while (table->next(cells)) {
    if (cells.size() > table->columns().size()) {
      return table->error("the row has more cells than columns", "write numbers with a decimal point");
    }
    if (rows.values.size() >= k_most_track_frames) return table->error("the track has too many frames", "cut it");
    if (rows.values.size() * rows.names.size() > k_most_values) return table->error("the track is too long", "cut it");
    const auto at = [&](std::optional<std::size_t> column) -> std::optional<double> {
      return column && *column < cells.size() ? table->number(cells[*column]) : std::nullopt;
    };
    const auto id = at(face);
    if (id && !followed) followed = id;
    if (id && *id != *followed) {
      several = true;
      continue;
    }
    when.add("", at(time));
    rows.named.push_back("line " + std::to_string(table->line()));
    std::string& why = rows.why.emplace_back();
    if (success && !(at(success).value_or(0) > 0)) why = "the tracker found no face";
    if (why.empty() && confidence && !(at(confidence).value_or(0) > 0)) why = "the tracker's confidence is 0";
    auto& values = rows.values.emplace_back();
    for (const Source& source : sources) {
      const std::string_view cell = source.column < cells.size() ? cells[source.column] : std::string_view();
      const auto value = table->number(cell);
      if (!value && !cell.empty()) {
        return table->error("\"" + std::string(cell.substr(0, 20)) + "\" in column " +
                                std::string(table->columns()[source.column]) + " is not a number",
                            "write numbers with a decimal point");
      }
      if (why.empty() && (!value || !(std::abs(*value) < 1e6))) why = "a value is missing or no number";
      values.push_back(value.value_or(0) * source.factor);
    }
  }
  bool counts_to_five = false;
  for (const auto& values : rows.values) {
    for (const std::size_t i : bare) counts_to_five = counts_to_five || values[i] > 1;
  }
  for (auto& values : rows.values) {
    for (const std::size_t i : bare) values[i] /= counts_to_five ? k_most_intensity : 1;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (sources[i].unit) values[i] = std::clamp(values[i], 0.0, 1.0);
    }
  }
  if (several) rows.notes.emplace_back("several faces are seen; the first is followed");
  return make_value_track(std::move(rows), when);
}

}  // namespace penpose::io
