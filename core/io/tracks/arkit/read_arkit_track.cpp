#include "core/io/tracks/read_track.h"
#include "core/io/tracks/track_formats.h"
#include "core/io/tracks/values/bare_values.h"
#include "core/io/tracks/values/value_tables.h"

namespace penpose::io {

base::Result<animation::WeightTrack> read_arkit_track(base::Bytes bytes) {
  const std::string_view text = base::as_text(bytes);
  if (has_vmc(text)) return read_vmc_dump(bytes);
  if (looks_like_json(bytes)) return read_value_json(bytes);
  return has_packets(text) ? read_packets(bytes) : read_value_table(bytes);
}

TrackFormat arkit_format() {
  return {"arkit", 5, true,
          [](const TrackText& text) {
            if (has_vmc(text.text)) return true;
            if (text.json) return mentions_values(text.text) && !text.mentions("\"curves\"");
            if (has_packets(text.text) || bare_table(text.text).count > 0) return true;
            return text.table && has_value_columns(*text.table);
          },
          [](base::Bytes bytes, std::optional<PictureSize>) { return as_track(read_arkit_track(bytes)); }};
}

}  // namespace penpose::io
