#include "core/io/tracks/arkit/timecode.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/base/numbers.h"

namespace penpose::io {
namespace {

constexpr double k_usual_count = 60;
constexpr double k_day_s = 86400;
constexpr std::array<double, 6> k_counts{24, 25, 30, 48, 50, 60};

void add_padded(std::int64_t number, std::string& out) {
  if (number < 10) out += '0';
  out += std::to_string(number);
}

double middle(std::vector<double> values) {
  std::stable_sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// The usual count that a count lies by, or nothing; 24 and 25 stay apart.
std::optional<double> usual_near(double count) {
  for (const double usual : k_counts) {
    if (std::abs(count - usual) < 0.02 * usual) return usual;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Timecode> parse_timecode(std::string_view text) {
  std::array<double, 4> parts{};
  for (std::size_t i = 0; i < 4; ++i) {
    // A semicolon is how timecodes that drop numbers separate the frame.
    const std::size_t end = i < 3 ? text.find_first_of(":;") : text.size();
    if (end == std::string_view::npos) return std::nullopt;
    const auto n = base::parse_double(base::trim(text.substr(0, end)));
    if (!n || !(*n >= 0) || !(*n < 1000)) return std::nullopt;
    parts[i] = *n;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return Timecode{(parts[0] * 60 + parts[1]) * 60 + parts[2], parts[3]};
}

double timecode_count(double fps) {
  for (const double count : k_counts) {
    // The rates of American television are a thousandth below what they count.
    if (fps > 0.9985 * count && fps <= count) return count;
  }
  return k_usual_count;
}

std::string format_timecode(double time_s, double count) {
  const auto a_second = static_cast<std::int64_t>(std::llround(count * 1000));
  const auto all = static_cast<std::int64_t>(std::llround(time_s * static_cast<double>(a_second)));
  const std::int64_t whole = all / a_second;
  std::string text;
  for (const std::int64_t part : {whole / 3600 % 24, whole / 60 % 60, whole % 60}) {
    add_padded(part, text);
    text += ':';
  }
  const std::int64_t frames = all % a_second;
  add_padded(frames / 1000, text);
  const std::string thousandths = std::to_string(1000 + frames % 1000);
  return text + "." + thousandths.substr(1);
}

CountedRate counted_rate(std::span<const Timecode> codes) {
  double most = 0;
  std::vector<double> steps;  // within a second
  for (std::size_t i = 0; i < codes.size(); ++i) {
    most = std::max(most, codes[i].frames);
    if (i > 0 && codes[i].whole_s == codes[i - 1].whole_s && codes[i].frames > codes[i - 1].frames)
      steps.push_back(codes[i].frames - codes[i - 1].frames);
  }
  const auto holds_all = [&](double count) { return count > most; };
  const double step = steps.empty() ? 0 : middle(steps);
  std::vector<double> seconds;
  for (std::size_t i = 1; i < codes.size() && step > 0; ++i) {
    const double passed = codes[i].whole_s - codes[i - 1].whole_s;
    if (passed == 1 || passed == 1 - k_day_s) seconds.push_back(codes[i - 1].frames + step - codes[i].frames);
  }
  if (!seconds.empty()) {
    const double seen = middle(seconds);
    const auto usual = usual_near(seen);
    if (usual && holds_all(*usual)) return {*usual, true};
    // A single second may have lost the frames at its end.
    if (seen >= 1 && holds_all(std::round(seen)) && seconds.size() > 1) return {std::round(seen), true};
  }
  for (const double count : k_counts) {
    const auto by_step = usual_near(k_usual_count * step);
    if (by_step == count && count < k_usual_count && holds_all(count)) return {count, true};
  }
  if (most >= 50 && holds_all(k_usual_count)) return {k_usual_count, true};
  return {holds_all(k_usual_count) ? k_usual_count : std::floor(most) + 1, false};
}

}  // namespace penpose::io
