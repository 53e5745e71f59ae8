#include "core/articulation/surface/ball_under.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "core/articulation/surface/sphere.h"
#include "core/geometry/bvh.h"

namespace penpose::articulation {
namespace {

/// A piece with fewer vertices has no shape that could be told.
constexpr std::size_t k_fewest = 16;
/// A vertex this near to the sphere is on it, as a share of the radius; as many of all have to be.
constexpr double k_on_ball = 0.04;
constexpr double k_most_on_ball = 0.6;
/// The least extent of a ball along any axis, in radii: a half of one has 1.
constexpr double k_least_extent = 0.7;
/// Where a curve lies that moves over a ball, in radii from its centre; as many of its points as that.
constexpr double k_lowest = 0.93;
constexpr double k_highest = 1.35;
constexpr double k_nearest = 1.2;
constexpr double k_most_over = 0.9;
/// How far the target may pass beside the ball as the camera sees it, in radii.
constexpr double k_beside = 0.03;
/// What rises this far above the sphere is a bulge, and what passes over it keeps up to as much from it.
constexpr double k_bulge = 0.004;
constexpr double k_clear = 0.01;
/// What rises more is no part of a ball, such as the nerve behind an eye or its lashes.
constexpr double k_highest_bulge = 1.25;

struct Piece {
  std::size_t vertices = 0;
  geometry::Box box;
};

struct Ball {
  ModelPoint center{0};
  double radius = 0;
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
  const bool round = static_cast<double>(on) >= k_most_on_ball * static_cast<double>(points.size());
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

class HeldBall : public HeldSurface {
 public:
  /// `bulging`: the triangles that rise above the sphere.
  HeldBall(const Ball& ball, std::span<const ModelPoint> positions, std::span<const mesh::Triangle> bulging)
      : ball_(ball), top_(ball.radius) {
    if (bulging.empty()) return;
    std::vector<glm::vec3> corners;
    std::vector<mesh::Triangle> triangles;
    ModelVector sum{0};
    for (const mesh::Triangle& t : bulging) {
      const auto first = static_cast<std::uint32_t>(corners.size());
      triangles.push_back({first, first + 1, first + 2});
      for (const std::uint32_t v : t) {
        const ModelVector from = positions[v] - ball.center;
        corners.emplace_back(from);
        sum += geometry::normalized(from, ModelVector{0});
        top_ = std::max(top_, geometry::length(from));
      }
    }
    axis_ = geometry::normalized(sum, ModelVector{0});
    for (const glm::vec3& corner : corners) {
      cosine_ = std::min(cosine_, glm::dot(axis_, geometry::normalized(ModelVector(corner), axis_)));
    }
    bulge_.emplace(corners, triangles, geometry::TriangleBvh::Build::quick);
  }

  [[nodiscard]] bool consists_of(std::uint32_t /*vertex*/, const ModelPoint& /*rest*/) const override { return false; }
  [[nodiscard]] double level(const ModelPoint& rest) const override { return geometry::distance(rest, ball_.center); }
  [[nodiscard]] ModelPoint keep(const ModelPoint& moved, const ModelPoint& rest, double level) const override {
    ModelVector way = moved - ball_.center;
    double size = geometry::length(way);
    if (!(size > 1e-12 * level)) {
      way = rest - ball_.center;
      size = level;
    }
    if (!(size > 0.0)) return rest;
    way /= size;
    const double before = bulge_ ? height(geometry::normalized(rest - ball_.center, way)) : ball_.radius;
    return ball_.center + way * over(way, level, before);
  }
  [[nodiscard]] double lift(const geometry::Ray& ray, double near, double level) const override {
    constexpr int k_rounds = 6;
    double at = meets(ray, ball_.center, level, near);
    for (int i = 0; bulge_ && i < k_rounds; ++i) {
      const ModelVector way = ray.origin + ray.direction * at - ball_.center;
      at = meets(ray, ball_.center, over(geometry::normalized(way, axis_), level, ball_.radius), at);
    }
    return at > 0.0 ? at : near;
  }
  [[nodiscard]] std::optional<ModelPoint> center() const override { return ball_.center; }

 private:
  /// How far the ball reaches in a direction.
  [[nodiscard]] double height(const ModelVector& way) const {
    if (!bulge_ || glm::dot(way, axis_) < cosine_) return ball_.radius;
    const double from = 1.1 * top_;
    const auto hit = bulge_->nearest_hit({way * from, -way});
    return hit ? std::max(ball_.radius, from - hit->distance) : ball_.radius;
  }
  /// Where a point goes in a direction that was at a level above a height: no deeper than it was, and a little above
  /// where it was above.
  [[nodiscard]] double over(const ModelVector& way, double level, double before) const {
    if (!bulge_) return level;
    return std::max(level, height(way) + std::min(level - before, k_clear * ball_.radius));
  }

  Ball ball_;
  std::optional<geometry::TriangleBvh> bulge_;  ///< about the centre
  ModelVector axis_{0};
  double cosine_ = 1;
  double top_ = 0;
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

}  // namespace

std::shared_ptr<const HeldSurface> ball_under(const Canvas& canvas, std::uint32_t vertex,
                                              const CurvesOverBall& curves) {
  const auto of = canvas.mesh().components();
  std::optional<Ball> ball;
  std::uint32_t piece = 0;
  for (const std::uint32_t one : pieces_about(canvas, of[vertex], curves.reference)) {
    std::vector<ModelPoint> points;
    for (std::size_t v = 0; v < of.size(); ++v) {
      if (of[v] == one) points.push_back(canvas.positions()[v]);
    }
    const auto found = fitted_ball(points);
    // Of balls within each other the curve lies on the outermost.
    if (!found || !lies_on(*found, curves) || (ball && found->radius <= ball->radius)) continue;
    ball = found;
    piece = one;
  }
  if (!ball) return nullptr;
  std::vector<mesh::Triangle> bulging;
  for (const mesh::Triangle& t : canvas.mesh().triangles()) {
    if (of[t[0]] != piece) continue;
    double highest = 0;
    for (const std::uint32_t v : t) {
      highest = std::max(highest, geometry::distance(canvas.positions()[v], ball->center));
    }
    if (highest > (1 + k_bulge) * ball->radius && highest < k_highest_bulge * ball->radius) bulging.push_back(t);
  }
  return std::make_shared<const HeldBall>(*ball, canvas.positions(), bulging);
}

}  // namespace penpose::articulation
