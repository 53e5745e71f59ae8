#include "core/io/tracks/track_formats.h"

#include <algorithm>
#include <vector>

#include "core/base/text/letters.h"
#include "core/io/text/utf8_text.h"
#include "core/io/tracks/cues/cue_file.h"

namespace penpose::io {

// Made by the build from the maps in the folders beside.
std::vector<TrackFormat> known_track_formats();

std::span<const TrackFormat> track_formats() {
  static const std::vector<TrackFormat> formats = [] {
    auto all = known_track_formats();
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.place < b.place; });
    return all;
  }();
  return formats;
}

bool looks_like_json(base::Bytes bytes) {
  const std::string_view text = base::without_mark(base::as_text(bytes));
  const auto first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && (text[first] == '{' || text[first] == '[');
}

bool TrackText::mentions(std::string_view word) const {
  constexpr std::size_t k_beginning = 1 << 16;
  return text.substr(0, k_beginning).find(word) != std::string_view::npos;
}

TrackText::TrackText(base::Bytes bytes) : text(base::as_text(bytes)), json(looks_like_json(bytes)) {
  if (json) return;
  if (auto opened = CsvReader::open(text)) table = std::move(opened).value();
}

std::string track_format_names(std::string_view before_last) {
  std::string names;
  const auto formats = track_formats();
  for (std::size_t i = 0; i < formats.size(); ++i) {
    if (i > 0 && (i + 1 < formats.size() || before_last.empty())) names += ", ";
    if (i > 0 && i + 1 == formats.size() && !before_last.empty()) names.append(" ").append(before_last).append(" ");
    names += formats[i].name;
  }
  return names;
}

const TrackFormat* track_format_named(std::string_view name) {
  for (const TrackFormat& format : track_formats()) {
    if (format.name == name) return &format;
  }
  return nullptr;
}

const TrackFormat* format_of_track(base::Bytes bytes) {
  const TrackText text(bytes);
  for (const TrackFormat& format : track_formats()) {
    if (format.looks_like(text)) return &format;
  }
  return nullptr;
}

base::Result<FormattedTrack> read_track(base::Bytes bytes, const TrackFormat* format,
                                        std::optional<PictureSize> picture, base::Bytes dictionary) {
  if (bytes.empty()) return base::Error{"the file is empty", "line 1", "track the video again"};
  const auto wide = text_of_utf16(bytes);
  if (wide && looks_like_cues(*wide)) {
    format = track_format_named("cues");
  } else if (wide) {
    return base::Error{"the file is text as UTF-16, of two bytes a letter", "line 1", "save it as UTF-8"};
  }
  if (format == nullptr) format = format_of_track(bytes);
  if (format == nullptr) {
    return base::Error{
        "the track's format is not known", "line 1",
        std::string("penpose takes OpenFace CSV, MediaPipe landmarks or blend shapes (CSV, JSON), Live Link Face or "
                    "Audio2Face shapes (CSV, JSON), iFacialMocap and VMC (text), 68 points (.pts, CSV), curves (JSON), "
                    ".vmd, and "
                    "mouth cues of ")
            .append(cue_format_names())
            .append("; or name the bundled map of one: ")
            .append(track_format_names("or"))
            .append(", or write a map")};
  }
  const bool said = format->read_said != nullptr && !dictionary.empty();
  auto track = said ? format->read_said(bytes, dictionary) : format->read(bytes, picture);
  if (!track) return track.error();
  return FormattedTrack{format, std::move(track).value()};
}

}  // namespace penpose::io
