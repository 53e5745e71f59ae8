#include "core/io/tracks/values/json_values.h"

#include "core/base/json/loose_json.h"
#include "core/base/numbers.h"
#include "core/io/text/text_lines.h"
#include "core/io/tracks/read_track.h"

namespace penpose::io {

base::Result<json::Json> read_json_values(base::Bytes bytes) {
  auto whole = json::parse_loose_json(bytes);
  if (whole) return whole;
  TextLines lines(base::as_text(bytes));
  json::Json list = json::Json::array();
  while (const auto line = lines.next()) {
    if (base::trim(*line).empty()) continue;
    auto value = json::parse_loose_json(base::as_bytes(*line));
    if (!value && list.empty()) return whole;
    if (!value) return lines.error("no valid JSON", "the file is damaged or cut off; take the line away");
    list.push_back(std::move(value).value());
    if (list.size() > k_most_track_frames) return whole;
  }
  return list;
}

}  // namespace penpose::io
