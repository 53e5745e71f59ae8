#pragma once

#include <string>
#include <vector>

#include "core/animation/track.h"
#include "core/base/result.h"
#include "core/io/tracks/values/value_clock.h"

namespace penpose::io {

/// Rows of values of named controls as a file has them.
struct ValueRows {
  std::vector<std::string> names;           ///< of the values
  std::vector<std::vector<double>> values;  ///< one a name in each row; empty where the row is held
  std::vector<std::string> named;           ///< one a row, as the next: what notes call it, "line 5"
  std::vector<std::string> why;             ///< what holds it; empty: nothing
  struct Hole {
    std::size_t row = 0, name = 0;
  };
  std::vector<Hole> holes;  ///< values that a row does not tell, by rows: the one before stays
  std::vector<std::string> notes;
};

/// The most values of a track, so that a short text cannot ask for much memory.
inline constexpr std::size_t k_most_values = 50'000'000;

/// Rows in the order of the file as a track: holes are filled, of rows that repeat a time the last counts, and rows
/// that the clock finds left out are held frames. Errors: no row that shows a face, more than k_most_track_frames with
/// those that are left out.
[[nodiscard]] base::Result<animation::WeightTrack> make_value_track(ValueRows rows, const ValueClock& clock);

}  // namespace penpose::io
