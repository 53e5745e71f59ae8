#pragma once

#include <string>

#include "replay/session/session_player.h"
#include "tests/support/app_desk.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"

namespace penpose::app {

/// What replaying the session in a file that an app wrote gives.
[[nodiscard]] inline base::Result<replay::ReplayResult> replayed(const std::string& session) {
  const auto bytes = files::read_plain_file(session);
  if (!bytes) return bytes.error();
  replay::PlayerOptions options;
  options.open = [](const std::string& path) { return files::load_document(path, files::NamedBy::user); };
  return replay::play_session(replay::read_from(*bytes), options);
}

}  // namespace penpose::app
