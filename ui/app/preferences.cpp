#include "ui/app/preferences.h"

#include <utility>

namespace penpose::app {

Preferences::Preferences(std::string folder, Notices& notices)
    : folder_(std::move(folder)), notices_(notices), settings_(load_settings(folder_, &refused_)) {
  if (refused_.empty()) return;
  std::string said = refused_.front().line(settings_file(folder_));
  if (refused_.size() > 1) said += " (and " + std::to_string(refused_.size() - 1) + " more)";
  notices_.tell(said, true);
}

void Preferences::changed() {
  if (const auto saved = save_settings(settings_, folder_); !saved) {
    notices_.tell("the settings cannot be kept: " + saved.error().line(folder_), true);
  }
}

void Preferences::remember(const std::string& file) {
  remember_file(settings_, file);
  changed();
}

}  // namespace penpose::app
