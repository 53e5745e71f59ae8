#pragma once

#include <cstdint>
#include <imgui.h>
#include <span>
#include <utility>

namespace penpose::app {

/// Room for square pictures, in rows, beside the letters in ImGui's one texture. Private to the module: ImGui's types
/// show.
class PictureSheet {
 public:
  /// Pictures of `px` by `px`, `across` by `across` of them.
  PictureSheet(int px, int across) : px_(px), across_(across) {}

  /// Sets the room aside in the atlas, before it is built. What was drawn is gone.
  void reserve(ImFontAtlas& atlas);
  [[nodiscard]] bool reserved() const { return rect_ >= 0; }
  /// There is a texture to draw into.
  [[nodiscard]] bool ready() const;
  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(across_ * across_); }
  /// Two corners in the texture of the picture at a place. Preconditions: ready(), place < count().
  [[nodiscard]] std::pair<ImVec2, ImVec2> corners(std::size_t place) const;
  /// Draws the picture of a place: RGBA, row by row. Preconditions: ready(), place < count(), px * px * 4 bytes.
  void draw(std::size_t place, std::span<const std::uint8_t> pixels);

 private:
  [[nodiscard]] std::pair<int, int> corner(std::size_t place) const;

  int px_;
  int across_;
  int rect_ = -1;
};

}  // namespace penpose::app
