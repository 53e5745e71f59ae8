#include "core/articulation/surface/ball_under.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/articulation/surface/sphere.h"
#include "core/geometry/bvh.h"

namespace penpose::articulation {
namespace {

/// A piece with fewer vertices has no shape that could be told.
constexpr std::size_t k_fewest = 16;
/// A vertex this near to the sphere is on it, as a share of the radius; as many of all have to be.
constexpr double k_on_ball = 0.04, k_share_on_ball = 0.6;
/// The least extent of a ball along any axis, in radii: a half of one has 1.
constexpr double k_least_extent = 0.7;
/// Where a curve lies that moves over a ball, in radii from its centre; as many of its points as that.
constexpr double k_lowest = 0.93, k_highest = 1.35, k_nearest = 1.2, k_most_over = 0.9;
/// How far the target may pass beside the ball as the camera sees it, in radii.
constexpr double k_beside = 0.03;
/// Vertices farther from each other than this, counted from the centre, are no true sphere.
constexpr double k_true = 0.008;
/// What lies farther out or in is no part of a ball, such as the nerve behind an eye, or an iris set in.
constexpr double k_highest_rise = 1.25, k_lowest_rise = 0.85;

struct Piece {
  std::size_t vertices = 0;
  geometry::Box box;
};

double median(std::vector<double> values) {
  std::stable_sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double least_extent(const geometry::Box& box) {
  const ModelVector size = box.maximum - box.minimum;
  return std::min({size.x, size.y, size.z});
}

/// Fits a sphere to all points, and again to those that lie on it best.
std::optional<Ball> fitted_ball(const std::vector<ModelPoint>& points) {
  constexpr int k_rounds = 4;
  Ball ball;
  std::vector<ModelPoint> kept = points;
  for (int round = 0; round < k_rounds; ++round) {
    const auto sphere = Sphere::fitted(kept);
    if (!sphere) return std::nullopt;
    ball.center = sphere->center;
    std::vector<double> radii;
    for (const ModelPoint& p : points) radii.push_back(geometry::distance(p, ball.center));
    ball.radius = median(radii);
    std::vector<double> offs;
    for (const double r : radii) offs.push_back(std::abs(r - ball.radius));
    const double enough = std::max(1.5 * median(offs), 0.002 * ball.radius);
    kept.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (offs[i] <= enough) kept.push_back(points[i]);
    }
  }
  std::size_t on = 0;
  geometry::Box box;
  for (const ModelPoint& p : points) {
    if (std::abs(geometry::distance(p, ball.center) - ball.radius) > k_on_ball * ball.radius) continue;
    ++on;
    box.add(p);
  }
  const bool round = static_cast<double>(on) >= k_share_on_ball * static_cast<double>(points.size());
  if (!round || least_extent(box) < k_least_extent * ball.radius) return std::nullopt;
  return ball;
}

/// The point of a ray that lies `level` from the centre, on this side of the ball or behind it, whichever is nearer to
/// `near`; its closest approach where it passes beside.
double meets(const geometry::Ray& ray, const ModelPoint& center, double level, double near) {
  const ModelVector from = ray.origin - center;
  const double b = glm::dot(from, ray.direction);
  const double square = b * b - (glm::dot(from, from) - level * level);
  const double half = square > 0.0 ? std::sqrt(square) : 0.0;
  return std::abs(-b - half - near) <= std::abs(-b + half - near) ? -b - half : -b + half;
}

/// How far the surface of a piece is from the centre in each direction: a table over a stereographic picture of the
/// side that looks along an axis and a little more. What lies behind has the height of the table's border.
class Heights {
 public:
  Heights(const Ball& ball, const ModelVector& axis, std::span<const ModelPoint> positions,
          std::span<const mesh::Triangle> triangles)
      : axis_(axis) {
    const ModelVector other = std::abs(axis.x) < 0.6 ? ModelVector{1, 0, 0} : ModelVector{0, 1, 0};
    right_ = geometry::normalized(glm::cross(axis, other), other);
    up_ = glm::cross(right_, axis);
    std::vector<glm::vec3> corners;
    std::vector<mesh::Triangle> some;
    for (const mesh::Triangle& t : triangles) {
      const auto first = static_cast<std::uint32_t>(corners.size());
      some.push_back({first, first + 1, first + 2});
      for (const std::uint32_t v : t) corners.emplace_back((positions[v] - ball.center) / ball.radius);
    }
    const geometry::TriangleBvh tree(corners, some, geometry::TriangleBvh::Build::quick);
    constexpr double k_from = 1.5;
    for (std::size_t row = 0; row < k_cells; ++row) {
      for (std::size_t column = 0; column < k_cells; ++column) {
        const double x = (2.0 * static_cast<double>(column) / (k_cells - 1) - 1.0) * k_reach;
        const double y = (2.0 * static_cast<double>(row) / (k_cells - 1) - 1.0) * k_reach;
        const double square = x * x + y * y;
        const ModelVector way = (right_ * (2.0 * x) + up_ * (2.0 * y) + axis_ * (1.0 - square)) / (1.0 + square);
        const auto hit = tree.nearest_hit({way * k_from, -way});
        const double height = hit ? k_from - hit->distance : 1.0;
        heights_[row * k_cells + column] = ball.radius * std::clamp(height, k_lowest_rise, k_highest_rise);
      }
    }
  }

  [[nodiscard]] double at(const ModelVector& way) const {
    const double beyond = std::max(1.0 + glm::dot(way, axis_), 0.1);
    const auto [column, along] = place(glm::dot(way, right_) / beyond);
    const auto [row, across] = place(glm::dot(way, up_) / beyond);
    const double* low = heights_.data() + row * k_cells + column;
    const double* high = low + k_cells;
    return (low[0] * (1 - along) + low[1] * along) * (1 - across) + (high[0] * (1 - along) + high[1] * along) * across;
  }

 private:
  static constexpr std::size_t k_cells = 96;
  static constexpr double k_reach = 1.15;  ///< 98 degrees from the axis

  [[nodiscard]] static std::pair<std::size_t, double> place(double x) {
    const double at = std::clamp((x / k_reach + 1.0) * 0.5, 0.0, 1.0) * (k_cells - 1);
    const std::size_t cell = std::min(static_cast<std::size_t>(at), k_cells - 2);
    return {cell, at - static_cast<double>(cell)};
  }

  ModelVector axis_;
  ModelVector right_{0};
  ModelVector up_{0};
  std::array<double, k_cells * k_cells> heights_{};
};

class HeldBall : public HeldSurface {
 public:
  HeldBall(const Ball& ball, std::optional<Heights> heights) : ball_(ball), heights_(std::move(heights)) {}

  [[nodiscard]] bool consists_of(std::uint32_t /*vertex*/, const ModelPoint& /*rest*/) const override { return false; }
  /// The height above the ball.
  [[nodiscard]] double level(const ModelPoint& rest) const override {
    const ModelVector way = rest - ball_.center;
    const double size = geometry::length(way);
    return size > 0.0 ? size - surface(way / size) : -ball_.radius;
  }
  [[nodiscard]] ModelPoint keep(const ModelPoint& moved, const ModelPoint& rest, double level) const override {
    const ModelVector from = rest - ball_.center;
    const ModelVector way = geometry::normalized(moved - ball_.center, geometry::normalized(from, ModelVector{0}));
    return ball_.center + way * (surface(way) + level);
  }
  [[nodiscard]] double lift(const geometry::Ray& ray, double near, double level) const override {
    constexpr int k_rounds = 6;
    double at = meets(ray, ball_.center, ball_.radius + level, near);
    for (int i = 0; heights_ && i < k_rounds; ++i) {
      const ModelVector way = geometry::normalized(ray.origin + ray.direction * at - ball_.center, -ray.direction);
      at = meets(ray, ball_.center, surface(way) + level, at);
    }
    return at > 0.0 ? at : near;
  }
  [[nodiscard]] std::optional<ModelPoint> center() const override { return ball_.center; }

 private:
  /// How far the surface is from the centre in a direction.
  [[nodiscard]] double surface(const ModelVector& way) const { return heights_ ? heights_->at(way) : ball_.radius; }

  Ball ball_;
  std::optional<Heights> heights_;
};

/// Whether the curve lies on the ball, and the target too as it is seen.
bool lies_on(const Ball& ball, const CurvesOverBall& curves) {
  std::size_t over = 0;
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < curves.reference.size(); ++i) {
    const double level = geometry::distance(curves.reference[i], ball.center);
    over += level >= k_lowest * ball.radius && level <= k_highest * ball.radius ? 1 : 0;
    nearest = std::min(nearest, level);
    const ModelPoint& eye = curves.camera.eye();
    const ModelVector way = geometry::normalized(curves.target[i] - eye, curves.camera.forward());
    const ModelVector from = ball.center - eye;
    const double beside = geometry::length(from - way * glm::dot(from, way));
    if (beside > level + k_beside * ball.radius) return false;
  }
  return nearest <= k_nearest * ball.radius &&
         static_cast<double>(over) >= k_most_over * static_cast<double>(curves.reference.size());
}

/// Pieces that could be a ball under the curve, by their boxes.
std::vector<std::uint32_t> pieces_about(const Canvas& canvas, std::uint32_t own, std::span<const ModelPoint> curve) {
  std::vector<Piece> pieces(canvas.mesh().component_count());
  const auto of = canvas.mesh().components();
  for (std::size_t v = 0; v < of.size(); ++v) {
    if (of[v] == own) continue;
    Piece& piece = pieces[of[v]];
    ++piece.vertices;
    piece.box.add(canvas.positions()[v]);
  }
  geometry::Box drawn;
  for (const ModelPoint& p : curve) drawn.add(p);
  const ModelPoint middle = drawn.center();
  std::vector<std::uint32_t> about;
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    const Piece& piece = pieces[i];
    if (piece.vertices < k_fewest) continue;
    const ModelVector size = piece.box.maximum - piece.box.minimum;
    const double most = std::max({size.x, size.y, size.z});
    // A half has one extent that is half of the others; what bulges may add to one.
    if (!(most > 0.0) || least_extent(piece.box) < 0.35 * most) continue;
    if (geometry::distance(piece.box.center(), middle) > k_highest * most) continue;
    about.push_back(i);
  }
  return about;
}

/// The heights of a ball's surface, where that is no true sphere.
std::optional<Heights> heights_of(const Canvas& canvas, const Ball& ball, const CurvesOverBall& curves) {
  std::vector<mesh::Triangle> about;
  double least = std::numeric_limits<double>::max();
  double most = 0;
  for (const mesh::Triangle& t : canvas.mesh().triangles()) {
    if (canvas.mesh().components()[t[0]] != ball.piece) continue;
    bool whole = true;
    for (const std::uint32_t v : t) {
      const double level = geometry::distance(canvas.positions()[v], ball.center);
      whole = whole && level < k_highest_rise * ball.radius;
      least = std::min(least, level);
      most = std::max(most, level);
    }
    if (whole) about.push_back(t);
  }
  if (most - least <= k_true * ball.radius) return std::nullopt;
  ModelVector axis{0};
  for (std::size_t i = 0; i < curves.reference.size(); ++i) {
    axis += curves.reference[i] + curves.target[i] - ball.center * 2.0;
  }
  return Heights(ball, geometry::normalized(axis, ModelVector{0, 0, 1}), canvas.positions(), about);
}

}  // namespace

bool Ball::hides(const ModelPoint& point) const { return geometry::distance(point, center) < k_lowest * radius; }

std::vector<Ball> balls_about(const Canvas& canvas, std::uint32_t own, std::span<const ModelPoint> curve) {
  const auto of = canvas.mesh().components();
  std::vector<Ball> balls;
  for (const std::uint32_t piece : pieces_about(canvas, own, curve)) {
    std::vector<ModelPoint> points;
    for (std::size_t v = 0; v < of.size(); ++v) {
      if (of[v] == piece) points.push_back(canvas.positions()[v]);
    }
    auto ball = fitted_ball(points);
    if (!ball) continue;
    ball->piece = piece;
    balls.push_back(*ball);
  }
  std::stable_sort(balls.begin(), balls.end(), [](const Ball& a, const Ball& b) { return a.radius > b.radius; });
  return balls;
}

std::shared_ptr<const HeldSurface> ball_under(const Canvas& canvas, const Ball& ball, const CurvesOverBall& curves) {
  if (!lies_on(ball, curves)) return nullptr;
  return std::make_shared<const HeldBall>(ball, heights_of(canvas, ball, curves));
}

}  // namespace penpose::articulation
