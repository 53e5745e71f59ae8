#pragma once

#include <string>

#include "ui/app/notices.h"
#include "ui/app/settings.h"

namespace penpose::app {

/// The settings of this user, kept in a folder.
class Preferences {
 public:
  /// An empty folder: nothing is kept.
  Preferences(std::string folder, Notices& notices);

  [[nodiscard]] Settings& settings() { return settings_; }
  [[nodiscard]] const Settings& settings() const { return settings_; }
  /// Writes them down after a change. Says so where that cannot be.
  void changed();
  /// Puts a file in front of the recent ones, and writes that down.
  void remember(const std::string& file);

 private:
  std::string folder_;
  Notices& notices_;
  std::vector<base::Error> refused_;  ///< lines of the file, when it was read
  Settings settings_;
};

}  // namespace penpose::app
