#include "ui/render/cpu/shading/tile_drawer.h"

#include <algorithm>
#include <cmath>

#include "ui/render/cpu/backdrop_rows.h"
#include "ui/render/cpu/mixing.h"

namespace penpose::render {
namespace {

/// Colour of edges, sRGB, and how much of it is seen (k_wire_fragment in ui/render/gl/shaders.h).
constexpr std::array<float, 3> k_edge_color{0.04F, 0.05F, 0.07F};
constexpr float k_edge_alpha = 0.32F;

void blend_px(std::uint8_t* out, const std::array<float, 3>& color, float alpha) {
  for (std::size_t c = 0; c < 3; ++c) blend(out[c], color[c] * 255.0F, alpha);
}

/// Inverse depth over a triangle. Of slivers the plane is steep: what is between corners stays between them.
class DepthOf {
 public:
  DepthOf(const Corners& c, std::int64_t area) : plane_(depth_plane(c, area)) {
    const auto [low, high] = std::minmax(c[0].inverse_depth, c[1].inverse_depth);
    least_ = std::min(low, c[2].inverse_depth);
    most_ = std::max(high, c[2].inverse_depth);
  }
  [[nodiscard]] float at(int x, int y) const {
    const float raw = plane_.at(x, y);
    return raw < least_ ? least_ : raw > most_ ? most_ : raw;
  }
  [[nodiscard]] float steepness() const { return std::max(std::abs(plane_.by_x), std::abs(plane_.by_y)); }

 private:
  PxPlane plane_;
  float least_ = 0;
  float most_ = 0;
};

}  // namespace

TileDrawer::TileDrawer(const TileScene& scene) : scene_(scene), points_(scene.vertices, scene.paint, scene.items) {
  fragments_.matcap = scene.matcap;
  const Raster& r = scene.raster;
  const auto width = static_cast<float>(r.size.width);
  const auto height = static_cast<float>(r.size.height);
  const glm::vec2& plane = r.view.image_plane;
  eye_ = {-2.0F / width * plane.x, (1.0F + r.shift.x * 2.0F / width) * plane.x, 2.0F / height * plane.y,
          (-1.0F - r.shift.y * 2.0F / height) * plane.y};
}

void TileDrawer::draw(int tile, Image& picture, std::span<float> depths) {
  rect_ = scene_.items.tile(tile);
  const auto items = scene_.items.items(tile);
  if (items.empty() && scene_.edges.empty() && depths.empty()) {
    draw_backdrop(picture);
    return draw_front(picture);
  }
  depth_.fill(0.0F);
  nearest_.fill(k_nothing);
  std::size_t next = 0;
  const Segment* segment = nullptr;
  behind_.clear();
  for (; next < items.size(); ++next) {
    const ScreenTriangle triangle = screen_triangle(items[next], scene_.vertices, scene_.items, segment);
    segment = triangle.segment;
    if (segment->see_through) break;
    // Of something closed all that is seen from its back is hidden: once the rest is there, that can be told of most.
    if (triangle.front) {
      find_nearest(items[next], triangle);
    } else {
      behind_.push_back(items[next]);
    }
  }
  if (!behind_.empty()) measure_blocks();
  for (const std::uint32_t item : behind_) {
    const ScreenTriangle triangle = screen_triangle(item, scene_.vertices, scene_.items, segment);
    segment = triangle.segment;
    if (!is_hidden(triangle)) find_nearest(item, triangle);
  }
  draw_backdrop(picture);
  draw_nearest(picture);
  draw_edges(picture);
  for (; next < items.size(); ++next) draw_blended(items[next], picture);
  finish_blended(picture);
  draw_front(picture);
  if (depths.empty()) return;
  for (int y = rect_.top; y < rect_.bottom; ++y) {
    const auto from = depth_.begin() + static_cast<std::ptrdiff_t>(at(rect_.left, y));
    std::copy(from, from + (rect_.right - rect_.left),
              depths.begin() + static_cast<std::ptrdiff_t>(y) * picture.width + rect_.left);
  }
}

void TileDrawer::measure_blocks() {
  for (int row = 0; row < k_block_rows; ++row) {
    for (int column = 0; column < k_block_columns; ++column) {
      float least = depth_[static_cast<std::size_t>(row * k_block_px * DrawItems::k_tile_width + column * k_block_px)];
      for (int y = row * k_block_px; y < (row + 1) * k_block_px; ++y) {
        const float* const from =
            depth_.data() + static_cast<std::ptrdiff_t>(y * DrawItems::k_tile_width + column * k_block_px);
        for (int x = 0; x < k_block_px; ++x) least = from[x] < least ? from[x] : least;
      }
      farthest_[static_cast<std::size_t>(row * k_block_columns + column)] = least;
    }
  }
}

bool TileDrawer::is_hidden(const ScreenTriangle& triangle) const {
  const Corners& c = triangle.corners;
  const float nearest = std::max(std::max(c[0].inverse_depth, c[1].inverse_depth), c[2].inverse_depth);
  const PxRect px = shared_part(px_around(c), rect_);
  for (int row = (px.top - rect_.top) / k_block_px; row * k_block_px < px.bottom - rect_.top; ++row) {
    for (int column = (px.left - rect_.left) / k_block_px; column * k_block_px < px.right - rect_.left; ++column) {
      if (nearest >= farthest_[static_cast<std::size_t>(row * k_block_columns + column)]) return false;
    }
  }
  return true;
}

void TileDrawer::find_nearest(std::uint32_t item, const ScreenTriangle& triangle) {
  const DepthOf depth_of(triangle.corners, triangle.area);
  const float least_alpha = triangle.segment->least_alpha;
  if (least_alpha >= 0) points_.choose(item, triangle);
  // Edges lie on surfaces that they must not sink into (glPolygonOffset in MeshPass).
  const float back = scene_.edges.empty() ? 0.0F : depth_of.steepness();
  visit_inside(triangle.corners, rect_, [&](int x, int y) {
    const float depth = depth_of.at(x, y) - back;
    const std::size_t i = at(x, y);
    if (!(depth > depth_[i])) return;
    if (least_alpha >= 0 && points_.alpha(x, y) < least_alpha) return;
    depth_[i] = depth;
    nearest_[i] = item;
  });
}

void TileDrawer::draw_backdrop(Image& picture) const {
  const auto width = static_cast<std::size_t>(rect_.right - rect_.left) * 4;
  for (int y = rect_.top; y < rect_.bottom; ++y) {
    std::copy_n(scene_.backdrop.at(rect_.left, y), width, px_of(picture, rect_.left, y));
  }
}

void TileDrawer::draw_front(Image& picture) const {
  if (!scene_.behind.front) return;
  const auto width = static_cast<std::size_t>(rect_.right - rect_.left) * 4;
  for (int y = rect_.top; y < rect_.bottom; ++y)
    draw_behind_row(scene_.behind, y, rect_.left, {px_of(picture, rect_.left, y), width});
}

void TileDrawer::put(std::size_t fragment, Image& picture, float alpha) const {
  const int x = rect_.left + place_[fragment] % DrawItems::k_tile_width;
  const int y = rect_.top + place_[fragment] / DrawItems::k_tile_width;
  std::uint8_t* const out = px_of(picture, x, y);
  const std::array<float, 3> color{fragments_.shown_red[fragment], fragments_.shown_green[fragment],
                                   fragments_.shown_blue[fragment]};
  if (alpha < 1.0F) {
    blend_px(out, color, alpha);
    return;
  }
  for (std::size_t c = 0; c < 3; ++c) out[c] = static_cast<std::uint8_t>(color[c] * 255.0F + 0.5F);
  out[3] = 255;
}

void TileDrawer::finish_opaque(Image& picture) {
  shade(fragments_, eye_);
  for (int i = 0; i < fragments_.count; ++i) put(static_cast<std::size_t>(i), picture, 1.0F);
  fragments_.count = 0;
}

void TileDrawer::draw_nearest(Image& picture) {
  for (int y = rect_.top; y < rect_.bottom; ++y) {
    int x = rect_.left;
    while (x < rect_.right) {
      const std::size_t i = at(x, y);
      const std::uint32_t item = nearest_[i];
      const int begin = x++;
      if (item == k_nothing) continue;
      while (x < rect_.right && nearest_[at(x, y)] == item) ++x;
      const int count = x - begin;
      if (fragments_.count + count > Fragments::k_most) finish_opaque(picture);
      for (int k = 0; k < count; ++k) {
        place_[static_cast<std::size_t>(fragments_.count + k)] =
            static_cast<std::uint16_t>(i + static_cast<std::size_t>(k));
      }
      points_.choose(item);
      points_.add_run(begin, y, count, fragments_);
    }
  }
  finish_opaque(picture);
}

void TileDrawer::draw_edges(Image& picture) {
  constexpr float k_step = 1.0F / k_subpixels;
  const auto rank = [](int low, int high, float value) {
    return value >= static_cast<float>(low) && value < static_cast<float>(high);
  };
  for (const auto& [first, second] : scene_.edges) {
    const Corner& a = scene_.vertices[first].corner;
    const Corner& b = scene_.vertices[second].corner;
    if (a.x == k_must_be_clipped || b.x == k_must_be_clipped) continue;
    const auto beside = [](std::int32_t p, std::int32_t q, int low, int high) {
      return std::max(p, q) < low * k_subpixels || std::min(p, q) >= high * k_subpixels;
    };
    if (beside(a.x, b.x, rect_.left, rect_.right) || beside(a.y, b.y, rect_.top, rect_.bottom)) continue;
    const float ax = static_cast<float>(a.x) * k_step;
    const float ay = static_cast<float>(a.y) * k_step;
    const float dx = static_cast<float>(b.x - a.x) * k_step;
    const float dy = static_cast<float>(b.y - a.y) * k_step;
    const bool flat = std::abs(dx) >= std::abs(dy);
    const float length = flat ? dx : dy;
    if (length == 0) continue;
    const float begin = flat ? ax : ay;
    const float end = begin + length;
    // A px of each column of flat lines, of each row of steep ones.
    const int low = std::max(static_cast<int>(std::ceil(std::min(begin, end) - 0.5F)), flat ? rect_.left : rect_.top);
    const int high =
        std::min(static_cast<int>(std::ceil(std::max(begin, end) - 0.5F)), flat ? rect_.right : rect_.bottom);
    for (int along = low; along < high; ++along) {
      const float t = (static_cast<float>(along) + 0.5F - begin) / length;
      const float across = flat ? ay + dy * t : ax + dx * t;
      if (!rank(flat ? rect_.top : rect_.left, flat ? rect_.bottom : rect_.right, across)) continue;
      const int x = flat ? along : static_cast<int>(across);
      const int y = flat ? static_cast<int>(across) : along;
      const float depth = a.inverse_depth + (b.inverse_depth - a.inverse_depth) * t;
      if (depth > depth_[at(x, y)]) blend_px(px_of(picture, x, y), k_edge_color, k_edge_alpha);
    }
  }
}

void TileDrawer::draw_blended(std::uint32_t item, Image& picture) {
  const ScreenTriangle triangle = screen_triangle(item, scene_.vertices, scene_.items, nullptr);
  points_.choose(item, triangle);
  const DepthOf depth_of(triangle.corners, triangle.area);
  const bool of_look = triangle.segment->surface != nullptr;
  visit_inside(triangle.corners, rect_, [&](int x, int y) {
    const std::size_t i = at(x, y);
    if (depth_of.at(x, y) < depth_[i]) return;
    const auto fragment = static_cast<std::size_t>(fragments_.count);
    const float alpha = points_.add(x, y, fragments_);
    if (of_look && alpha < triangle.segment->least_alpha) {
      --fragments_.count;
      return;
    }
    place_[fragment] = static_cast<std::uint16_t>(i);
    // Below zero: a clear film, whose highlight is as bright as on anything else.
    alpha_[fragment] = of_look ? alpha : alpha - 2.0F;
    if (fragments_.count == Fragments::k_most) finish_blended(picture);
  });
}

void TileDrawer::finish_blended(Image& picture) {
  if (fragments_.count == 0) return;
  shade(fragments_, eye_);
  for (int i = 0; i < fragments_.count; ++i) {
    const auto f = static_cast<std::size_t>(i);
    const float alpha = alpha_[f] >= 0 ? alpha_[f] : alpha_[f] + 2.0F + fragments_.shine[f] * 0.5F;
    put(f, picture, std::clamp(alpha, 0.0F, 1.0F));
  }
  fragments_.count = 0;
}

}  // namespace penpose::render
