#include "ui/app/view/present/panel_layer.h"

#include <algorithm>
#include <cstring>
#include <imgui.h>

#include "ui/app/view/present/internal/panel_painter.h"
#include "ui/render/cpu/mixing.h"

namespace penpose::app {
namespace {

using render::PxRect;

constexpr std::size_t k_row_bytes = std::size_t{4} * PanelLayer::k_tile_width;
constexpr std::size_t k_tile_bytes = k_row_bytes * PanelLayer::k_tile_height;

/// A triangle of ImGui's lists, or two that may make an upright rectangle.
struct Shape {
  const ImDrawVert* corners[4];  ///< of a triangle the first three
  bool pair;
};

/// Hashes that tell pictures apart which a program draws by itself; none that hold against malice.
std::uint64_t mixed_hash(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * 0x9e3779b97f4a7c15U;
  return hash ^ (hash >> 32U);
}

std::uint64_t mixed_hash(std::uint64_t hash, const ImDrawVert& vertex) {
  std::uint64_t words[2];
  std::memcpy(words, &vertex.pos, sizeof vertex.pos);
  std::memcpy(words + 1, &vertex.uv, sizeof vertex.uv);
  return mixed_hash(mixed_hash(mixed_hash(hash, words[0]), words[1]), vertex.col);
}

std::uint64_t hash_of(const PxRect& clip) {
  const auto both = [](int a, int b) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32U) | static_cast<std::uint32_t>(b);
  };
  return mixed_hash(mixed_hash(1, both(clip.left, clip.top)), both(clip.right, clip.bottom));
}

/// As ImGui's back ends round it.
PxRect px_of_clip(const ImVec4& clip, int width, int height) {
  const int left = static_cast<int>(clip.x);
  const int foot = static_cast<int>(static_cast<float>(height) - clip.w);
  const int bottom = height - foot;
  return render::shared_part(
      {left, bottom - static_cast<int>(clip.w - clip.y), left + static_cast<int>(clip.z - clip.x), bottom},
      {0, 0, width, height});
}

/// The tiles that a shape may reach, as columns and rows.
PxRect tiles_of_shape(const Shape& shape, const PxRect& clip) {
  float left = shape.corners[0]->pos.x;
  float right = left;
  float top = shape.corners[0]->pos.y;
  float bottom = top;
  for (int k = 1; k < (shape.pair ? 4 : 3); ++k) {
    const ImVec2& at = shape.corners[k]->pos;
    left = at.x < left ? at.x : left;
    right = at.x > right ? at.x : right;
    top = at.y < top ? at.y : top;
    bottom = at.y > bottom ? at.y : bottom;
  }
  // Of a number that is none nothing is drawn.
  const auto held = [](float value, int low, int high) {
    return value > static_cast<float>(low) ? (value < static_cast<float>(high) ? static_cast<int>(value) : high) : low;
  };
  const PxRect px{held(left - 1, clip.left, clip.right), held(top - 1, clip.top, clip.bottom),
                  held(right + 2, clip.left, clip.right), held(bottom + 2, clip.top, clip.bottom)};
  if (px.empty()) return {};
  return {px.left / PanelLayer::k_tile_width, px.top / PanelLayer::k_tile_height,
          (px.right - 1) / PanelLayer::k_tile_width + 1, (px.bottom - 1) / PanelLayer::k_tile_height + 1};
}

/// Calls `visit(shape, clip, clip_hash)` for what is drawn, in its order.
template <typename Visit>
void visit_shapes(const ImDrawData& panels, int width, int height, const Visit& visit) {
  for (int l = 0; l < panels.CmdListsCount; ++l) {
    const ImDrawList& list = *panels.CmdLists[l];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      const PxRect clip = px_of_clip(command.ClipRect, width, height);
      if (clip.empty()) continue;
      const std::uint64_t hash = hash_of(clip);
      const ImDrawIdx* const index = list.IdxBuffer.Data + command.IdxOffset;
      const ImDrawVert* const vertices = list.VtxBuffer.Data + command.VtxOffset;
      for (unsigned i = 0; i + 2 < command.ElemCount;) {
        const ImDrawIdx* const t = index + i;
        const bool pair = i + 5 < command.ElemCount && t[3] == t[0] && t[4] == t[2];
        visit(Shape{{vertices + t[0], vertices + t[1], vertices + t[2], vertices + t[pair ? 5 : 2]}, pair}, clip, hash);
        i += pair ? 6 : 3;
      }
    }
  }
}

void paint_shape(const Shape& shape, const PanelPainter& painter) {
  const auto& c = shape.corners;
  if (shape.pair && painter.rectangle(*c[0], *c[1], *c[2], *c[3])) return;
  painter.triangle(*c[0], *c[1], *c[2]);
  if (shape.pair) painter.triangle(*c[0], *c[2], *c[3]);
}

}  // namespace

void PanelLayer::hash_tiles(const ImDrawData& panels) {
  std::fill(hashes_.begin(), hashes_.end(), 0);
  visit_shapes(panels, width_, height_, [&](const Shape& shape, const PxRect& clip, std::uint64_t clip_hash) {
    const PxRect in = tiles_of_shape(shape, clip);
    if (in.empty()) return;
    std::uint64_t hash = mixed_hash(clip_hash, shape.pair ? 4 : 3);
    for (int k = 0; k < (shape.pair ? 4 : 3); ++k) hash = mixed_hash(hash, *shape.corners[k]);
    for (int row = in.top; row < in.bottom; ++row) {
      for (int column = in.left; column < in.right; ++column) {
        std::uint64_t& one = hashes_[static_cast<std::size_t>(row * columns_ + column)];
        one = mixed_hash(one, hash);
      }
    }
  });
}

void PanelLayer::paint_tiles(const ImDrawData& panels) {
  Letters letters(*ImGui::GetIO().Fonts);
  if (!letters.known()) return;
  visit_shapes(panels, width_, height_, [&](const Shape& shape, const PxRect& clip, std::uint64_t /*hash*/) {
    const PxRect in = tiles_of_shape(shape, clip);
    for (int row = in.top; row < in.bottom; ++row) {
      for (int column = in.left; column < in.right; ++column) {
        Tile& tile = tiles_[static_cast<std::size_t>(row * columns_ + column)];
        if (!tile.dirty) continue;
        const int left = column * k_tile_width;
        const int top = row * k_tile_height;
        const PxRect part = render::shared_part(clip, {left, top, left + k_tile_width, top + k_tile_height});
        if (!part.empty()) paint_shape(shape, {letters, part, {tile.own.data(), left, top, k_row_bytes}});
      }
    }
  });
}

void PanelLayer::lay(const ImDrawData& panels, render::Image& picture) {
  columns_ = (picture.width + k_tile_width - 1) / k_tile_width;
  const int rows = (picture.height + k_tile_height - 1) / k_tile_height;
  const auto count = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows);
  if (width_ != picture.width || height_ != picture.height) tiles_.clear();
  width_ = picture.width;
  height_ = picture.height;
  tiles_.resize(count);
  hashes_.resize(count);
  hash_tiles(panels);
  painted_ = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Tile& tile = tiles_[i];
    tile.dirty = tile.hash != hashes_[i];
    if (!tile.dirty) continue;
    tile.hash = hashes_[i];
    // Without any shape the hash stays zero.
    tile.own.assign(tile.hash == 0 ? 0 : k_tile_bytes, 0);
    ++painted_;
  }
  if (painted_ > 0) paint_tiles(panels);
  for (std::size_t i = 0; i < count; ++i) {
    Tile& tile = tiles_[i];
    const int column = static_cast<int>(i) % columns_;
    const int row = static_cast<int>(i) / columns_;
    if (tile.dirty) {
      const int right = std::min(k_tile_width, width_ - column * k_tile_width);
      const int bottom = std::min(k_tile_height, height_ - row * k_tile_height);
      bool clear = true;
      bool opaque = true;
      for (int y = 0; y < bottom && !tile.own.empty(); ++y) {
        for (int x = 0; x < right; ++x) {
          const std::uint8_t alpha =
              tile.own[static_cast<std::size_t>(y) * k_row_bytes + static_cast<std::size_t>(x) * 4 + 3];
          clear = clear && alpha == 0;
          opaque = opaque && alpha == 255;
        }
      }
      if (clear) tile.own = {};
      tile.rest.assign(clear || opaque ? 0 : k_tile_bytes, 0);
      for (std::size_t b = 0; b < tile.rest.size(); ++b) {
        tile.rest[b] = static_cast<std::uint8_t>(255 - tile.own[b | 3U]);
      }
    }
    if (!tile.own.empty()) lay_tile(tile, column, row, picture);
  }
}

void PanelLayer::lay_tile(const Tile& tile, int column, int row, render::Image& picture) const {
  const int left = column * k_tile_width;
  const int top = row * k_tile_height;
  const auto bytes = static_cast<std::size_t>(std::min(k_tile_width, width_ - left)) * 4;
  const int bottom = std::min(top + k_tile_height, height_);
  for (int y = top; y < bottom; ++y) {
    std::uint8_t* const out = render::px_of(picture, left, y);
    const std::size_t begin = static_cast<std::size_t>(y - top) * k_row_bytes;
    const std::uint8_t* const own = tile.own.data() + begin;
    if (tile.rest.empty()) {
      std::memcpy(out, own, bytes);
      continue;
    }
    const std::uint8_t* const rest = tile.rest.data() + begin;
    for (std::size_t b = 0; b < bytes; ++b) {
      // A product of two bytes over 255, rounded; with what is laid over it never more than 255.
      const auto product = static_cast<std::uint16_t>(out[b] * rest[b] + 128);
      const auto below = static_cast<std::uint8_t>(static_cast<std::uint16_t>(product + (product >> 8)) >> 8);
      out[b] = static_cast<std::uint8_t>(own[b] + below);
    }
  }
}

}  // namespace penpose::app
