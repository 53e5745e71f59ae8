#include "ui/app/files/recovery.h"

#include <filesystem>

namespace penpose::app {

Recovery::Recovery(const std::string& folder, Files& files, Notices& notices, Actions& actions)
    : files_(files), notices_(notices), actions_(actions) {
  if (!folder.empty()) abandoned_ = abandoned_sessions(folder);
}

void Recovery::recover(bool yes) {
  if (abandoned_.empty()) return actions_.run(Action::cancel);
  const std::string path = abandoned_.front();
  abandoned_.erase(abandoned_.begin());
  if (!yes) settle_session(path);
  if (!yes && !abandoned_.empty()) return;  // the next one is offered
  // Those that were not asked about are offered at the next start.
  actions_.run(Action::cancel);
  if (!yes) return;
  if (const auto back = files_.bring_back(path); !back) return notices_.tell(back.error().line(path), true);
  notices_.tell("brought back the work of " + std::filesystem::path(path).stem().string());
}

}  // namespace penpose::app
