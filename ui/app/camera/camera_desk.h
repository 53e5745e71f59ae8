#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "ui/app/canvas/canvas.h"
#include "ui/app/files/player.h"
#include "ui/app/notices.h"
#include "ui/app/playback/playback.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// Views that are kept by names and keys, and the camera that moves along the timeline. Kept is what the free part of
/// the window shows, so that windows of other sizes show the same.
class CameraDesk {
 public:
  CameraDesk(EditingSession& editing, Canvas& canvas, Playback& playback, const Player& player, Notices& notices)
      : editing_(editing), canvas_(canvas), playback_(playback), player_(player), notices_(notices) {}

  // Kept views.
  /// Those that the user kept, in their order.
  [[nodiscard]] std::vector<std::shared_ptr<const document::NamedView>> kept() const;
  /// Looks from there.
  void go_to(const document::NamedView& kept);
  /// Looks from the view of a key, 1 to 9; says how to keep one where there is none.
  void go_to_key(std::uint32_t key);
  /// Keeps the view as it is now: in place of the one that the key has, else under a name of its own. 0: without a key.
  void keep(std::uint32_t key);
  /// Keeps the view as it is now in place of a kept one.
  void replace(const std::string& name);
  /// False, and said why, where the name is another one's.
  bool rename(const std::string& name, const std::string& to);
  void remove(const std::string& name);

  // The camera of the timeline.
  [[nodiscard]] bool moves() const { return editing_.document().camera != nullptr; }
  /// Keys the view as it is now at this moment.
  void key_here();
  /// The camera has a key at this moment.
  [[nodiscard]] bool on_key() const;
  void delete_key();
  /// From the key here, or the one before it, to the next: a cut, or smooth again.
  void cut();
  /// The window shows what the camera shows; turned meanwhile, it does so again at another moment.
  [[nodiscard]] bool looks_through() const { return through_ && moves(); }
  void look_through(bool on);

  /// Another document was opened.
  void begin();
  /// Brings the view to the moment that is shown.
  void follow();

 private:
  [[nodiscard]] document::View seen() const;
  void show(const document::FramedCamera& framed);
  [[nodiscard]] std::string fresh_name() const;
  [[nodiscard]] const document::CameraKey* key_before() const;

  EditingSession& editing_;
  Canvas& canvas_;
  Playback& playback_;
  const Player& player_;
  Notices& notices_;
  bool through_ = false;
  std::shared_ptr<const document::CameraTrack> shown_track_;  ///< what the view was last taken of
  double shown_s_ = -1;
  geometry::Viewport shown_window_;
  Area shown_free_{};
};

}  // namespace penpose::app
