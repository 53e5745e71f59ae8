#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "core/animation/track.h"
#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/io/text/csv_reader.h"
#include "core/io/tracks/motion_track.h"
#include "core/io/tracks/read_track.h"

namespace penpose::io {

/// What trackers write: points seen in pictures, values of controls by name, or how bones and a face move.
using Track = std::variant<animation::PointTrack, animation::WeightTrack, MotionTrack>;

/// The text of a track as its formats are told apart by.
struct TrackText {
  std::string_view text;
  bool json = false;               ///< rather than a table
  std::optional<CsvReader> table;  ///< where the text is one

  explicit TrackText(base::Bytes bytes);
  [[nodiscard]] bool has(std::string_view column) const { return table && table->find(column).has_value(); }
  /// Near its beginning.
  [[nodiscard]] bool mentions(std::string_view word) const;
};

/// Whether the text is JSON rather than a table.
[[nodiscard]] bool looks_like_json(base::Bytes bytes);

/// A format of tracked faces: what the program knows of it beside the file of its map, which lies beside its reader.
struct TrackFormat {
  std::string_view name;  ///< as maps, --map and the file of its map name it
  int place;              ///< among the others, ascending, in which they are named and tried
  bool has_values;        ///< of controls by name: a map needs no curves
  bool (*looks_like)(const TrackText& text);
  base::Result<Track> (*read)(base::Bytes bytes, std::optional<PictureSize> picture);
  /// The same where words are spoken by a dictionary (speech::said_list); null: the format has no words.
  base::Result<Track> (*read_said)(base::Bytes bytes, base::Bytes dictionary) = nullptr;
};

template <typename Read>
base::Result<Track> as_track(base::Result<Read> read) {
  if (!read) return read.error();
  return Track(std::move(read).value());
}

/// All formats, in the order in which they are named and tried.
[[nodiscard]] std::span<const TrackFormat> track_formats();

/// The names of all formats, "a, b or c" with `before_last` "or".
[[nodiscard]] std::string track_format_names(std::string_view before_last);

/// Null where there is no format of that name.
[[nodiscard]] const TrackFormat* track_format_named(std::string_view name);

/// Which format a track looks to be of: by the columns of a table or by the shape of JSON. Null for anything else.
[[nodiscard]] const TrackFormat* format_of_track(base::Bytes bytes);

/// A track, and which format it was of.
struct FormattedTrack {
  const TrackFormat* format = nullptr;
  Track track;
};
/// Reads a track of any format. `format`: what a map says; null: as its content looks. `picture`: for normalised
/// coordinates. `dictionary`: how words are said. Errors: those of the reader; an empty file, text as UTF-16 that is no
/// list of cues, a format that is not known.
[[nodiscard]] base::Result<FormattedTrack> read_track(base::Bytes bytes, const TrackFormat* format,
                                                      std::optional<PictureSize> picture, base::Bytes dictionary = {});

/// The map that the program brings for a format, for models with curves of the names that the built-in head has:
/// brow_L, brow_R, eyelid_upper_L, ..., lip_upper, lip_lower, lip_upper_inner, lip_lower_inner. Tracks of
/// curves ("curves") are to use the same names; "nose_bridge", "nose_base", "eye_corners_L" and "eye_corners_R" tell
/// where the head is. Empty where it brings none.
[[nodiscard]] std::string_view bundled_map(std::string_view format);

}  // namespace penpose::io
