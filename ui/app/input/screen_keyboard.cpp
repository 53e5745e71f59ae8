#include "ui/app/input/screen_keyboard.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/text/letters.h"

namespace penpose::app {
namespace {

constexpr std::array<std::string_view, 4> k_rows{"1234567890", "qwertyuiop", "asdfghjkl", "zxcvbnm._-"};
constexpr std::size_t k_columns = 10;
constexpr std::size_t k_all_rows = k_rows.size() + 1;

}  // namespace

void ScreenKeyboard::show(const Area& window, const Area& field, double unit, double gap) {
  keys_.clear();
  const double width = std::min(window.width(), k_columns * (1.6 * unit + gap) + gap);
  const double height = k_all_rows * (unit + gap) + gap;
  const double left = window.left + 0.5 * (window.width() - width);
  const bool above = field.bottom > window.bottom - height;
  const double top = above ? window.top : window.bottom - height;
  area_ = {left, top, left + width, top + height};
  const double step = (width - gap) / k_columns;
  const auto add = [&](Kind kind, std::string label, std::string text, std::size_t row, double column, double columns) {
    const double x = left + gap + column * step;
    const double y = top + gap + static_cast<double>(row) * (unit + gap);
    keys_.push_back({kind, std::move(label), std::move(text), {x, y, x + columns * step - gap, y + unit}});
  };
  for (std::size_t row = 0; row < k_rows.size(); ++row) {
    const double indent = 0.5 * static_cast<double>(k_columns - k_rows[row].size());
    for (std::size_t i = 0; i < k_rows[row].size(); ++i) {
      const char c = shifted_ ? base::upper(k_rows[row][i]) : k_rows[row][i];
      add(Kind::text, std::string(1, c), std::string(1, c), row, indent + static_cast<double>(i), 1);
    }
  }
  add(Kind::shift, "Shift", "", k_rows.size(), 0, 1.5);
  add(Kind::text, "Space", " ", k_rows.size(), 1.5, 4.5);
  add(Kind::erase, "Back", "", k_rows.size(), 6, 2);
  add(Kind::done, "Done", "", k_rows.size(), 8, 2);
}

void ScreenKeyboard::hide() {
  keys_.clear();
  area_ = {};
  shifted_ = false;
}

std::optional<ScreenKeyboard::Key> ScreenKeyboard::press(PxPoint at) {
  for (const Key& key : keys_) {
    if (!key.area.holds(at)) continue;
    const Key pressed = key;
    shifted_ = pressed.kind == Kind::shift ? !shifted_ : false;
    return pressed;
  }
  return std::nullopt;
}

}  // namespace penpose::app
