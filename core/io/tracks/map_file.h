#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"

namespace penpose::io {

struct TrackFormat;

/// Points of a track: their numbers, or names of tracked curves, whose points are all meant.
using MapPoints = std::vector<std::variant<std::size_t, std::string>>;

/// One tracked curve and the curve of the model that it drives.
struct MapCurve {
  std::variant<std::vector<std::size_t>, std::string> track;        ///< point numbers of the format, or a curve's name
  std::variant<std::vector<std::uint32_t>, std::string> reference;  ///< vertices of the model, or a curve's name
  MapPoints anchor;                                                 ///< what the curve rides on
  double weight = 1;                                                ///< above 0
  std::string meets;    ///< name of the reference of the curve that it closes on; may be empty
  std::string touches;  ///< name of the reference of the curve that it lies on at rest, as lips do; may be empty
  double gain = 1;      ///< the model's curve moves this many times as far as the tracked one
};

/// A control that a column of values drives: offset + gain * response(value).
struct MapTarget {
  std::string control;  ///< by name
  double gain = 1;
  double offset = 0;
  std::vector<std::pair<double, double>>
      response;  ///< (value, share), values ascending, straight between; empty: as is
};

/// Which tracked curve drives which curve of a model (cli.md, "Map files").
struct MapFile {
  const TrackFormat* format = nullptr;  ///< one of track_formats()
  std::vector<MapCurve> curves;
  MapPoints stable;               ///< what no expression moves
  MapPoints turning;              ///< see animation::StablePoints
  bool apply_head = false;        ///< the head's turn becomes part of the animation
  std::vector<std::string> free;  ///< controls that may move; those that the model lacks are passed over; empty: all
  /// For tracks of values: what a column drives, where that is not the control of its name.
  std::vector<std::pair<std::string, std::vector<MapTarget>>> names;
  std::vector<std::string> skipped;  ///< JSON pointers of members that no reader knows
  bool bundled = false;              ///< it came with the program, and may name more than a model or a track has
};

/// Reads {"format", "curves": [{"track", "reference", "anchor", "meets", "touches", "weight", "gain"}], "stable",
/// "turning", "head": "drop" | "apply", "free", "names": {TRACKED: CONTROL, TRACKED: {"control", "gain", "offset",
/// "response": [[VALUE, SHARE], ...]}, TRACKED: [several of these]}}. "curves" is needed but for "arkit"; all else is
/// optional. Errors (place: JSON pointer): a member that is missing, unknown in value or of another type, curves of one
/// point, weights not above 0.
[[nodiscard]] base::Result<MapFile> read_map_file(base::Bytes bytes);

/// The map that the program brings for a format (bundled_map). Errors: it brings none.
[[nodiscard]] base::Result<MapFile> read_bundled_map(const TrackFormat& format);

}  // namespace penpose::io
