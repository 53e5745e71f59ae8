#pragma once

#include <functional>
#include <memory>
#include <string>

#include "ui/app/files/leaving.h"
#include "ui/app/reference/reference_desk.h"
#include "ui/app/sound/sound_track.h"
#include "ui/portal/portal.h"

namespace penpose::app {

/// The system's own dialogs of files in place of ours, where there is a portal and the preferences want it. Nothing
/// waits for them; where none answers within a moment ours is shown.
class SystemDialogs {
 public:
  struct Parts {
    std::function<std::int64_t()> clock;  ///< microseconds
    ReferenceDesk& references;
    Files& files;
    Leaving& leaving;
    SoundTrack& sound;
    Dialogs& dialogs;
    Notices& notices;
    const Preferences& preferences;
  };
  explicit SystemDialogs(const Parts& parts) : parts_(parts) {}

  /// Null: there are none. `window` gives what they stand before (portal::FileQuestion).
  void set_portal(std::unique_ptr<portal::FilePortal> portal, std::function<std::string()> window = {});
  [[nodiscard]] bool available() const { return portal_ != nullptr; }
  /// Shows the system's dialog in place of one of ours. True: ours is not to be shown, also where another one is open.
  bool takes(Dialog dialog);
  /// One is open, or about to open.
  [[nodiscard]] bool open() const { return asked_ != Dialog::none; }
  /// Does what was answered meanwhile.
  void follow();
  /// Milliseconds until an answer that does not come is missed; -1: only an answer makes a frame.
  [[nodiscard]] int next_frame_ms() const;

 private:
  [[nodiscard]] portal::FileQuestion question_for(Dialog dialog) const;
  void use(Dialog dialog, const std::string& path);

  Parts parts_;
  std::unique_ptr<portal::FilePortal> portal_;
  std::function<std::string()> window_;
  Dialog asked_ = Dialog::none;
  std::int64_t asked_us_ = 0;
};

}  // namespace penpose::app
