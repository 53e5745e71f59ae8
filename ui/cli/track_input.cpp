#include "ui/cli/track_input.h"

#include "ui/cli/files.h"

namespace penpose::cli {

base::Result<TrackInput> read_track(const std::string& path, std::optional<model_io::TrackFormat> format,
                                    std::optional<model_io::PictureSize> picture) {
  const auto bytes = read_file(path);
  if (!bytes) return bytes.error();
  (void)picture;
  TrackInput input;
  input.format = format.value_or(model_io::TrackFormat::openface);
  auto track = model_io::read_openface_track(*bytes);
  if (!track) return track.error();
  input.track = std::move(track).value();
  return input;
}

}  // namespace penpose::cli
