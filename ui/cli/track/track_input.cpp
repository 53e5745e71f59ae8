#include "ui/cli/track/track_input.h"

#include <algorithm>
#include <filesystem>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"
#include "core/io/tracks/cues/cue_file.h"
#include "ui/files/files.h"
#include "ui/files/folder_files.h"
#include "ui/speech/dictionary.h"

namespace penpose::cli {
namespace {

/// The number that a file's name ends with, as in face_0012.pts.
std::optional<std::int64_t> number_of(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  const auto last = stem.find_last_not_of("0123456789");
  return base::parse_int(std::string_view(stem).substr(last == std::string::npos ? 0 : last + 1));
}

struct PointFolder {
  std::vector<std::uint8_t> text;  ///< all files as one, blocks without points where numbers are left out
  std::vector<std::string> notes;  ///< files that could not be read, and why
};

bool is_points(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  return (ending == ".pts" || ending == ".PTS") && !file.filename().string().starts_with('.');
}

base::Result<PointFolder> read_folder(const std::vector<std::string>& named) {
  std::vector<std::pair<std::int64_t, std::filesystem::path>> files;
  for (const std::filesystem::path file : named) {
    const auto number = number_of(file);
    if (!number) {
      return base::Error{"the name does not end with a frame's number", file.filename().string(),
                         "name the files face_0001.pts, face_0002.pts, ..."};
    }
    files.emplace_back(*number, file);
  }
  if (files.empty()) return base::Error{"has no .pts file", "", "name a folder of .pts files, or one file"};
  std::sort(files.begin(), files.end());
  PointFolder all;
  constexpr std::size_t k_most_notes = 20;
  std::optional<base::Error> first;
  bool any = false;
  const auto add = [&](base::Bytes bytes) {
    bytes = base::as_bytes(base::without_mark(base::as_text(bytes)));
    all.text.insert(all.text.end(), bytes.begin(), bytes.end());
    all.text.push_back('\n');
  };
  constexpr std::size_t k_points = 68;
  const auto most_missing = static_cast<std::int64_t>(io::most_gap_frames(k_points * files.size()));
  std::int64_t left_out = 0;
  for (std::size_t i = 0; i < files.size(); ++i) {
    // Numbers may be as large as 2^63.
    const std::int64_t missing = i == 0 ? 0 : files[i].first - files[i - 1].first - 1;
    left_out += missing;
    if (missing > most_missing || left_out > most_missing) {
      return base::Error{"more than " + std::to_string(most_missing) + " frames are left out up to here",
                         files[i].second.filename().string(), "number the files as the frames of the video"};
    }
    if (missing > 0 && all.notes.size() < k_most_notes) {
      all.notes.push_back(files[i].second.filename().string() +
                          ": frames left out before it: " + std::to_string(missing) + "; they are held");
    }
    for (std::int64_t k = 0; k < missing; ++k) add(base::as_bytes("{\n}"));
    const auto bytes = files::read_plain_file(files[i].second.string(), files::k_most_text_bytes);
    auto track = bytes ? io::read_ibug_track(*bytes) : base::Result<animation::PointTrack>(bytes.error());
    if (!bytes) {
      base::Error error = bytes.error();
      error.place = files[i].second.filename().string();
      return error;
    }
    add(track ? base::Bytes(*bytes) : base::as_bytes("{\n}"));
    if (track) {
      any = true;
      continue;
    }
    base::Error error = track.error();
    error.place = files[i].second.filename().string() + (error.place.empty() ? "" : ": " + error.place);
    if (all.notes.size() < k_most_notes) all.notes.push_back(error.place + ": " + error.what + "; the frame is held");
    if (!first) first = std::move(error);
  }
  if (!any && first) return *first;
  return all;
}

}  // namespace

base::Result<io::FormattedTrack> read_track(const std::string& path, const io::TrackFormat* format,
                                            std::optional<io::PictureSize> picture) {
  const auto named = files::folder_files(path, is_points);
  if (!named) return named.error();
  if (*named) {
    const auto folder = read_folder(**named);
    if (!folder) return folder.error();
    auto track = io::read_ibug_track(folder->text);
    // Its place would be a line of a text that nobody has.
    if (!track) return base::Error{track.error().what, "", track.error().remedy};
    track->notes = folder->notes;  // the reader's own count the lines of a text that nobody has
    return io::FormattedTrack{io::track_format_named("ibug68"), std::move(track).value()};
  }
  const auto bytes = files::read_file(path, files::k_most_track_bytes);
  if (!bytes) return bytes.error();
  const bool spoken = format == nullptr ? io::looks_like_cues(base::as_text(*bytes)) : format->read_said != nullptr;
  return io::read_track(*bytes, format, picture, spoken ? speech::english_dictionary() : std::vector<std::uint8_t>());
}

}  // namespace penpose::cli
