#include "ui/app/cast/cast_note.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "ui/files/files.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* k_note_extension = ".cast";

void remove_note(const std::string& path) {
  std::error_code code;
  fs::remove(path, code);
}

std::vector<FoundNote> notes_of(const std::string& folder) {
  std::vector<FoundNote> found;
  std::error_code code;
  for (fs::directory_iterator it(folder, code), end; !code && it != end; it.increment(code)) {
    if (it->path().extension() != k_note_extension) continue;
    const auto bytes = files::read_plain_file(it->path().string(), files::k_most_settings_bytes);
    auto cast = bytes ? io::read_cast_note(*bytes) : base::Result<io::Cast>(bytes.error());
    if (cast) found.push_back({it->path().string(), std::move(*cast)});
  }
  return found;
}

}  // namespace

void CastNote::follow() {
  if (revision_ == cast_.revision() || folder_.empty()) return;
  revision_ = cast_.revision();
  if (!cast_.several()) {
    if (!path_.empty()) remove_note(std::exchange(path_, {}));
    return;
  }
  const io::Cast cast = cast_.described();
  if (path_.empty()) {
    const auto recorded = std::find_if(cast.members.begin(), cast.members.end(),
                                       [](const io::CastMember& one) { return !one.session.empty(); });
    if (recorded == cast.members.end()) return;
    path_ = free_path(folder_, fs::path(recorded->session).stem().string(), k_note_extension);
  }
  // Without it the sessions come back one by one.
  (void)files::write_file(path_, base::as_bytes(io::write_cast_note(cast)));
}

void CastNote::end(bool leaves_work) {
  if (!path_.empty() && !leaves_work) remove_note(std::exchange(path_, {}));
}

void tidy_notes(const std::string& folder) {
  for (const FoundNote& note : notes_of(folder)) {
    const bool open = std::any_of(note.cast.members.begin(), note.cast.members.end(),
                                  [](const io::CastMember& one) { return is_open_session(one.session); });
    if (!open) remove_note(note.path);
  }
}

std::optional<FoundNote> note_of_session(const std::string& session) {
  for (FoundNote& note : notes_of(fs::path(session).parent_path().string())) {
    const bool names = std::any_of(note.cast.members.begin(), note.cast.members.end(),
                                   [&](const io::CastMember& one) { return one.session == session; });
    if (names) return std::move(note);
  }
  return std::nullopt;
}

}  // namespace penpose::app
