#pragma once

#include <optional>
#include <string>

#include "ui/app/cast/cast.h"

namespace penpose::app {

/// Keeps beside the sessions who is worked on together and how they stand, for after a crash. It is gone where the
/// program ends as it should, or one character is left.
class CastNote {
 public:
  /// `folder`: of sessions; empty: nothing is kept.
  CastNote(std::string folder, const Cast& cast) : folder_(std::move(folder)), cast_(cast) {}

  /// Writes it again after a change. Call it once a frame.
  void follow();
  /// The program ends. `leaves_work`: as after a crash.
  void end(bool leaves_work);

 private:
  std::string folder_;
  const Cast& cast_;
  std::string path_;  ///< empty: there is none
  std::uint64_t revision_ = 0;
};

/// The note that names a session, and its path.
struct FoundNote {
  std::string path;
  io::Cast cast;
};
/// Removes notes of a folder all whose sessions have ended as they should.
void tidy_notes(const std::string& folder);
/// Looks through the notes beside a session; nothing: it was worked on alone.
[[nodiscard]] std::optional<FoundNote> note_of_session(const std::string& session);

}  // namespace penpose::app
