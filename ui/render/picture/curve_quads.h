#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/camera.h"
#include "ui/render/scene.h"

namespace penpose::render {

/// A piece of a curve: a round cone between two discs. All lengths in px.
struct CurvePiece {
  std::array<float, 4> ends{};                          ///< middle of the first disc, of the second
  std::array<float, 2> radii{};                         ///< of the discs
  std::array<std::array<std::uint8_t, 4>, 2> colors{};  ///< sRGB and alpha, of the discs
  float reach = 0;  ///< of what it draws with its outline, around the line between the middles
  float order = 0;  ///< a tiny depth that differs between neighbours, so that of two equal pieces one wins
};

/// One corner of the quad that carries one piece.
struct CurveCorner {
  float x = 0;
  float y = 0;
  std::array<float, 4> ends{};
  std::array<float, 2> radii{};
  std::array<std::uint8_t, 4> color{};  ///< of its end
  float order = 0;
};

/// Dark outline around every curve and light halo around a highlighted one, px outside the curve's own width.
inline constexpr float k_outline_px = 1.2F;
inline constexpr float k_halo_px = 3.0F;

/// The pieces of a curve that lie before the camera. Points nearer than a quarter px to the one before are left out;
/// curves of one point give a dot; numbers that are not finite are skipped.
[[nodiscard]] std::vector<CurvePiece> curve_pieces(const CurveDrawing& curve, const geometry::Camera& camera);

/// Six corners (two triangles) for each piece.
[[nodiscard]] std::vector<CurveCorner> curve_quads(const CurveDrawing& curve, const geometry::Camera& camera);

}  // namespace penpose::render
