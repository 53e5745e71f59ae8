#include "core/io/tracks/read_track.h"
#include "core/io/tracks/track_formats.h"
#include "core/io/tracks/values/value_tables.h"

namespace penpose::io {

base::Result<animation::WeightTrack> read_arkit_track(base::Bytes bytes) {
  return looks_like_json(bytes) ? read_value_json(bytes) : read_value_table(bytes);
}

TrackFormat arkit_format() {
  return {"arkit", 5, true,
          [](const TrackText& text) {
            if (text.json) return mentions_values(text.text) && !text.mentions("\"curves\"");
            return text.table && has_value_columns(*text.table);
          },
          [](base::Bytes bytes, std::optional<PictureSize>) { return as_track(read_arkit_track(bytes)); }};
}

}  // namespace penpose::io
