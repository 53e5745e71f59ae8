#pragma once

#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/io/tracks/track_formats.h"

namespace penpose::cli {

/// Reads a track: a file, or for 68 points a folder of .pts files, a frame each in the order of the numbers in their
/// names (numbers that are left out are frames without a face). `format`: what the map says; null: what the
/// content looks like. `picture`: for normalised coordinates. Errors of the file system and of the reader.
[[nodiscard]] base::Result<io::FormattedTrack> read_track(const std::string& path, const io::TrackFormat* format,
                                                          std::optional<io::PictureSize> picture);

}  // namespace penpose::cli
