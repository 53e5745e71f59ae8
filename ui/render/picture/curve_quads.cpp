#include "ui/render/picture/curve_quads.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace penpose::render {
namespace {

struct Knot {
  float x = 0;
  float y = 0;
  float radius = 0;
  std::array<std::uint8_t, 4> color{};
};

/// Coordinates beyond this lie far outside any picture; they would only cost precision.
constexpr double k_far_px = 1e5;

std::array<std::uint8_t, 4> display(const Color& c) {
  const auto byte = [](float v) { return static_cast<std::uint8_t>(std::lround(std::clamp(v, 0.0F, 1.0F) * 255.0F)); };
  return {byte(encode_srgb(c.r)), byte(encode_srgb(c.g)), byte(encode_srgb(c.b)), byte(c.a)};
}

/// The points in px; an empty one is behind the eye.
std::vector<std::optional<Knot>> knots(const CurveDrawing& curve, const geometry::Camera& camera) {
  const std::size_t count = curve.points_px.empty() ? curve.points.size() : curve.points_px.size();
  const Color whole = curve.color.value_or(curve_color(curve.kind));
  std::vector<std::optional<Knot>> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto px = curve.points_px.empty() ? camera.project(curve.points[i]) : std::optional(curve.points_px[i]);
    if (!px || !(std::abs(px->x) < k_far_px) || !(std::abs(px->y) < k_far_px)) continue;
    const float width = i < curve.widths_px.size() ? curve.widths_px[i] : curve.width_px;
    result[i] = Knot{static_cast<float>(px->x), static_cast<float>(px->y), std::clamp(width * 0.5F, 0.25F, 50.0F),
                     display(i < curve.point_colors.size() ? curve.point_colors[i] : whole)};
  }
  return result;
}

CurvePiece piece_between(const Knot& a, const Knot& b, float margin, float order) {
  return {{a.x, a.y, b.x, b.y}, {a.radius, b.radius}, {a.color, b.color}, std::max(a.radius, b.radius) + margin, order};
}

}  // namespace

std::vector<CurvePiece> curve_pieces(const CurveDrawing& curve, const geometry::Camera& camera) {
  auto points = knots(curve, camera);
  if (curve.closed && points.size() > 2) points.push_back(points.front());
  std::vector<CurvePiece> pieces;
  pieces.reserve(points.size());
  const float margin = k_outline_px + (curve.highlighted ? k_halo_px : 0.0F) + 1.0F;
  const std::optional<Knot>* last = nullptr;
  bool drawn = false;
  int number = 0;
  for (const auto& point : points) {
    if (!point) {
      if (last != nullptr && !drawn) pieces.push_back(piece_between(**last, **last, margin, 0));
      last = nullptr;
      continue;
    }
    if (last == nullptr) {
      last = &point;
      drawn = false;
      continue;
    }
    const float dx = point->x - (*last)->x;
    const float dy = point->y - (*last)->y;
    if (dx * dx + dy * dy < 0.0625F && &point != &points.back()) continue;
    pieces.push_back(piece_between(**last, *point, margin, static_cast<float>(number++ % 4) * 2.5e-7F));
    last = &point;
    drawn = true;
  }
  if (last != nullptr && !drawn) pieces.push_back(piece_between(**last, **last, margin, 0));
  return pieces;
}

std::vector<CurveCorner> curve_quads(const CurveDrawing& curve, const geometry::Camera& camera) {
  const std::vector<CurvePiece> pieces = curve_pieces(curve, camera);
  std::vector<CurveCorner> corners;
  corners.reserve(pieces.size() * 6);
  for (const CurvePiece& piece : pieces) {
    float dx = piece.ends[2] - piece.ends[0];
    float dy = piece.ends[3] - piece.ends[1];
    const float size = std::sqrt(dx * dx + dy * dy);
    dx = size > 0 ? dx / size : 1;
    dy = size > 0 ? dy / size : 0;
    const auto corner = [&](std::size_t end, float along, float side) {
      return CurveCorner{piece.ends[2 * end] + (dx * along - dy * side) * piece.reach,
                         piece.ends[2 * end + 1] + (dy * along + dx * side) * piece.reach,
                         piece.ends,
                         piece.radii,
                         piece.colors[end],
                         piece.order};
    };
    const CurveCorner four[4] = {corner(0, -1, -1), corner(0, -1, 1), corner(1, 1, -1), corner(1, 1, 1)};
    for (const int k : {0, 1, 2, 2, 1, 3}) corners.push_back(four[k]);
  }
  return corners;
}

}  // namespace penpose::render
