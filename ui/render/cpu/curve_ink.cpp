#include "ui/render/cpu/curve_ink.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ui/render/cpu/mixing.h"
#include "ui/render/cpu/triangles/triangle_raster.h"
#include "ui/render/picture/curve_quads.h"

namespace penpose::render {
namespace {

constexpr int k_side = 32;  ///< px of the squares that are drawn one after the other
constexpr float k_far = 1e9F;

using Ink = std::array<float, 4>;  ///< 0..1, as displayed, and alpha

float unit(float value) { return value < 0.0F ? 0.0F : value > 1.0F ? 1.0F : value; }

PxRect around(const PxRect& a, const PxRect& b) {
  return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right), std::max(a.bottom, b.bottom)};
}

struct Line {
  CurvePiece piece;
  PxRect px;
  float along_x = 1;  ///< direction, length one
  float along_y = 0;
  float length = 0;
};

Line line_of(const CurvePiece& piece, const PxRect& picture) {
  Line line;
  line.piece = piece;
  const float dx = piece.ends[2] - piece.ends[0];
  const float dy = piece.ends[3] - piece.ends[1];
  line.length = std::sqrt(dx * dx + dy * dy);
  if (line.length > 0) {
    line.along_x = dx / line.length;
    line.along_y = dy / line.length;
  }
  const auto [left, right] = std::minmax({piece.ends[0], piece.ends[2]});
  const auto [top, bottom] = std::minmax({piece.ends[1], piece.ends[3]});
  // Its quad is turned: corners reach farther than sides.
  const float reach = piece.reach * 1.415F;
  line.px = shared_part({static_cast<int>(std::floor(left - reach)), static_cast<int>(std::floor(top - reach)),
                         static_cast<int>(std::ceil(right + reach)), static_cast<int>(std::ceil(bottom + reach))},
                        picture);
  return line;
}

/// A square of px with what is nearest at each.
class Square {
 public:
  explicit Square(const PxRect& rect) : rect_(rect) { distance_.fill(k_far); }

  void add(const Line& line) {
    const PxRect part = shared_part(line.px, rect_);
    const auto& ends = line.piece.ends;
    const float reach = line.piece.reach;
    for (int y = part.top; y < part.bottom; ++y) {
      for (int x = part.left; x < part.right; ++x) {
        const float from_x = static_cast<float>(x) + 0.5F - ends[0];
        const float from_y = static_cast<float>(y) + 0.5F - ends[1];
        const float along = from_x * line.along_x + from_y * line.along_y;
        const float side = from_y * line.along_x - from_x * line.along_y;
        if (along < -reach || along > line.length + reach || std::abs(side) > reach) continue;
        const float t = line.length > 0 ? unit(along / line.length) : 0.0F;
        const float past = along - line.length * t;
        const float d = std::sqrt(past * past + side * side) - mixed(line.piece.radii[0], line.piece.radii[1], t);
        const auto i = static_cast<std::size_t>((y - rect_.top) * k_side + x - rect_.left);
        // Ranks of 128 px each share what `order` tells apart.
        const float rank = d + line.piece.order * 128.0F;
        if (!(rank < distance_[i])) continue;
        distance_[i] = rank;
        const float share = (along + reach) / (line.length + 2.0F * reach);
        for (std::size_t c = 0; c < 4; ++c) {
          ink_[i][c] =
              mixed(static_cast<float>(line.piece.colors[0][c]), static_cast<float>(line.piece.colors[1][c]), share) /
              255.0F;
        }
      }
    }
  }

  void draw(bool highlighted, Image& picture) const {
    const float halo = highlighted ? k_halo_px : 0.0F;
    const float edge = k_outline_px + halo;
    constexpr std::array<float, 3> k_halo_color{1.0F, 0.93F, 0.62F};
    for (int y = rect_.top; y < rect_.bottom; ++y) {
      for (int x = rect_.left; x < rect_.right; ++x) {
        const auto i = static_cast<std::size_t>((y - rect_.top) * k_side + x - rect_.left);
        const float d = distance_[i];
        const float cover = unit(0.5F + edge - d);
        if (cover <= 0.0F) continue;
        const Ink& ink = ink_[i];
        float strength = highlighted ? mixed(1.0F, 0.75F, unit(0.5F + d - k_outline_px)) : 1.0F;
        if (d > -0.5F && !highlighted) strength *= mixed(1.0F, 0.8F, unit(0.5F + d));
        const float alpha = ink[3] * cover * strength;
        std::uint8_t* const out = px_of(picture, x, y);
        for (std::size_t c = 0; c < 3; ++c) {
          const float dark = ink[c] * 0.10F + 0.01F;
          float color = mixed(ink[c], dark, unit(0.5F + d));
          if (highlighted) color = mixed(color, k_halo_color[c], unit(0.5F + d - k_outline_px));
          blend(out[c], color * 255.0F, alpha);
        }
        blend(out[3], 255.0F, alpha);
      }
    }
  }

 private:
  PxRect rect_;
  std::array<float, static_cast<std::size_t>(k_side* k_side)> distance_{};
  std::array<Ink, static_cast<std::size_t>(k_side* k_side)> ink_{};
};

PxRect draw_curve(const CurveDrawing& curve, const geometry::Camera& camera, Image& picture) {
  const PxRect whole{0, 0, picture.width, picture.height};
  std::vector<Line> lines;
  PxRect all{picture.width, picture.height, 0, 0};
  for (const CurvePiece& piece : curve_pieces(curve, camera)) {
    const Line line = line_of(piece, whole);
    if (line.px.empty()) continue;
    all = around(all, line.px);
    lines.push_back(line);
  }
  for (int top = all.top; top < all.bottom; top += k_side) {
    for (int left = all.left; left < all.right; left += k_side) {
      const PxRect rect{left, top, std::min(left + k_side, all.right), std::min(top + k_side, all.bottom)};
      const auto beside = [&](const Line& line) { return shared_part(line.px, rect).empty(); };
      if (std::all_of(lines.begin(), lines.end(), beside)) continue;
      Square square(rect);
      for (const Line& line : lines) {
        if (!beside(line)) square.add(line);
      }
      square.draw(curve.highlighted, picture);
    }
  }
  return all;
}

}  // namespace

PxRect draw_curves(std::span<const CurveDrawing> curves, const geometry::Camera& camera, Image& picture) {
  PxRect drawn;
  for (const bool highlighted : {false, true}) {
    for (const CurveDrawing& curve : curves) {
      if (curve.highlighted != highlighted) continue;
      const PxRect one = draw_curve(curve, camera, picture);
      if (!one.empty()) drawn = drawn.empty() ? one : around(drawn, one);
    }
  }
  return drawn;
}

}  // namespace penpose::render
