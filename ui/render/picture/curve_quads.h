#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/camera.h"
#include "ui/render/scene.h"

namespace penpose::render {

/// One corner of the quad that carries one piece of a curve: a round cone between two discs. All lengths in px.
struct CurveCorner {
  float x = 0;
  float y = 0;
  std::array<float, 4> ends{};          ///< middle of the first disc, of the second
  std::array<float, 2> radii{};         ///< of the discs
  std::array<std::uint8_t, 4> color{};  ///< sRGB and alpha
  float order = 0;  ///< a tiny depth that differs between neighbours, so that of two equal pieces one wins
};

/// Dark outline around every curve and light halo around a highlighted one, px outside the curve's own width.
inline constexpr float k_outline_px = 1.2F;
inline constexpr float k_halo_px = 3.0F;

/// Six corners (two triangles) for each piece of the curve that lies before the camera. Points nearer than a quarter px
/// to the one before are left out; curves of one point give a dot; numbers that are not finite are skipped.
[[nodiscard]] std::vector<CurveCorner> curve_quads(const CurveDrawing& curve, const geometry::Camera& camera);

}  // namespace penpose::render
