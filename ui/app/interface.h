#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "ui/app/app.h"
#include "ui/app/screen_keyboard.h"

namespace penpose::app {

struct PanelContext;

/// Panels, menus and dialogs of the app, in ImGui. Knows no window and no OpenGL: it takes what the app knows of the
/// pointer and leaves ImGui's draw lists for whoever draws them.
class Interface {
 public:
  /// One at a time in a program, because ImGui has one current context.
  explicit Interface(App& app);
  ~Interface();
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  /// Makes the panels of one frame; `passed_s` since the one before.
  void frame(double passed_s);
  /// Whether the next frame will differ from this one though no event comes: a press has to be seen, then a release.
  [[nodiscard]] bool unsettled() const { return unsettled_ > 0; }
  /// Something happened that may take panels a few frames to show.
  void disturb();

  /// Typed text, UTF-8, and keys that edit it, by their SDL scancodes.
  void text(const char* utf8);
  void edit_key(int scancode, bool down, bool ctrl, bool shift);
  /// A text field has the keyboard.
  [[nodiscard]] bool wants_keys() const;

  /// Where a thing to hit was in the last frame, by its label; null when it was not shown.
  [[nodiscard]] const Area* find(std::string_view label) const;
  /// All of them.
  [[nodiscard]] const std::map<std::string, Area, std::less<>>& targets() const;
  /// Grows when the letters' picture has to be sent to the graphics card again.
  [[nodiscard]] int font_revision() const { return font_revision_; }

 private:
  void apply_look();
  /// Presses on the keyboard of the screen go to the text field and to nothing else.
  bool type_on_screen(const PanelPointer& pointer);
  void show_keyboard(PanelContext& context);

  App& app_;
  double look_scale_ = 0;
  bool look_light_ = false;
  int unsettled_ = 0;
  int font_revision_ = 0;
  ScreenKeyboard keyboard_;
  bool keyboard_held_ = false;  ///< a press on it goes on
  int key_to_release_ = -1;     ///< of ImGui's, pressed on the screen
  std::map<std::string, Area, std::less<>> targets_;
};

}  // namespace penpose::app
