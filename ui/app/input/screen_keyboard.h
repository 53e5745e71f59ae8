#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/app/view/area.h"

namespace penpose::app {

/// A keyboard on the screen for whoever has none at hand: where its keys are and what they mean. Knows no ImGui,
/// because a widget that is pressed would take the text field away.
class ScreenKeyboard {
 public:
  enum class Kind : std::uint8_t { text, shift, erase, done };
  struct Key {
    Kind kind = Kind::text;
    std::string label;
    std::string text;  ///< what it types
    Area area;
  };

  /// Lays the keys out across a window, each at least `unit` px high and wide, away from the field that is typed into.
  void show(const Area& window, const Area& field, double unit, double gap);
  void hide();
  [[nodiscard]] bool shown() const { return !keys_.empty(); }
  [[nodiscard]] const Area& area() const { return area_; }
  [[nodiscard]] const std::vector<Key>& keys() const { return keys_; }
  [[nodiscard]] bool shifted() const { return shifted_; }
  /// The key at a place, and what it types with shift as it is. A shift is taken note of, and gone after one letter.
  [[nodiscard]] std::optional<Key> press(PxPoint at);

 private:
  std::vector<Key> keys_;
  Area area_;
  bool shifted_ = false;
};

}  // namespace penpose::app
