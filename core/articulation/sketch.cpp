#include "core/articulation/sketch.h"

#include <cmath>
#include <span>

#include "core/geometry/lasso.h"

namespace penpose::articulation {
namespace {

/// Targets of values nearer to each other than that would leap.
constexpr double k_apart = 1e-3;

std::optional<base::Error> check_curve(std::span<const PxPoint> curve, const std::string& key) {
  if (curve.size() > k_most_points) return base::Error{"the curve has too many points", key, "use at most 100,000"};
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (!(std::abs(curve[i].x) <= geometry::k_largest_px && std::abs(curve[i].y) <= geometry::k_largest_px)) {
      return base::Error{"the point lies beyond a million px", key + "/" + std::to_string(i), "draw the curve again"};
    }
  }
  return std::nullopt;
}

std::optional<base::Error> check_betweens(const Sketch& sketch) {
  if (sketch.betweens.empty()) return std::nullopt;
  if (sketch.paper) {
    return base::Error{"a control built as the paper says has one target only", "betweens", "draw the control anew"};
  }
  if (sketch.betweens.size() > k_most_betweens) {
    return base::Error{"the control has too many targets", "betweens", "use at most 64 beside its own"};
  }
  for (std::size_t i = 0; i < sketch.betweens.size(); ++i) {
    const Between& one = sketch.betweens[i];
    const std::string key = "betweens/" + std::to_string(i);
    if (!(std::abs(one.value) > k_apart && std::abs(one.value - 1.0) > k_apart)) {
      return base::Error{"at 0 the control rests and at 1 it has its own target", key + "/value", "use another value"};
    }
    if (!(one.value >= sketch.minimum && one.value <= sketch.maximum)) {
      return base::Error{"the value lies outside of the control's range", key + "/value",
                         "use one within it, or widen the range first"};
    }
    if (i > 0 && !(one.value - sketch.betweens[i - 1].value > k_apart)) {
      return base::Error{"the values do not ascend", key + "/value", "order the targets by their values"};
    }
    if (one.target.empty()) return base::Error{"the target curve is missing", key + "/target", "draw it"};
    if (auto error = check_curve(one.target, key + "/target")) return error;
  }
  return std::nullopt;
}

void add(base::StateHash& hash, double value) { hash.add(value); }
void add(base::StateHash& hash, const std::string& text) { hash.add(text); }
void add(base::StateHash& hash, const ModelVector& v) {
  hash.add(v.x);
  hash.add(v.y);
  hash.add(v.z);
}

void add_camera(base::StateHash& hash, const geometry::CameraPose& camera) {
  add(hash, camera.eye);
  add(hash, camera.look_at);
  add(hash, camera.up);
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
  if (sketch.name.empty()) return base::Error{"the control has no name", "name", "give it a name"};
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
  const auto fits = of_surface(sketch.surface, base::Status(base::Done{}), [](const auto& one) { return one.check(); });
  if (!fits) return fits.error();
  if (!(sketch.minimum <= 0.0 && sketch.maximum > 0.0) || sketch.minimum < -k_widest_amount ||
      sketch.maximum > k_widest_amount) {
    return base::Error{"the range does not start at or below 0 and end above it", "range",
                       "use 0 to 1, or a wider range within -10 to 10"};
  }
  if (auto error = check_betweens(sketch)) return *error;
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
  of_surface(sketch.surface, 0, [&](const auto& one) {
    base::each_member(one, [&](std::string_view, const auto& value) { add(hash, value); });
    return 0;
  });
  hash.add(sketch.minimum);
  hash.add(sketch.maximum);
  if (sketch.paper) hash.add("paper");
  if (sketch.other_sheet) hash.add("other sheet");
  if (sketch.reach == Reach::front) hash.add("front only");
  if (sketch.piece != 0) hash.add(std::uint64_t{sketch.piece});
  for (const Between& one : sketch.betweens) {
    hash.add("between");
    hash.add(one.value);
    add_curve(hash, one.target);
    add_camera(hash, one.camera);
  }
}

}  // namespace penpose::articulation
