#include "core/io/tracks/values/value_clock.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/numbers.h"
#include "core/io/tracks/increasing_values.h"

namespace penpose::io {
namespace {

constexpr double k_day_s = 86400;

std::string taken(double fps) {
  return base::format_fixed(fps, 2) + " frames a second are taken; --stretch sets another rate";
}

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

double middle(std::vector<double> values) {
  std::stable_sort(values.begin(), values.end());
  return values.empty() ? 0 : values[values.size() / 2];
}

/// Whether what stands after the point are decimals of the second rather than frames.
bool are_decimals(const std::vector<Timecode>& codes) {
  double most = 0;
  std::vector<double> steps;  // within a second
  for (std::size_t i = 0; i < codes.size(); ++i) {
    if (!codes[i].fraction_s) return false;
    if (!codes[i].dotted && *codes[i].fraction_s > 0) return true;
    most = std::max(most, codes[i].frames);
    if (i > 0 && codes[i].whole_s == codes[i - 1].whole_s) steps.push_back(codes[i].frames - codes[i - 1].frames);
  }
  constexpr double k_frames = 60;
  constexpr double k_most_step = 2;  // hundredths of 30 frames a second have 3
  return most == 0 || most >= k_frames || middle(std::move(steps)) > k_most_step;
}

}  // namespace

void ValueClock::add(std::string_view text, std::optional<double> number) {
  codes_.push_back(parse_timecode(text));
  constexpr double k_latest = 1e19;  // nanoseconds since 1970 have 19 digits
  numbers_.push_back(number && std::abs(*number) < k_latest ? number : std::nullopt);
}

bool ValueClock::has_codes() const {
  const auto count = [](const auto& list) {
    return std::count_if(list.begin(), list.end(), [](const auto& one) { return one.has_value(); });
  };
  return count(codes_) > 0 && count(codes_) >= count(numbers_);
}

std::vector<std::optional<double>> ValueClock::seconds_of_codes(std::string& rate_note) const {
  std::vector<Timecode> known;
  for (const auto& code : codes_) {
    if (code) known.push_back(*code);
  }
  const bool decimals = are_decimals(known);
  const CountedRate rate = decimals ? CountedRate{0, true} : counted_rate(known);
  const bool drops = !decimals && leaves_out_numbers(known, rate.count);
  if (!rate.told) {
    rate_note = "the timecodes do not tell how many frames make a second: " +
                taken(drops ? rate.count * 1000 / 1001 : rate.count);
  }
  std::vector<std::optional<double>> times;
  double day = 0;
  double before = 0;
  bool first = true;
  for (const auto& code : codes_) {
    if (!code) {
      times.emplace_back();
      continue;
    }
    const double time = decimals ? code->whole_s + code->fraction_s.value_or(0) : seconds_of(*code, rate.count, drops);
    // Of a day that leaves numbers out 86.4 ms are missing.
    if (!first && time + day < before - k_day_s / 2) day += drops ? k_day_s - 0.0864 : k_day_s;
    before = time + day;
    first = false;
    times.emplace_back(before);
  }
  return times;
}

std::vector<std::optional<double>> ValueClock::seconds_of_numbers(std::string& rate_note) const {
  std::vector<std::optional<double>> times = numbers_;
  for (auto& time : times) {
    if (time && !std::isfinite(*time)) time.reset();
  }
  const double step = typical_step(times);
  const bool whole = std::all_of(times.begin(), times.end(), [](const auto& t) { return !t || *t == std::floor(*t); });
  constexpr double k_most_step = 5;
  double unit = 1;
  if (whole && step < k_most_step) {
    unit = usual_fps_;
    if (times.size() > 1 && step > 0) rate_note = "the frames are counted and have no times: " + taken(usual_fps_);
  } else {
    // No take shows a frame so rarely: they are smaller units.
    while (step / unit >= k_most_step && unit < 1e9) unit *= 1000;
  }
  for (auto& time : times) {
    if (time) *time /= unit;
  }
  return times;
}

std::vector<std::optional<double>> ValueClock::seconds(std::string& rate_note) const {
  return has_codes() ? seconds_of_codes(rate_note) : seconds_of_numbers(rate_note);
}

std::vector<bool> ValueClock::repeated() const {
  std::string ignored;
  const auto seconds = this->seconds(ignored);
  std::vector<bool> repeats(seconds.size(), false);
  if (!find_increasing(seconds).trusted()) return repeats;
  for (std::size_t r = 1; r < seconds.size(); ++r) repeats[r] = seconds[r] && seconds[r] == seconds[r - 1];
  return repeats;
}

ValueClock ValueClock::without(const std::vector<bool>& rows) const {
  ValueClock kept(usual_fps_);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (rows[r]) continue;
    kept.codes_.push_back(codes_[r]);
    kept.numbers_.push_back(numbers_[r]);
  }
  return kept;
}

PlacedRows ValueClock::place(const std::vector<std::string>& named, std::vector<std::string>& why,
                             FrameNotes& notes) const {
  PlacedRows rows;
  const std::string what_told = has_codes() ? "timecode" : "time";
  const auto seconds = this->seconds(rows.rate_note);
  const IncreasingValues increasing = find_increasing(seconds);
  rows.places.resize(seconds.size());
  std::iota(rows.places.begin(), rows.places.end(), 0.0);
  std::size_t first = 0;
  while (first < seconds.size() && !increasing.in_order[first]) ++first;
  std::size_t last = seconds.size();
  while (last > first && !increasing.in_order[last - 1]) --last;
  const auto leap = find_leap(seconds, increasing, k_longest_pause_s);
  if (leap || !increasing.trusted() || last - first < 2) {
    // Timecodes that stand still for some rows, such as those of 30 a second for 60 faces, still tell how long it took.
    const bool grow = last - first >= 2;
    const double fps = leap   ? 1 / typical_step(seconds)
                       : grow ? static_cast<double>(last - 1 - first) / (*seconds[last - 1] - *seconds[first])
                              : usual_fps_;
    for (const double place : rows.places) rows.times.push_back(place / fps);
    const bool none = std::none_of(seconds.begin(), seconds.end(), [](const auto& time) { return time.has_value(); });
    std::string what = none ? "no timecode can be read" : "the " + what_told + "s do not grow";
    if (leap) what = "the " + what_told + " leaps by far in " + named[*leap];
    rows.rate_note = seconds.size() > 1 ? what + ": " + taken(fps) : std::string();
    return rows;
  }
  rows.places = places_of(seconds, increasing);
  for (std::size_t f = 0; f < seconds.size(); ++f) {
    if (!seconds[f]) {
      notes.add(named[f] + ": its " + what_told + " cannot be read; the frame is placed between its neighbours");
    } else if (!increasing.in_order[f] && why[f].empty()) {
      why[f] = "its " + what_told + " does not come after the ones before";
    }
  }
  rows.times = interpolate_missing(seconds, increasing, rows.places);
  const double begin = rows.times.front();
  for (double& time : rows.times) time -= begin;
  return rows;
}

}  // namespace penpose::io
