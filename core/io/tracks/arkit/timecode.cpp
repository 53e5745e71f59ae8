#include "core/io/tracks/arkit/timecode.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/base/numbers.h"

namespace penpose::io {
namespace {

constexpr double k_usual_count = 60;
constexpr double k_timecode_day_s = 86400;
constexpr double k_dropped_count = 30;
constexpr std::array<double, 6> k_counts{24, 25, 30, 48, 50, 60};

void add_padded(std::int64_t number, std::string& out) {
  if (number < 10) out += '0';
  out += std::to_string(number);
}

double middle_offset(std::vector<double> values) {
  std::stable_sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// How many numbers are left out where the highest frame, or the count, is as given.
double dropped(double most) { return most > k_dropped_count ? 4 : 2; }

bool begins_short_minute(const Timecode& code) {
  const auto whole = static_cast<std::int64_t>(code.whole_s);
  return whole % 60 == 0 && whole % 600 != 0;
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
  text = base::trim(text);
  std::array<std::string_view, 5> parts;
  std::array<char, 5> signs{};  // before each part
  std::size_t count = 0;
  std::size_t colons = 0;
  while (true) {
    if (count == parts.size()) return std::nullopt;
    const std::size_t end = std::min(text.find_first_of(":;.,"), text.size());
    parts[count++] = base::trim(text.substr(0, end));
    if (end == text.size()) break;
    if (count == parts.size()) return std::nullopt;
    signs[count] = text[end];
    if (text[end] == ':' || text[end] == ';') ++colons;
    text.remove_prefix(end + 1);
  }
  std::array<double, 5> numbers{};
  for (std::size_t i = 0; i < count; ++i) {
    const bool digits = !parts[i].empty() && parts[i].find_first_not_of("0123456789") == std::string_view::npos;
    const auto n = digits && parts[i].size() <= 15 ? base::parse_double(parts[i]) : std::nullopt;
    if (!n) return std::nullopt;
    numbers[i] = *n;
  }
  const auto is_point = [&](std::size_t i) { return signs[i] == '.' || signs[i] == ','; };
  const auto decimals = [&](std::size_t i) {
    double share = numbers[i];
    for (std::size_t k = 0; k < parts[i].size(); ++k) share /= 10;
    return share;
  };
  const std::size_t last = count - 1;
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_point(i) && !(numbers[i] < 1000)) return std::nullopt;
  }
  Timecode code;
  if ((colons == 3 && (count == 4 || (count == 5 && is_point(4)))) || (colons == 0 && count == 4)) {
    code.whole_s = (numbers[0] * 60 + numbers[1]) * 60 + numbers[2];
    code.frames = numbers[3] + (count == 5 ? decimals(4) : 0);
    code.drops = signs[3] == ';' || is_point(3);
    return code.frames < 1000 ? std::optional(code) : std::nullopt;
  }
  const bool pointed = count == colons + 2 && is_point(last);
  if ((colons != 1 && colons != 2) || (count != colons + 1 && !pointed)) return std::nullopt;
  const double minutes = colons == 1 ? numbers[0] : numbers[0] * 60 + numbers[1];
  code.whole_s = minutes * 60 + numbers[colons];
  if (!pointed) {
    if (colons == 1) return std::nullopt;
    code.fraction_s = 0;
    return code;
  }
  code.fraction_s = decimals(last);
  code.dotted = colons == 2 && parts[last].size() <= 2;
  if (code.dotted) code.frames = numbers[last];
  code.drops = code.dotted;
  return code;
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
  const double step = steps.empty() ? 0 : middle_offset(steps);
  std::vector<double> seconds;
  for (std::size_t i = 1; i < codes.size() && step > 0; ++i) {
    const double passed = codes[i].whole_s - codes[i - 1].whole_s;
    const double left_out = codes[i].drops && begins_short_minute(codes[i]) ? dropped(most) : 0;
    if (passed == 1 || passed == 1 - k_timecode_day_s)
      seconds.push_back(codes[i - 1].frames + step - codes[i].frames + left_out);
  }
  if (!seconds.empty()) {
    const double seen = middle_offset(seconds);
    const auto usual = usual_near(seen);
    if (usual && holds_all(*usual)) return {*usual, true};
    // A single second may have lost the frames at its end.
    if (seen >= 1 && holds_all(std::round(seen)) && seconds.size() > 1) return {std::round(seen), true};
  }
  const bool drops = std::any_of(codes.begin(), codes.end(), [](const Timecode& code) { return code.drops; });
  if (drops && holds_all(k_dropped_count)) return {k_dropped_count, false};
  for (const double count : k_counts) {
    const auto by_step = usual_near(k_usual_count * step);
    if (by_step == count && count < k_usual_count && holds_all(count)) return {count, true};
  }
  if (most >= 50 && holds_all(k_usual_count)) return {k_usual_count, true};
  return {holds_all(k_usual_count) ? k_usual_count : std::floor(most) + 1, false};
}

bool leaves_out_numbers(std::span<const Timecode> codes, double count) {
  if (count != k_dropped_count && count != k_usual_count) return false;
  std::size_t written = 0;
  for (const Timecode& code : codes) {
    if (!code.drops) continue;
    ++written;
    if (begins_short_minute(code) && code.frames < dropped(count)) return false;
  }
  return 2 * written > codes.size();
}

double seconds_of(const Timecode& code, double count, bool drops) {
  if (!drops) return code.whole_s + code.frames / count;
  const auto minutes = static_cast<std::int64_t>(code.whole_s) / 60;
  const double number =
      code.whole_s * count + code.frames - dropped(count) * static_cast<double>(minutes - minutes / 10);
  return number * 1001 / (count * 1000);
}

}  // namespace penpose::io
