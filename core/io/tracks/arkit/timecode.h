#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace penpose::io {

/// A moment as takes write it: frames within a second, or decimals of it.
struct Timecode {
  double whole_s = 0;
  double frames = 0;
  /// Written as timecodes are that leave out numbers (SMPTE ST 12-1, drop-frame): ";" or "." before the frames.
  bool drops = false;
  /// After "." come one or two digits, which may be frames or decimals of the second.
  bool dotted = false;
  std::optional<double> fraction_s = std::nullopt;  ///< what stands after the point of seconds, 0..1
};

/// H:M:S:F.f, H:M:S;F, H:M:S.F, H.M.S.F, or H:M:S.sss and M:S.sss, where three digits or more are decimals of the
/// second. A comma stands for any of these points. Nothing for any other text.
[[nodiscard]] std::optional<Timecode> parse_timecode(std::string_view text);

/// How many frames a second the timecodes of a clip count: its rate where that is one of video's (29.97 counts 30, as
/// timecodes do), else 60 as Live Link Face does. Frames between those that are counted have a fraction.
[[nodiscard]] double timecode_count(double fps);

/// "HH:MM:SS:FF.fff" of a time within a day, rounded to a thousandth of a frame.
[[nodiscard]] std::string format_timecode(double time_s, double count);

/// What timecodes that follow each other count a second in, and whether they tell: where a second begins, the frame
/// before it is the last one of a second. Those that show no such place are told by their steps, as ARKit sees 60 faces
/// a second: steps of half a frame count 30. Else 60 is taken, or 30 of timecodes that leave out numbers. Decimals of
/// seconds are not looked at.
struct CountedRate {
  double count = 60;
  bool told = false;
};
[[nodiscard]] CountedRate counted_rate(std::span<const Timecode> codes);

/// Whether timecodes that count `count` a second leave out the first numbers of each minute but every tenth, as 29.97
/// and 59.94 frames a second do: most are written so, and none has a number that would be left out.
[[nodiscard]] bool leaves_out_numbers(std::span<const Timecode> codes, double count);

/// Seconds from midnight of a timecode that counts `count` a second; `drops`: as leaves_out_numbers says. Then frame
/// number = (whole_s * count + frames) - d (m - m / 10), m whole minutes and d 2 of 30 or 4 of 60, at count * 1000 /
/// 1001 frames a second (SMPTE ST 12-1).
[[nodiscard]] double seconds_of(const Timecode& code, double count, bool drops);

}  // namespace penpose::io
