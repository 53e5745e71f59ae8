#include "core/articulation/deformer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/articulation/measured_deformer.h"
#include "core/articulation/motion/reference_curve.h"
#include "core/articulation/motion/slide.h"
#include "core/articulation/region/region.h"
#include "core/articulation/surface/ball_under.h"
#include "core/curve/nearest_place.h"
#include "core/curve/pairing.h"
#include "core/curve/polyline.h"

namespace penpose::articulation {
namespace {

using Curve = std::vector<ModelPoint>;

/// Puts the key of the sketch in front of an error's place.
base::Error at(const char* key, base::Error error) {
  error.place = error.place.empty() ? key : std::string(key) + "/" + error.place;
  return error;
}

base::Result<geometry::Camera> camera_of(const Sketch& sketch, const std::optional<geometry::CameraPose>& own) {
  return geometry::Camera::make(own ? *own : sketch.camera, sketch.viewport);
}

struct Cameras {
  geometry::Camera regions, target;
};
base::Result<Cameras> cameras_of(const Sketch& sketch) {
  const auto regions = camera_of(sketch, std::nullopt);
  if (!regions) return at("camera", regions.error());
  const auto target = camera_of(sketch, sketch.target_camera);
  if (!target) return at("target_camera", target.error());
  return Cameras{*regions, *target};
}

/// The reference curve, inferred or drawn, which stays on one sheet but for deformers of the paper.
base::Result<SheetReference> reference_of(const Sketch& sketch, const Canvas& canvas, const Region& region,
                                          std::span<const std::uint32_t> specific, std::size_t points,
                                          const MeantTriangles& meant) {
  if (sketch.reference.empty()) {
    auto inferred = infer_reference(canvas, region, specific, points);
    if (!inferred) return at("specific", inferred.error());
    return SheetReference{std::move(*inferred), {}, 1};
  }
  const auto camera = camera_of(sketch, sketch.reference_camera);
  if (!camera) return at("reference_camera", camera.error());
  if (sketch.paper) {
    auto drawn = drawn_reference(canvas, *camera, sketch.reference, points);
    if (!drawn) return at("reference", drawn.error());
    return SheetReference{std::move(*drawn), {}, 1};
  }
  auto drawn = sheet_reference(canvas, *camera, sketch.reference, points,
                               sketch.other_sheet ? curve::SheetChoice::other : curve::SheetChoice::nearer, meant);
  if (!drawn) return at("reference", drawn.error());
  return drawn;
}

/// Lifts every point of the target onto the level of its reference point.
void lift_onto_surface(const geometry::Camera& camera, const KeptSurface& surface, const Curve& reference,
                       Curve& target) {
  if (!surface.exists()) return;
  for (std::size_t i = 0; i < target.size(); ++i) {
    const double near = geometry::distance(target[i], camera.eye());
    const geometry::Ray ray{camera.eye(), geometry::normalized(target[i] - camera.eye(), camera.forward())};
    target[i] = ray.origin + ray.direction * surface.lift(ray, near, surface.level(reference[i]));
  }
}

/// The automatic choice: translate when both ends stay (method, section 3).
Mode choose_mode(const Sketch& sketch, const geometry::Camera& camera, const Curve& reference, const Curve& target) {
  if (sketch.mode != Mode::automatic) return sketch.mode;
  const double near = curve::pairing_distance_px(camera.viewport());
  const auto stays = [&](const ModelPoint& r, const ModelPoint& t) {
    const auto a = camera.project(r);
    const auto b = camera.project(t);
    return a && b && geometry::distance(*a, *b) <= near;
  };
  return stays(reference.front(), target.front()) && stays(reference.back(), target.back()) ? Mode::translate
                                                                                            : Mode::rotate;
}

bool all_finite(const Curve& curve) {
  return std::all_of(curve.begin(), curve.end(), [](const ModelPoint& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  });
}

/// The curves of a deformer, with equally many points.
struct Curves {
  Curve reference;
  Curve target;
  bool turned_round = false;
  double kept = 1;
  KeptSurface surface;
};

/// Both curves, the target still where it was drawn before what is seen; `meant`: as of sheet_reference.
base::Result<Curves> drawn_curves(const Sketch& sketch, const Canvas& canvas, const Region& region,
                                  std::span<const std::uint32_t> specific, const geometry::Camera& target_camera,
                                  std::size_t points, const MeantTriangles& meant = {}) {
  auto reference = reference_of(sketch, canvas, region, specific, points, meant);
  if (!reference) return reference.error();
  if (sketch.reference.empty() && !sketch.paper)
    begin_where_attached(canvas, region, specific, target_camera, sketch.target, reference->points);
  auto paired = curve::pair_target(reference->points, sketch.target, target_camera);
  if (!paired) return at("target", paired.error());
  Curves curves{std::move(reference->points), std::move(paired->points), paired->reversed && !sketch.reference.empty(),
                reference->kept, KeptSurface()};
  // A line that sticks to a rim beside the pen is meant to go as far as the pen went.
  for (std::size_t i = 0; i < reference->aside.size(); ++i) curves.target[i] -= reference->aside[i];
  return curves;
}

/// The ball that the curves lie on, if they do. A line that was drawn over a lid is meant for its margin, though it
/// touches the eye or its lashes beside it: where the margin lies on a ball, the curves become those of the margin.
void find_ball(const Sketch& sketch, const Canvas& canvas, const Region& region,
               std::span<const std::uint32_t> specific, const geometry::Camera& target_camera, std::size_t points,
               Curves& curves) {
  const auto pieces = canvas.mesh().components();
  const std::uint32_t own = pieces[region.vertices.front()];
  for (const Ball& ball : balls_about(canvas, own, curves.reference)) {
    const auto outside = [&](std::uint32_t v) { return !ball.hides(canvas.positions()[v]); };
    const auto meant = [&](const mesh::Triangle& t) {
      return pieces[t[0]] == own && std::any_of(t.begin(), t.end(), outside);
    };
    std::optional<Curves> margin;
    if (!sketch.reference.empty()) {
      auto drawn = drawn_curves(sketch, canvas, region, specific, target_camera, points, meant);
      if (!drawn || !all_finite(drawn->target)) continue;
      margin = std::move(*drawn);
    }
    const Curves& some = margin ? *margin : curves;
    auto held = ball_under(canvas, ball, {some.reference, some.target, target_camera});
    if (!held) continue;
    if (margin) curves = std::move(*margin);
    curves.surface = KeptSurface(std::move(held));
    return;
  }
}

/// Steps 3 and 4 of the method. Where no surface was chosen, the ball under the curves is one.
base::Result<Curves> curves_of(const Sketch& sketch, const Canvas& canvas, const Region& region,
                               std::span<const std::uint32_t> specific, const geometry::Camera& target_camera,
                               const KeptSurface& surface, std::size_t points) {
  auto curves = drawn_curves(sketch, canvas, region, specific, target_camera, points);
  if (!curves) return curves;
  curves->surface = surface;
  const bool chosen = sketch.paper || !std::holds_alternative<std::monostate>(sketch.surface);
  if (!chosen && all_finite(curves->target)) {
    find_ball(sketch, canvas, region, specific, target_camera, points, *curves);
  }
  lift_onto_surface(target_camera, curves->surface, curves->reference, curves->target);
  if (!all_finite(curves->reference) || !all_finite(curves->target)) {
    return base::Error{"the target lies too far away for numbers", "target", "draw it nearer to the model"};
  }
  return curves;
}

base::Error region_error(base::Error error) { return error.place == "piece" ? error : at("general", std::move(error)); }

/// Where the curve is at the values of the other targets, one list a target, from what was drawn for each: the motion's
/// own place there tells which way round the line runs and how deep it lies.
base::Result<std::vector<Curve>> between_targets(const Sketch& sketch, const CurveMotion& motion,
                                                 const KeptSurface& surface) {
  std::vector<Curve> targets;
  for (std::size_t i = 0; i < sketch.betweens.size(); ++i) {
    const Between& one = sketch.betweens[i];
    const std::string key = "betweens/" + std::to_string(i);
    const auto camera = camera_of(sketch, one.camera);
    if (!camera) return at((key + "/camera").c_str(), camera.error());
    const Curve there = motion.points(one.value);
    auto paired = curve::pair_target(there, one.target, *camera);
    if (!paired) return at((key + "/target").c_str(), paired.error());
    const auto reference = motion.reference();
    lift_onto_surface(*camera, surface, {reference.begin(), reference.end()}, paired->points);
    if (!all_finite(paired->points)) {
      return base::Error{"the target lies too far away for numbers", key + "/target", "draw it nearer to the model"};
    }
    targets.push_back(std::move(paired->points));
  }
  return targets;
}

/// Amounts at which a deformer with other targets is measured: at all of them, its ends, and half-way between.
std::vector<double> measured_amounts(const Sketch& sketch) {
  std::vector<double> ends{sketch.minimum, sketch.maximum, 0.0, 1.0};
  for (const Between& one : sketch.betweens) ends.push_back(one.value);
  std::stable_sort(ends.begin(), ends.end());
  std::vector<double> amounts{ends.front()};
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (!(ends[i] > ends[i - 1])) continue;
    amounts.push_back(0.5 * (ends[i - 1] + ends[i]));
    amounts.push_back(ends[i]);
  }
  return amounts;
}

/// Leads a motion through the other targets. Each is a motion of its own from the same reference, which is held
/// together as any.
base::Result<std::vector<Curve>> add_betweens(const Sketch& sketch, const MeasuredParts& parts,
                                              MeasuredMotion& motion) {
  auto targets = between_targets(sketch, motion.skin.motion(), parts.surface);
  if (!targets) return targets.error();
  std::vector<BetweenDisplacements> vertices;
  std::vector<BetweenDisplacements> nodes;
  CurveSkinWorkspace work;
  for (std::size_t i = 0; i < targets->size(); ++i) {
    MeasuredParts own = parts;
    own.target = (*targets)[i];
    const auto there = measured_motion(own, sketch.mode, {});
    if (!there) return at("general", there.error());
    const double amount = sketch.betweens[i].value;
    vertices.push_back({amount, std::vector<ModelVector>(there->skin.size())});
    there->skin.displacements(1.0, work, vertices.back().moves);
    nodes.push_back({amount, std::vector<ModelVector>(there->of_nodes.size())});
    there->of_nodes.displacements(1.0, work, nodes.back().moves);
  }
  motion.skin.add_betweens(std::move(vertices));
  motion.of_nodes.add_betweens(std::move(nodes));
  motion.strain = strain_at(parts, motion.of_nodes, measured_amounts(sketch));
  return targets;
}

}  // namespace

std::vector<ModelPoint> Deformer::curve_at(double amount) const {
  const CurveMotion& motion = built_->skin.motion();
  std::vector<ModelPoint> points = motion.points(amount);
  if (sketch_.betweens.empty()) return points;
  std::vector<double> amounts;
  for (const Between& one : sketch_.betweens) amounts.push_back(one.value);
  const std::vector<Knot> knots = knots_of(amounts);
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const double weight = knots[i].weight(amount);
    if (weight == 0.0) continue;
    const std::vector<ModelPoint> there = motion.points(amounts[i]);
    for (std::size_t k = 0; k < points.size(); ++k) points[k] += (built_->betweens[i][k] - there[k]) * weight;
  }
  return points;
}

std::vector<ModelVector> Deformer::displacements(double amount) const {
  CurveSkinWorkspace work;
  std::vector<ModelVector> moves(vertices().size());
  skin().displacements(amount, work, moves);
  return moves;
}

base::Result<std::shared_ptr<const Deformer>> Deformer::renamed(std::string name) const {
  auto other = std::make_shared<Deformer>(*this);
  other->sketch_.name = std::move(name);
  if (auto checked = check_sketch(other->sketch_); !checked) return checked.error();
  return std::shared_ptr<const Deformer>(std::move(other));
}

base::Result<std::shared_ptr<const Deformer>> Deformer::with_range(double minimum, double maximum) const {
  auto other = std::make_shared<Deformer>(*this);
  other->sketch_.minimum = minimum;
  other->sketch_.maximum = maximum;
  if (auto checked = check_sketch(other->sketch_); !checked) return checked.error();
  return std::shared_ptr<const Deformer>(std::move(other));
}

base::Result<std::shared_ptr<const Deformer>> Deformer::measured(const Sketch& sketch, const Canvas& canvas,
                                                                 std::size_t points) {
  const auto cameras = cameras_of(sketch);
  if (!cameras) return cameras.error();
  const auto surface = KeptSurface::make(sketch.surface, canvas);
  if (!surface) return surface.error();
  const auto region = general_region(canvas, cameras->regions, sketch.general, *surface, Borders::skipped,
                                     {sketch.reach, sketch.piece});
  if (!region) return region_error(region.error());
  const auto lasso = geometry::Lasso::make(sketch.specific);
  if (!lasso) return at("specific", lasso.error());
  const auto general = geometry::Lasso::make(sketch.general);
  if (!general) return at("general", general.error());
  if (const auto whole = check_crossing(sketch.general); !whole) return at("general", whole.error());
  if (const auto whole = check_crossing(sketch.specific); !whole) return at("specific", whole.error());
  const Patch patch(canvas, *region);
  const Falloff falloff(patch, {cameras->regions, *general, *lasso});
  std::vector<std::uint32_t> specific;
  for (std::uint32_t i = 0; i < region->vertices.size(); ++i) {
    if (falloff.specific()[patch.nodes()[i]] != 0) specific.push_back(i);
  }
  if (specific.empty()) return at("specific", core_outside(*region, sketch.specific));
  auto curves = curves_of(sketch, canvas, *region, specific, cameras->target, *surface, points);
  if (!curves) return curves.error();
  std::string doubtful =
      sketch.reference.empty() ? doubt_of_inferred(canvas, *region, specific, curves->reference) : std::string();
  const MeasuredParts parts{canvas,
                            *region,
                            patch,
                            falloff,
                            std::move(curves->reference),
                            std::move(curves->target),
                            curves->surface,
                            !sketch.betweens.empty(),
                            std::holds_alternative<std::monostate>(sketch.surface)};
  auto motion = measured_motion(parts, sketch.mode, {sketch.minimum, sketch.maximum});
  if (!motion) return at("general", motion.error());
  std::vector<Curve> betweens;
  if (!sketch.betweens.empty()) {
    auto added = add_betweens(sketch, parts, *motion);
    if (!added) return added.error();
    betweens = std::move(*added);
  }
  auto deformer = std::make_shared<Deformer>();
  deformer->sketch_ = sketch;
  deformer->built_ = std::make_shared<const Built>(Built{std::move(motion->skin), std::move(motion->vertices),
                                                         std::move(motion->weights), curves->turned_round,
                                                         motion->strain, falloff.reaches_beyond(), curves->kept,
                                                         std::move(betweens), region->pieces, std::move(doubtful)});
  return std::shared_ptr<const Deformer>(std::move(deformer));
}

base::Result<std::shared_ptr<const Deformer>> build_deformer(const Sketch& sketch, const Canvas& canvas,
                                                             std::size_t points) {
  if (auto checked = check_sketch(sketch); !checked) return checked.error();
  return sketch.paper ? Deformer::by_paper(sketch, canvas, points) : Deformer::measured(sketch, canvas, points);
}

base::Result<std::shared_ptr<const Deformer>> Deformer::by_paper(const Sketch& sketch, const Canvas& canvas,
                                                                 std::size_t points) {
  const auto cameras = cameras_of(sketch);
  if (!cameras) return cameras.error();
  auto surface = KeptSurface::make(sketch.surface, canvas);
  if (!surface) return surface.error();
  const auto region = general_region(canvas, cameras->regions, sketch.general, *surface, Borders::measured,
                                     {sketch.reach, sketch.piece});
  if (!region) return region_error(region.error());
  const auto weights = specific_region(*region, sketch.specific);
  if (!weights) return at("specific", weights.error());
  auto curves = curves_of(sketch, canvas, *region, weights->specific, cameras->target, *surface, points);
  if (!curves) return curves.error();
  Curve& reference = curves->reference;
  Curve& target = curves->target;
  const Mode mode = choose_mode(sketch, cameras->target, reference, target);
  if (sketch.reference.empty() && mode == Mode::rotate &&
      geometry::distance(reference.back(), target.back()) < geometry::distance(reference.front(), target.front())) {
    std::reverse(reference.begin(), reference.end());
    std::reverse(target.begin(), target.end());
  }

  std::vector<PxPoint> seen;
  for (const ModelPoint& p : reference) {
    const auto px = cameras->regions.project(p);
    if (!px) {
      return base::Error{"the reference curve lies behind the camera of the regions", "reference",
                         "draw it nearer to the region"};
    }
    seen.push_back(*px);
  }
  Deformer::Built built;
  std::vector<ClosestBinding> bindings;
  for (std::size_t i = 0; i < region->vertices.size(); ++i) {
    if (!(weights->weights[i] > 0.0)) continue;
    const std::uint32_t v = region->vertices[i];
    const curve::PolylinePlace place = curve::nearest_place(seen, region->seen[i]);
    auto to_rest = canvas.to_rest(v);
    if (!to_rest) return at("general", to_rest.error());
    bindings.push_back({static_cast<std::uint32_t>(place.segment), place.fraction, weights->weights[i],
                        canvas.positions()[v], *to_rest});
    built.vertices.push_back(v);
    built.weights.push_back(weights->weights[i]);
  }
  built.vertices.shrink_to_fit();
  built.weights.shrink_to_fit();
  built.turned_round = curves->turned_round;
  built.skin = CurveSkin(std::make_shared<const CurveMotion>(std::move(reference), std::move(target), mode),
                         std::move(*surface), bindings, canvas.carried());
  auto deformer = std::make_shared<Deformer>();
  deformer->sketch_ = sketch;
  deformer->built_ = std::make_shared<const Deformer::Built>(std::move(built));
  return std::shared_ptr<const Deformer>(std::move(deformer));
}

}  // namespace penpose::articulation
