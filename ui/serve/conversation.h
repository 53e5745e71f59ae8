#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/character/character.h"
#include "core/io/tracks/track_formats.h"
#include "replay/session/command_recorder.h"

namespace penpose::serve {

/// Where files come from and go to; replaced in tests.
struct Files {
  std::function<base::Result<document::Document>(const std::string& path)> load;
  std::function<base::Status(const std::string& path, base::Bytes bytes)> save;
  /// Takes lines of the session; empty: nothing is recorded.
  std::function<base::Status(std::string_view text)> record = {};
  /// The bytes of a map of tracks, or of curves.
  std::function<base::Result<std::vector<std::uint8_t>>(const std::string& path)> read = {};
  /// As io::read_track; a path may also name a folder of .pts files.
  std::function<base::Result<io::FormattedTrack>(const std::string& path, const io::TrackFormat* format,
                                                 std::optional<io::PictureSize> picture)>
      track = {};
};

/// A conversation of JSON lines about one character: load, curve, target, solve, draw, sketch, evaluate, save and what
/// else docs/library.md lists. Each line is a command of the document, as in the window and the C library, so that the
/// session that is recorded of them replays to the same bits.
class Conversation {
 public:
  explicit Conversation(Files files);
  Conversation(const Conversation&) = delete;
  Conversation& operator=(const Conversation&) = delete;

  /// The longest line that is read; who reads lines may stop there.
  static constexpr std::size_t k_longest_line = std::size_t{1} << 26;

  /// The answer to a line, one line without its end: {"ok": true, ...} or {"ok": false, "error": "..."}, and the "id"
  /// that the line had, if any. A line with an error has changed nothing.
  [[nodiscard]] std::string answer(std::string_view line);

  /// The character that is talked about; null before the first load.
  [[nodiscard]] character::Character* character() { return character_ ? &*character_ : nullptr; }

 private:
  struct Actions;

  void listen();

  Files files_;
  std::optional<character::Character> character_;
  replay::CommandRecorder recorder_;
};

}  // namespace penpose::serve
