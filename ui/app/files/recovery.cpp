#include "ui/app/files/recovery.h"

#include <filesystem>
#include <vector>

#include "ui/app/cast/cast_note.h"

namespace penpose::app {

Recovery::Recovery(const std::string& folder, Files& files, Notices& notices, Actions& actions)
    : files_(files), notices_(notices), actions_(actions) {
  if (folder.empty()) return;
  abandoned_ = abandoned_sessions(folder);
  tidy_notes(folder);
}

void Recovery::recover(bool yes) {
  if (abandoned_.empty()) return actions_.run(Action::cancel);
  const std::string path = abandoned_.front();
  abandoned_.erase(abandoned_.begin());
  const auto together = note_of_session(path);
  if (together) {
    // All of them come back, or none.
    for (const io::CastMember& member : together->cast.members) {
      std::erase(abandoned_, member.session);
      if (!yes && !member.session.empty()) settle_session(member.session);
    }
    std::error_code code;
    std::filesystem::remove(together->path, code);
  }
  if (!yes) settle_session(path);
  if (!yes && !abandoned_.empty()) return;  // the next one is offered
  // Those that were not asked about are offered at the next start.
  actions_.run(Action::cancel);
  if (!yes) return;
  if (const auto back = together ? files_.bring_back_cast(together->cast) : files_.bring_back(path); !back)
    return notices_.tell(back.error().line(path), true);
  notices_.tell("recovered " + std::filesystem::path(path).stem().string());
}

}  // namespace penpose::app
