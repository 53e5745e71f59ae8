#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace penpose::io {

/// H:M:S:F.f, the last part counting frames within the second.
struct Timecode {
  double whole_s = 0;
  double frames = 0;
};

/// Nothing for any other text.
[[nodiscard]] std::optional<Timecode> parse_timecode(std::string_view text);

/// How many frames a second the timecodes of a clip count: its rate where that is one of video's (29.97 counts 30, as
/// timecodes do), else 60 as Live Link Face does. Frames between those that are counted have a fraction.
[[nodiscard]] double timecode_count(double fps);

/// "HH:MM:SS:FF.fff" of a time within a day, rounded to a thousandth of a frame.
[[nodiscard]] std::string format_timecode(double time_s, double count);

/// What timecodes that follow each other count a second in, and whether they tell: where a second begins, the frame
/// before it is the last one of a second. Those that show no such place are told by their steps, as ARKit sees 60 faces
/// a second: steps of half a frame count 30. Else 60 is taken.
struct CountedRate {
  double count = 60;
  bool told = false;
};
[[nodiscard]] CountedRate counted_rate(std::span<const Timecode> codes);

}  // namespace penpose::io
