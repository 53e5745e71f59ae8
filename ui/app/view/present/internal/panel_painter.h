#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <imgui.h>

#include "ui/render/cpu/triangles/triangle_raster.h"

namespace penpose::app {

using PanelBytes = std::array<std::uint8_t, 4>;  ///< R G B A

/// The picture of letters and signs where ImGui has it, which must not change meanwhile.
class Letters {
 public:
  explicit Letters(const ImFontAtlas& atlas);

  [[nodiscard]] bool known() const { return px_ != nullptr; }
  /// At the place that was asked for last it costs nothing: what is plain all points at one white px.
  [[nodiscard]] PanelBytes plain(const ImVec2& uv);
  [[nodiscard]] PanelBytes sample(float u, float v) const;

 private:
  [[nodiscard]] PanelBytes read(int x, int y) const;

  const std::uint8_t* px_;
  int width_;
  int height_;
  ImVec2 last_uv_{-1, -1};
  PanelBytes last_{};
};

/// Px of a part of a picture, 4 bytes R G B A each, colours times their alpha.
struct PanelPx {
  std::uint8_t* first = nullptr;  ///< of the px at `left`, `top`
  int left = 0;
  int top = 0;
  std::ptrdiff_t row_bytes = 0;
};

/// Draws triangles of ImGui on the processor as its back end for OpenGL does: by the middles of px, textures filtered
/// between px, each laid over what is there by its alpha. Debian's ImGui is built without its back end for SDL's
/// renderer.
class PanelPainter {
 public:
  /// Nothing is drawn outside of `clip`, which lies in `out`.
  PanelPainter(Letters& letters, const render::PxRect& clip, const PanelPx& out)
      : letters_(letters), clip_(clip), out_(out) {}

  /// Two triangles that make an upright rectangle of one colour: most of what panels are. False: they do not.
  bool rectangle(const ImDrawVert& a, const ImDrawVert& b, const ImDrawVert& c, const ImDrawVert& d) const;
  void triangle(const ImDrawVert& a, const ImDrawVert& b, const ImDrawVert& c) const;

 private:
  [[nodiscard]] std::uint8_t* px(int x, int y) const {
    return out_.first + (y - out_.top) * out_.row_bytes + (x - out_.left) * std::ptrdiff_t{4};
  }

  Letters& letters_;
  render::PxRect clip_;
  PanelPx out_;
};

}  // namespace penpose::app
