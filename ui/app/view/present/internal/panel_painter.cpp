#include "ui/app/view/present/internal/panel_painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <imgui.h>

#include "ui/render/cpu/mixing.h"
#include "ui/render/cpu/triangles/triangle_raster.h"

namespace penpose::app {
namespace {

using render::PxRect;
using Bytes = PanelBytes;

Bytes bytes_of(ImU32 color) {
  return {static_cast<std::uint8_t>(color >> IM_COL32_R_SHIFT), static_cast<std::uint8_t>(color >> IM_COL32_G_SHIFT),
          static_cast<std::uint8_t>(color >> IM_COL32_B_SHIFT), static_cast<std::uint8_t>(color >> IM_COL32_A_SHIFT)};
}

/// a / 255, rounded, of products of two bytes.
std::uint32_t over_255(std::uint32_t a) { return (a + 128U + ((a + 128U) >> 8U)) >> 8U; }

/// As std::floor, without a call.
int whole_below(float x) {
  const int towards_zero = static_cast<int>(x);
  return static_cast<float>(towards_zero) > x ? towards_zero - 1 : towards_zero;
}

Bytes product(const Bytes& a, const Bytes& b) {
  Bytes made{};
  for (std::size_t c = 0; c < 4; ++c) {
    made[c] = static_cast<std::uint8_t>(over_255(static_cast<std::uint32_t>(a[c]) * b[c]));
  }
  return made;
}

void lay_over(std::uint8_t* out, const Bytes& color) {
  const std::uint32_t alpha = color[3];
  if (alpha == 0) return;
  for (std::size_t c = 0; c < 3; ++c) {
    out[c] = static_cast<std::uint8_t>(over_255(color[c] * alpha + out[c] * (255U - alpha)));
  }
  out[3] = static_cast<std::uint8_t>(over_255(255U * alpha + out[3] * (255U - alpha)));
}

/// Fills rows with one colour: sixteen bytes at a time, in numbers of two bytes, which compilers do at once.
class Filler {
 public:
  explicit Filler(const Bytes& color) : alpha_(color[3]), rest_(static_cast<std::uint16_t>(255U - color[3])) {
    for (unsigned i = 0; i < k_lanes; ++i) {
      own_[i] = static_cast<std::uint16_t>((i % 4 == 3 ? 255U : color[i % 4]) * alpha_ + 128U);
    }
  }

  void fill(std::uint8_t* out, int count) const {
    if (alpha_ == 0) return;
    int bytes = count * 4;
    for (; bytes >= k_lanes; bytes -= k_lanes, out += k_lanes) {
      for (int i = 0; i < k_lanes; ++i) mix(out, i);
    }
    for (int i = 0; i < bytes; ++i) mix(out, i);
  }

 private:
  static constexpr int k_lanes = 16;
  void mix(std::uint8_t* out, int i) const {
    const auto sum = static_cast<std::uint16_t>(own_[i] + static_cast<std::uint16_t>(out[i] * rest_));
    out[i] = static_cast<std::uint8_t>(static_cast<std::uint16_t>(sum + (sum >> 8)) >> 8);
  }

  unsigned alpha_;
  std::uint16_t rest_;
  std::uint16_t own_[k_lanes];
};

/// The first px whose middle is at or behind a place.
int first_px(float at) { return static_cast<int>(std::ceil(at - 0.5F)); }

}  // namespace

Letters::Letters(const ImFontAtlas& atlas)
    : px_(reinterpret_cast<const std::uint8_t*>(atlas.TexPixelsRGBA32)),
      width_(atlas.TexWidth),
      height_(atlas.TexHeight) {}

Bytes Letters::plain(const ImVec2& uv) {
  if (uv.x != last_uv_.x || uv.y != last_uv_.y) {
    last_uv_ = uv;
    last_ = sample(uv.x, uv.y);
  }
  return last_;
}

Bytes Letters::sample(float u, float v) const {
  const float x = u * static_cast<float>(width_) - 0.5F;
  const float y = v * static_cast<float>(height_) - 0.5F;
  const int column = whole_below(x);
  const int row = whole_below(y);
  // In steps of 256, as graphics cards do it.
  const auto right = static_cast<std::uint32_t>((x - static_cast<float>(column)) * 256.0F + 0.5F);
  const auto lower = static_cast<std::uint32_t>((y - static_cast<float>(row)) * 256.0F + 0.5F);
  if (right == 0 && lower == 0) return read(column, row);
  const Bytes four[4] = {read(column, row), read(column + 1, row), read(column, row + 1), read(column + 1, row + 1)};
  Bytes mixed{};
  for (std::size_t c = 0; c < 4; ++c) {
    const std::uint32_t upper = four[0][c] * (256U - right) + four[1][c] * right;
    const std::uint32_t under = four[2][c] * (256U - right) + four[3][c] * right;
    mixed[c] = static_cast<std::uint8_t>((upper * (256U - lower) + under * lower + 32768U) >> 16U);
  }
  return mixed;
}

Bytes Letters::read(int x, int y) const {
  const std::uint8_t* p =
      px_ + (static_cast<std::ptrdiff_t>(std::clamp(y, 0, height_ - 1)) * width_ + std::clamp(x, 0, width_ - 1)) * 4;
  return {p[0], p[1], p[2], p[3]};
}

bool PanelPainter::rectangle(const ImDrawVert& a, const ImDrawVert& b, const ImDrawVert& c, const ImDrawVert& d) const {
  const bool upright = a.pos.x == d.pos.x && b.pos.x == c.pos.x && a.pos.y == b.pos.y && c.pos.y == d.pos.y;
  const bool straight = a.uv.x == d.uv.x && b.uv.x == c.uv.x && a.uv.y == b.uv.y && c.uv.y == d.uv.y;
  if (!upright || !straight || a.col != b.col || a.col != c.col || a.col != d.col) return false;
  if (!(a.pos.x < c.pos.x) || !(a.pos.y < c.pos.y)) return false;
  const PxRect part =
      render::shared_part({first_px(a.pos.x), first_px(a.pos.y), first_px(c.pos.x), first_px(c.pos.y)}, clip_);
  if (part.empty()) return true;
  const Bytes color = bytes_of(a.col);
  if (a.uv.x == c.uv.x && a.uv.y == c.uv.y) {
    const Filler whole(product(letters_.plain(a.uv), color));
    for (int y = part.top; y < part.bottom; ++y) {
      whole.fill(px(part.left, y), part.right - part.left);
    }
    return true;
  }
  const float by_x = (c.uv.x - a.uv.x) / (c.pos.x - a.pos.x);
  const float by_y = (c.uv.y - a.uv.y) / (c.pos.y - a.pos.y);
  for (int y = part.top; y < part.bottom; ++y) {
    const float v = a.uv.y + (static_cast<float>(y) + 0.5F - a.pos.y) * by_y;
    std::uint8_t* out = px(part.left, y);
    for (int x = part.left; x < part.right; ++x, out += 4) {
      const float u = a.uv.x + (static_cast<float>(x) + 0.5F - a.pos.x) * by_x;
      lay_over(out, product(letters_.sample(u, v), color));
    }
  }
  return true;
}

void PanelPainter::triangle(const ImDrawVert& a, const ImDrawVert& b, const ImDrawVert& c) const {
  const ImDrawVert* three[3] = {&a, &b, &c};
  render::Corners corners{};
  for (std::size_t k = 0; k < 3; ++k) {
    const ImVec2& at = three[k]->pos;
    constexpr float k_far = 16384.0F;
    if (!(std::abs(at.x) < k_far) || !(std::abs(at.y) < k_far)) return;
    corners[k].x = static_cast<std::int32_t>(std::floor(at.x * render::k_subpixels + 0.5F));
    corners[k].y = static_cast<std::int32_t>(std::floor(at.y * render::k_subpixels + 0.5F));
  }
  if (render::shared_part(render::px_around(corners), clip_).empty()) return;
  std::int64_t area = render::twice_area(corners);
  if (area == 0) return;
  if (area < 0) {
    std::swap(corners[1], corners[2]);
    std::swap(three[1], three[2]);
    area = -area;
  }
  const bool one_place = a.uv.x == b.uv.x && a.uv.x == c.uv.x && a.uv.y == b.uv.y && a.uv.y == c.uv.y;
  const Bytes there = letters_.plain(a.uv);
  if (one_place && a.col == b.col && a.col == c.col) {
    const Filler whole(product(there, bytes_of(a.col)));
    render::visit_rows(corners, clip_, [&](int left, int right, int y) { whole.fill(px(left, y), right - left); });
    return;
  }
  constexpr ImU32 k_opaque = ~IM_COL32_A_MASK;
  if (one_place && (a.col & k_opaque) == (b.col & k_opaque) && (a.col & k_opaque) == (c.col & k_opaque)) {
    // The soft borders of everything: one colour whose alpha fades.
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k].inverse_depth = static_cast<float>(three[k]->col >> IM_COL32_A_SHIFT);
    }
    const render::PxPlane plane = render::depth_plane(corners, area);
    const Bytes own = bytes_of(a.col);
    render::visit_inside(corners, clip_, [&](int x, int y) {
      Bytes color = own;
      color[3] = static_cast<std::uint8_t>(std::clamp(plane.at(x, y), 0.0F, 255.0F) + 0.5F);
      lay_over(px(x, y), product(there, color));
    });
    return;
  }
  std::array<render::PxPlane, 6> planes;  // R, G, B, A, u, v
  const Bytes colors[3] = {bytes_of(three[0]->col), bytes_of(three[1]->col), bytes_of(three[2]->col)};
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k].inverse_depth = i < 4 ? static_cast<float>(colors[k][i]) : i == 4 ? three[k]->uv.x : three[k]->uv.y;
    }
    planes[i] = render::depth_plane(corners, area);
  }
  render::visit_inside(corners, clip_, [&](int x, int y) {
    Bytes color{};
    for (std::size_t i = 0; i < 4; ++i) {
      color[i] = static_cast<std::uint8_t>(std::clamp(planes[i].at(x, y), 0.0F, 255.0F) + 0.5F);
    }
    lay_over(px(x, y), product(one_place ? there : letters_.sample(planes[4].at(x, y), planes[5].at(x, y)), color));
  });
}

}  // namespace penpose::app
