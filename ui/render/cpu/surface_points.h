#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "ui/render/cpu/draw_items.h"
#include "ui/render/cpu/fragments.h"

namespace penpose::render {

/// What surfaces are made of, apart from where they are seen. One of each a vertex.
struct VertexPaint {
  std::span<const VertexFinish> finish;
  std::span<const Bytes4> overlay;  ///< empty: none
  std::span<const Bytes4> tint;     ///< empty: no look
  const document::Look* look = nullptr;
};

/// One triangle of a picture, ready to tell what is seen of it at any of its px.
class SurfacePoints {
 public:
  SurfacePoints(const Raster& raster, std::span<const ScreenVertex> vertices, const VertexPaint& paint,
                const DrawItems& items)
      : raster_(raster), vertices_(vertices), paint_(paint), items_(items) {}

  /// Which triangle the next px are of. Cheap when it is the same.
  void choose(std::uint32_t item);
  [[nodiscard]] const Corners& corners() const { return corners_; }  ///< with the clock on the screen
  [[nodiscard]] std::int64_t area() const { return area_; }
  [[nodiscard]] const Segment& segment() const { return *segment_; }

  /// How opaque it is at a px, of surfaces of a look.
  [[nodiscard]] float alpha(int x, int y) const { return own_color(x, y).a; }
  /// Adds what is seen at a px to fragments that are not full; returns its alpha, for a plain surface without its
  /// shine.
  float add(int x, int y, Fragments& fragments) const;

 private:
  using Shares = glm::vec3;  ///< of the three corners, in the order of the triangle's vertices

  [[nodiscard]] Shares unscaled_shares(int x, int y) const;
  [[nodiscard]] Shares shares(int x, int y) const;
  [[nodiscard]] glm::vec4 own_color(int x, int y) const;
  float add_plain(int x, int y, const Shares& unscaled, Fragments& fragments) const;
  float add_of_look(int x, int y, Fragments& fragments) const;

  const Raster& raster_;
  std::span<const ScreenVertex> vertices_;
  const VertexPaint& paint_;
  const DrawItems& items_;

  static constexpr std::uint32_t k_none = ~std::uint32_t{0};
  std::uint32_t item_ = k_none;
  const Segment* segment_ = nullptr;
  mesh::Triangle triangle_{};
  Corners corners_;
  std::int64_t area_ = 0;
  bool front_ = true;
  bool turned_ = false;       ///< the last two corners have changed places
  bool plain_paint_ = false;  ///< of all corners the same
  const Piece* piece_ = nullptr;
  struct Edge {
    std::int64_t at_origin = 0;
    std::int64_t by_x = 0;
    std::int64_t by_y = 0;
  };
  std::array<Edge, 3> edges_{};  ///< against each corner of corners_
  struct Paint {
    glm::vec3 albedo{0};  ///< square roots of linear light
    float alpha = 1;
    glm::vec3 surface{0};  ///< roughness, metallic, gaze
  };
  [[nodiscard]] Paint paint_of(std::uint32_t vertex) const;
  std::array<Paint, 3> paints_{};
};

}  // namespace penpose::render
