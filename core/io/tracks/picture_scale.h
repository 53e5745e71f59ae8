#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/io/tracks/read_track.h"
#include "core/io/tracks/track_rows.h"

namespace penpose::io {

/// Turns coordinates that are shares of the picture into px, where all rows with a face lie within -1..2. Depths are
/// shares of the width. Without a size the picture is taken as 1000 px square, and `notes` says so.
void scale_to_picture(std::vector<TrackRow>& rows, std::optional<PictureSize> picture, std::vector<std::string>& notes);

}  // namespace penpose::io
