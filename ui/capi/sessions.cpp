#include <algorithm>

#include "core/base/version.h"
#include "core/document/commands/command_text.h"
#include "replay/recording/recording.h"
#include "replay/session/session_player.h"
#include "ui/capi/from_c.h"

using namespace penpose;        // NOLINT(google-build-using-namespace): functions of C have no namespace of their own
using namespace penpose::capi;  // NOLINT(google-build-using-namespace)

namespace {

penpose_playback playback_of(replay::ReplayResult& played) {
  penpose_playback out{};
  out.reports = played.reports;
  out.strokes = played.session->stroke_count();
  out.steps = played.steps;
  out.refused = played.refused;
  out.checked = played.checked;
  out.differing = played.differing;
  out.line = played.divergence ? played.divergence->line : 0;
  const std::string state = played.session->editor().state().whole.hex();
  std::copy_n(state.c_str(), sizeof out.state, out.state);
  return out;
}

/// A session names its model by a path; a caller has it in memory, or means the head that the library makes itself.
base::Result<document::Document> opened(const std::string& path, const std::optional<document::Document>& on) {
  if (on) return *on;
  auto made = built_in_document(path.empty() ? "builtin:head" : path);
  if (made) return made;
  return base::Error{"the session was recorded on \"" + path + "\"", "model", "make that character and give it"};
}

}  // namespace

int32_t penpose_session_play(penpose_library* library, const void* bytes, size_t size, penpose_handle on,
                             penpose_handle* character, penpose_playback* playback, penpose_error* error) {
  return call(error, [&] {
    needed(library, "library");
    needed(character, "character");
    const auto text = array(static_cast<const std::uint8_t*>(bytes), size, "bytes");
    std::optional<document::Document> given;
    if (on != 0) {
      const auto object = object_of<CharacterObject>(library, on);
      const std::lock_guard guard(object->busy);
      given = object->character.document();
    }
    replay::PlayerOptions options;
    options.open = [&](const std::string& path) { return opened(path, given); };
    auto played = taken(replay::play_session(replay::read_recording(replay::read_from(text)), options));
    if (!played.session) {
      fail(PENPOSE_REFUSED, {"holds nothing to replay: neither reports nor lines of a session", "",
                             "give a session, or a recording of a tablet that `penpose replay` reads"});
    }
    const penpose_playback came_to = playback_of(played);
    if (played.divergence) {
      if (playback != nullptr) *playback = came_to;
      fail(PENPOSE_DIVERGED, replay::error_of(*played.divergence));
    }
    give<CharacterObject>(*library, *character, character::Character(played.session->editor().document()));
    if (playback != nullptr) *playback = came_to;
  });
}

int32_t penpose_perform(penpose_library* library, penpose_handle character, const char* command, penpose_error* error) {
  return call_character(library, character, error, [&](character::Character& one, CharacterObject&) {
    done(one.perform(taken(document::parse_command(text(command, "command")))));
  });
}

int32_t penpose_record(penpose_library* library, penpose_handle character, const char* model, penpose_error* error) {
  return call_character(library, character, error, [&](character::Character& one, CharacterObject& object) {
    replay::CommandRecorder recorder("libpenpose-" + std::string(base::k_version));
    std::string begun = recorder.begin(one.document(), text(model, "model"));
    one.listen([&object](std::span<const document::Command> commands, std::span<const document::Document> after) {
      // Only the last of these changes anything.
      replay::CommandRecorder next = *object.recorder;
      const std::string lines = next.lines(commands, after);
      object.session += lines;
      *object.recorder = std::move(next);
      return base::Status(base::Done{});
    });
    object.session = std::move(begun);
    object.recorder = std::move(recorder);
  });
}

int32_t penpose_recorded(penpose_library* library, penpose_handle character, char* text, size_t capacity, size_t* size,
                         penpose_error* error) {
  return call_character(library, character, error, [&](const character::Character&, const CharacterObject& object) {
    if (!object.recorder) fail(PENPOSE_REFUSED, {"nothing is recorded", "", "call penpose_record first"});
    write_list<char>(object.session, text, capacity, size, "text");
  });
}
