#pragma once

#include <span>
#include <vector>

#include "ui/render/cpu/triangles/screen_vertices.h"
#include "ui/render/picture/image.h"

namespace penpose::render {

/// Darkens creases of a picture by its inverse depths (0: nothing there): k_occlusion_fragment and
/// k_occlusion_blur_fragment of ui/render/gl/shaders.h, after McGuire et al., "The Alchemy screen-space ambient
/// obscurance algorithm" (2011).
class Occlusion {
 public:
  Occlusion(const Raster& raster, std::span<const float> inverse_depths);

  /// First for all rows: how much of the sky each px sees.
  void measure_row(int y);
  /// Then for all rows: multiplies the picture.
  void darken_row(int y, Image& picture) const;

 private:
  [[nodiscard]] float inverse_at(int x, int y) const;
  [[nodiscard]] float depth_at(int x, int y) const;
  [[nodiscard]] glm::vec3 point(float place_x, float place_y, float depth) const;
  [[nodiscard]] float open_at(int x, int y) const;

  const Raster& raster_;
  std::span<const float> inverse_;
  float far_ = 1;
  float radius_;
  static constexpr int k_samples = 20;
  std::array<glm::vec2, k_samples> places_{};  ///< on a spiral of radius one
  std::vector<std::uint8_t> open_;             ///< 255: all of it
};

}  // namespace penpose::render
