#include "core/articulation/sketch.h"

#include <cmath>
#include <span>

#include "core/geometry/lasso.h"

namespace penpose::articulation {
namespace {

std::optional<base::Error> check_curve(std::span<const PxPoint> curve, const std::string& key) {
  if (curve.size() > k_most_points) return base::Error{"the curve has too many points", key, "use at most 100,000"};
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (!(std::abs(curve[i].x) <= geometry::k_largest_px && std::abs(curve[i].y) <= geometry::k_largest_px)) {
      return base::Error{"the point lies beyond a million px", key + "/" + std::to_string(i), "draw the curve again"};
    }
  }
  return std::nullopt;
}

std::optional<base::Error> check_ball(const Surface& surface) {
  const auto* ball = std::get_if<Sphere>(&surface);
  if (ball == nullptr) return std::nullopt;
  const ModelPoint& c = ball->center;
  if (!std::isfinite(c.x) || !std::isfinite(c.y) || !std::isfinite(c.z)) {
    return base::Error{"the centre of the ball is not finite", "surface/sphere/center", "give three plain numbers"};
  }
  if (!(ball->radius > 0.0) || !std::isfinite(ball->radius)) {
    return base::Error{"the ball has no radius", "surface/sphere/radius", "give a radius above 0"};
  }
  return std::nullopt;
}

void add_vector(base::StateHash& hash, const ModelVector& v) {
  hash.add(v.x);
  hash.add(v.y);
  hash.add(v.z);
}

void add_camera(base::StateHash& hash, const geometry::CameraPose& camera) {
  add_vector(hash, camera.eye);
  add_vector(hash, camera.look_at);
  add_vector(hash, camera.up);
  hash.add(camera.vertical_fov_degrees);
}

void add_camera(base::StateHash& hash, const std::optional<geometry::CameraPose>& camera) {
  hash.add(std::uint64_t{camera.has_value()});
  if (camera) add_camera(hash, *camera);
}

void add_curve(base::StateHash& hash, std::span<const PxPoint> curve) {
  hash.add(std::uint64_t{curve.size()});
  for (const PxPoint& p : curve) {
    hash.add(p.x);
    hash.add(p.y);
  }
}

}  // namespace

base::Status check_sketch(const Sketch& sketch) {
  if (sketch.name.empty()) return base::Error{"the deformer has no name", "name", "give it a name"};
  const auto missing = [](const char* key) {
    return base::Error{std::string("the ") + key + " curve is missing", key, "draw it"};
  };
  if (sketch.general.empty()) return missing("general");
  if (sketch.specific.empty()) return missing("specific");
  if (sketch.target.empty()) return missing("target");
  if (auto error = check_curve(sketch.general, "general")) return *error;
  if (auto error = check_curve(sketch.specific, "specific")) return *error;
  if (auto error = check_curve(sketch.reference, "reference")) return *error;
  if (auto error = check_curve(sketch.target, "target")) return *error;
  if (auto error = check_ball(sketch.surface)) return *error;
  if (!(sketch.minimum <= 0.0 && sketch.maximum > 0.0) || sketch.minimum < -k_widest_amount ||
      sketch.maximum > k_widest_amount) {
    return base::Error{"the range does not start at or below 0 and end above it", "range",
                       "use 0 to 1, or a wider range within -10 to 10"};
  }
  return base::Done{};
}

void add_to_hash(base::StateHash& hash, const Sketch& sketch) {
  hash.add("sketch");
  hash.add(sketch.name);
  hash.add(static_cast<std::uint64_t>(sketch.viewport.width));
  hash.add(static_cast<std::uint64_t>(sketch.viewport.height));
  add_camera(hash, sketch.camera);
  add_camera(hash, sketch.reference_camera);
  add_camera(hash, sketch.target_camera);
  add_curve(hash, sketch.general);
  add_curve(hash, sketch.specific);
  add_curve(hash, sketch.reference);
  add_curve(hash, sketch.target);
  hash.add(static_cast<std::uint64_t>(sketch.mode));
  hash.add(std::uint64_t{sketch.surface.index()});
  if (const auto* ball = std::get_if<Sphere>(&sketch.surface)) {
    add_vector(hash, ball->center);
    hash.add(ball->radius);
  } else if (const auto* surface = std::get_if<PartSurface>(&sketch.surface)) {
    hash.add(surface->part);
  }
  hash.add(sketch.minimum);
  hash.add(sketch.maximum);
  // Only where it says something, so that older documents keep their hash.
  if (sketch.rules >= k_measured_rules) hash.add(std::uint64_t{sketch.rules});
  if (sketch.other_sheet) hash.add("other sheet");
}

}  // namespace penpose::articulation
