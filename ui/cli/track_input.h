#pragma once

#include <optional>
#include <string>
#include <variant>

#include "core/animation/track.h"
#include "core/base/result.h"
#include "core/model_io/map_file.h"
#include "core/model_io/read_track.h"

namespace penpose::cli {

struct TrackInput {
  model_io::TrackFormat format = model_io::TrackFormat::openface;
  std::variant<animation::PointTrack, animation::WeightTrack> track;
};

/// Reads a track: a file, or for 68 points a folder of .pts files, a frame each in the order of the numbers in their
/// names (numbers that are left out are frames without a face). `format`: what the map says; by default what the
/// content looks like. `picture`: for normalised coordinates. Errors of the file system and of the reader.
[[nodiscard]] base::Result<TrackInput> read_track(const std::string& path, std::optional<model_io::TrackFormat> format,
                                                  std::optional<model_io::PictureSize> picture);

}  // namespace penpose::cli
