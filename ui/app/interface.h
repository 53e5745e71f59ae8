#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ui/app/app.h"
#include "ui/app/input/drag_scroll.h"
#include "ui/app/input/screen_keyboard.h"

namespace penpose::app {

struct PanelContext;
class FilePictures;
class PosePictures;

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
  /// Milliseconds until a tooltip is due without any event; -1: none is.
  [[nodiscard]] int next_frame_ms() const;
  /// Something happened that may take panels a few frames to show.
  void disturb();

  /// Draws the mouse's pointer where no system does; nothing: it does.
  void show_pointer(std::optional<PxPoint> at) { pointer_ = at; }

  /// What other programs copied and paste, UTF-8; empty functions: there is none to share.
  struct Clipboard {
    std::function<std::string()> read;
    std::function<void(const char* text)> write;
  };
  void share_clipboard(Clipboard clipboard);

  /// Typed text, UTF-8.
  void text(const char* utf8);
  /// A key of a keyboard, by its SDL scancode and as actions name it. A text field, a dialog and a menu come first;
  /// what none of them takes is the app's.
  void key(int scancode, const KeyStroke& stroke, bool down);
  /// A text field has the keyboard.
  [[nodiscard]] bool wants_keys() const;

  /// Where a thing to hit was in the last frame, by its label; null when it was not shown.
  [[nodiscard]] const Area* find(std::string_view label) const;
  /// All of them.
  [[nodiscard]] const std::map<std::string, Area, std::less<>>& targets() const;
  /// What the tooltip says that was shown in the last frame; empty: there was none.
  [[nodiscard]] const std::string& tip() const { return tip_; }
  /// Grows when the letters' picture has to be sent to the graphics card again.
  [[nodiscard]] int font_revision() const { return font_revision_; }

 private:
  /// Text, or a key that edits it, on its way to the next frame.
  struct Typed {
    std::string text;
    int scancode = -1;  ///< of a key; -1: text
    bool down = false;
    bool ctrl = false;
    bool shift = false;
    bool waits = false;  ///< for a press on a text field that no frame has seen yet
    KeyStroke stroke = {};
  };

  void apply_look();
  void load_fonts(double scale);
  /// A text field was pressed, and does not have the keyboard yet.
  [[nodiscard]] bool field_pressed() const;
  /// Hands a key to a dialog that waits for one, whichever it is; false: none does.
  bool asks_for_key(int scancode, const KeyStroke& stroke, bool down);
  void rest_pointer(double passed_s);
  /// Counts how long a press has been held where it began.
  void time_press(double passed_s);
  void show_all(PanelContext& context);
  /// How high the timeline is, px: its strips and, where they are shown, the sheet or the curves as they were dragged
  /// or `usual`, `most` in all; where that is too little for the strips, its buttons alone.
  double timeline_height(double strips, double most, double buttons, double usual);
  void take_pointer();
  void take_typed();
  /// Presses on the keyboard of the screen go to the text field and to nothing else.
  bool type_on_screen(const PanelPointer& pointer);
  void show_keyboard(PanelContext& context);
  void draw_pointer() const;

  App& app_;
  Canvas& canvas_;
  HitMap& hits_;
  PanelState& panels_;
  Dialogs& dialogs_;
  Actions& actions_;
  PanelInput& input_;
  Preferences& preferences_;
  std::unique_ptr<PosePictures> pictures_;
  std::unique_ptr<FilePictures> file_pictures_;
  double look_scale_ = 0;
  bool look_light_ = false;
  int unsettled_ = 0;
  std::pair<float, float> rested_at_{};  ///< where the pointer is
  double rested_s_ = 0;                  ///< and for how long
  bool tip_waits_ = false;               ///< something below it has a tooltip, which is not shown yet
  bool tip_shows_ = false;
  std::string tip_;
  int font_revision_ = 0;
  std::optional<PxPoint> pointer_;
  Clipboard clipboard_;
  std::string pasted_;  ///< what it had last
  ScreenKeyboard keyboard_;
  bool keyboard_held_ = false;  ///< a press on it goes on
  DragScroll drag_scroll_;
  double held_s_ = 0;              ///< for how long a press has been held
  bool held_told_ = false;         ///< that it is long is told
  bool hovers_ = false;            ///< the pointer came without being pressed
  PanelPointer last_told_ = {};    ///< what was last heard of it
  std::deque<PanelPointer> told_;  ///< what the panels are still to be told of the pointer
  int key_to_release_ = -1;        ///< of ImGui's, pressed on the screen
  std::deque<Typed> typed_;
  bool accepts_ = false;             ///< Return was pressed for the dialog
  bool cancels_ = false;             ///< Escape was pressed for the dialog or the menu
  bool types_ = false;               ///< something was typed for the dialog's field, which shall take the keyboard
  int opening_ = 0;                  ///< frames in which a dialog that has just opened may take the keyboard
  bool menu_open_ = false;           ///< of the last frame
  std::vector<Area> fields_;         ///< to type into, of the last frame
  int pressed_frames_ = 0;           ///< until a field that was pressed has the keyboard
  bool has_field_ = false;           ///< the dialog of the last frame has a field to type into
  Dialog shown_ = Dialog::none;      ///< in the last frame
  std::optional<Area> dialog_area_;  ///< in the last frame; nothing else is to be hit
  std::map<std::string, Area, std::less<>> targets_;
};

}  // namespace penpose::app
