#include "core/model_io/track_format.h"

#include "core/model_io/csv_reader.h"

namespace penpose::model_io {

bool looks_like_json(base::Bytes bytes) {
  std::string_view text = base::as_text(bytes);
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  const auto first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && (text[first] == '{' || text[first] == '[');
}

std::optional<TrackFormat> format_of_track(base::Bytes bytes) {
  const std::string_view text = base::as_text(bytes);
  if (looks_like_json(bytes)) {
    constexpr std::size_t k_beginning = 1 << 16;
    const std::string_view beginning = text.substr(0, k_beginning);
    return beginning.find("\"curves\"") != std::string_view::npos ? TrackFormat::curves : TrackFormat::mediapipe;
  }
  if (text.find("n_points") != std::string_view::npos) return TrackFormat::ibug68;
  const auto table = CsvReader::open(text);
  if (!table) return std::nullopt;
  if (table->find("Timecode")) return TrackFormat::arkit;
  const auto has = [&](const char* name) { return table->find(name).has_value(); };
  if (has("landmark") || has("landmark_id") || has("landmark_index") || has("x_467") || has("x467") ||
      has("landmark_467_x") || has("467_x") || (has("x") && has("frame"))) {
    return TrackFormat::mediapipe;
  }
  if (has("x_0") && (has("success") || has("gaze_0_x") || has("confidence"))) return TrackFormat::openface;
  if (has("x_68") || has("x68")) return std::nullopt;  // more points than 68, and not as many as a face mesh
  if (has("x_0") || has("x0") || table->header_is_row()) return TrackFormat::ibug68;
  return std::nullopt;
}

}  // namespace penpose::model_io
