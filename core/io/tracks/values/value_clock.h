#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/tracks/arkit/timecode.h"
#include "core/io/tracks/track_rows.h"

namespace penpose::io {

/// Where the rows of a take lie in time.
struct PlacedRows {
  std::vector<double> times;   ///< seconds from the first row, one a row
  std::vector<double> places;  ///< numbers of frames from 0, one a row; those in between are left out
  std::string rate_note;       ///< the assumed rate, where the rows do not tell it
};

/// Tells when rows of values were seen, from what they say of it: timecodes (parse_timecode), drop-frame ones among
/// them; seconds; numbers whose usual step is 5 or more, which are milli-, micro- or nanoseconds; whole numbers of a
/// smaller step, which count frames. Rows that say nothing lie between their neighbours.
class ValueClock {
 public:
  /// `usual_fps`: of frames that are counted and of rows that say nothing.
  explicit ValueClock(double usual_fps) : usual_fps_(usual_fps) {}

  /// One a row, in their order. `number`: the text as a number in the file's own way of writing.
  void add(std::string_view text, std::optional<double> number);
  /// Which rows repeat the time of the one before them; none where the times are not gone by.
  [[nodiscard]] std::vector<bool> repeated() const;
  /// The same clock without some rows.
  [[nodiscard]] ValueClock without(const std::vector<bool>& rows) const;
  /// `named`: what rows are called in notes, "line 5", one a row. Says in `why`, one a row, what holds a frame, and in
  /// `notes` what else there is to say.
  [[nodiscard]] PlacedRows place(const std::vector<std::string>& named, std::vector<std::string>& why,
                                 FrameNotes& notes) const;

 private:
  /// Seconds on a clock that passes midnight and goes on; nothing where a row says nothing.
  [[nodiscard]] std::vector<std::optional<double>> seconds(std::string& rate_note) const;
  [[nodiscard]] std::vector<std::optional<double>> seconds_of_codes(std::string& rate_note) const;
  [[nodiscard]] std::vector<std::optional<double>> seconds_of_numbers(std::string& rate_note) const;
  [[nodiscard]] bool has_codes() const;

  double usual_fps_;
  std::vector<std::optional<Timecode>> codes_;
  std::vector<std::optional<double>> numbers_;
};

}  // namespace penpose::io
