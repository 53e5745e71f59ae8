#pragma once

#include <optional>

#include "core/base/byte_reader.h"
#include "core/model_io/map_file.h"

namespace penpose::model_io {

/// Which format a track looks to be of: by the columns of a table or by the shape of JSON. Nothing for anything else.
[[nodiscard]] std::optional<TrackFormat> format_of_track(base::Bytes bytes);

/// Whether the text is JSON rather than a table.
[[nodiscard]] bool looks_like_json(base::Bytes bytes);

}  // namespace penpose::model_io
