#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "ui/render/cpu/shading/fragments.h"
#include "ui/render/cpu/triangles/draw_items.h"

namespace penpose::render {

/// What surfaces are made of, apart from where they are seen. One of each a vertex.
struct VertexPaint {
  std::span<const VertexFinish> finish;
  std::span<const Bytes4> overlay;  ///< empty: none
  std::span<const Bytes4> tint;     ///< empty: no look
  std::span<const Bytes4> light{};  ///< as vertex_light; empty: all of them see the sky, and there are no eyes
  const document::Look* look = nullptr;
};

/// A triangle of a picture, ready to tell which of its px are seen.
struct ScreenTriangle {
  const Segment* segment = nullptr;
  mesh::Triangle vertices{};
  const Piece* piece = nullptr;  ///< where it is clipped
  Corners corners;               ///< with the clock on the screen
  std::int64_t area = 0;         ///< twice, in steps; above zero
  bool front = true;
  bool turned = false;  ///< the last two corners have changed places
};
/// `near`: a segment that may have it, or null.
[[nodiscard]] ScreenTriangle screen_triangle(std::uint32_t item, std::span<const ScreenVertex> vertices,
                                             const DrawItems& items, const Segment* near);

/// What is seen of triangles at their px.
class SurfacePoints {
 public:
  SurfacePoints(std::span<const ScreenVertex> vertices, const VertexPaint& paint, const DrawItems& items)
      : vertices_(vertices), paint_(paint), items_(items) {}

  /// Which triangle the next px are of. Cheap when it was one of the last.
  void choose(std::uint32_t item) {
    chosen_ = &recent_[item % k_recent];
    if (chosen_->item != item) prepare(item);
  }
  void choose(std::uint32_t item, const ScreenTriangle& triangle) {
    chosen_ = &recent_[item % k_recent];
    if (chosen_->item != item) prepare(item, triangle);
  }
  /// Nothing is known of triangles any more.
  void forget();

  /// How opaque it is at a px, of surfaces of a look.
  [[nodiscard]] float alpha(int x, int y) const { return own_color(x, y).a; }
  /// Adds what is seen at a px to fragments that are not full; returns its alpha, for a plain surface without its
  /// shine.
  float add(int x, int y, Fragments& fragments) const;
  /// The same for px of a row, which fragments have room for; their alpha does not matter.
  void add_run(int x, int y, int count, Fragments& fragments) const;

 private:
  using Shares = glm::vec3;  ///< of the three corners, in the order of the triangle's vertices
  struct Edge {
    std::int64_t at_origin = 0;
    std::int64_t by_x = 0;
    std::int64_t by_y = 0;
  };
  struct Paint {
    glm::vec3 albedo{0};  ///< square roots of linear light
    float alpha = 1;
    glm::vec3 surface{0};  ///< roughness, metallic, gaze
  };
  static constexpr std::uint32_t k_none = ~std::uint32_t{0};
  struct Prepared {
    std::uint32_t item = k_none;
    ScreenTriangle triangle;
    std::array<Edge, 3> edges{};  ///< against each vertex of the triangle, or of the piece
    std::array<float, 3> inverse_depths{};
    bool plain_paint = false;  ///< the same at all vertices
    bool even = false;         ///< that, no eye, and edges within 31 bits at all its px and a few beside
    std::array<Paint, 3> paints{};
    glm::vec3 base{0};  ///< of plain paint, linear
  };
  static constexpr std::size_t k_recent = 64;

  void prepare(std::uint32_t item);
  void prepare(std::uint32_t item, const ScreenTriangle& triangle);
  [[nodiscard]] Paint paint_of(std::uint32_t vertex) const;
  [[nodiscard]] Shares unscaled_shares(int x, int y) const;
  [[nodiscard]] Shares shares(int x, int y) const;
  [[nodiscard]] glm::vec4 own_color(int x, int y) const;
  /// The colour of a texture of the chosen triangle's look at a px.
  [[nodiscard]] glm::vec4 texel(const document::TextureUse& use, const TextureMap& map, const TextureTransform& place,
                                int x, int y) const;
  /// Tint of the vertices at a px, linear.
  [[nodiscard]] glm::vec4 tint_at(const Shares& shares) const;
  void add_tones(int x, int y, const glm::vec3& base, float over_alpha, Fragments& fragments) const;
  void add_light(const Shares& unscaled, Fragments& fragments) const;
  float add_plain(int x, int y, const Shares& unscaled, Fragments& fragments) const;
  float add_of_look(int x, int y, Fragments& fragments) const;

  std::span<const ScreenVertex> vertices_;
  const VertexPaint& paint_;
  const DrawItems& items_;
  std::array<Prepared, k_recent> recent_{};
  Prepared* chosen_ = recent_.data();
};

}  // namespace penpose::render
