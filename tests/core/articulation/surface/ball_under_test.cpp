#include "core/articulation/surface/ball_under.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <iostream>
#include <string>

#include "core/articulation/deformer.h"
#include "core/articulation/motion/attachment.h"
#include "core/geometry/closest_point.h"
#include "tests/support/models/articulation_models.h"
#include "tests/support/models/marked_face.h"

namespace penpose::articulation {
namespace {

using Line = std::vector<PxPoint>;

/// A model with an open eye, and the lines of its lids as they are at rest, corner to corner.
struct LidStage {
  std::string name;
  std::shared_ptr<const Canvas> canvas;
  geometry::Camera camera;
  Line upper;
  Line lower;
  std::vector<mesh::Triangle> eye;
  std::uint32_t skin = 0;          ///< the piece that the lids belong to
  std::vector<ModelPoint> margin;  ///< of the upper lid
};

Line seen(const geometry::Camera& camera, std::span<const ModelPoint> points) {
  Line line;
  for (const ModelPoint& p : points) line.push_back(*camera.project(p));
  if (line.front().x > line.back().x) std::reverse(line.begin(), line.end());
  return line;
}

/// The place of a line at a share of its points.
PxPoint at(const Line& line, double share) {
  const double place = share * static_cast<double>(line.size() - 1);
  const auto k = std::min(line.size() - 2, static_cast<std::size_t>(place));
  return line[k] + (line[k + 1] - line[k]) * (place - static_cast<double>(k));
}

Line part(const Line& line, double from, double to) {
  Line out;
  for (int i = 0; i <= 40; ++i) out.push_back(at(line, from + (to - from) * i / 40.0));
  return out;
}

double distance_to(PxPoint p, const Line& line) {
  double least = 1e300;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const double u = geometry::nearest_share(p, line[k], line[k + 1]);
    least = std::min(least, geometry::distance(p, line[k] + (line[k + 1] - line[k]) * u));
  }
  return least;
}

/// A lid sketched as a user would: around it, around its margin, along the margin from corner to corner, and where it
/// is to go, towards the other margin.
Sketch lid_sketch(const LidStage& stage, Reach reach, double closed) {
  Sketch sketch;
  sketch.name = "lid";
  sketch.viewport = stage.camera.viewport();
  sketch.camera = stage.camera.pose();
  sketch.reach = reach;
  const double width = geometry::distance(stage.upper.front(), stage.upper.back());
  const auto between = [&](int i, double share) {
    return at(stage.upper, i / 40.0) + (at(stage.lower, i / 40.0) - at(stage.upper, i / 40.0)) * share;
  };
  // Above the margin by a share of the eye's width, below it by one of the opening, and beyond the corners.
  const auto lasso = [&](double above, double below, double beyond) {
    Line out;
    const PxPoint up{0, -above * width};
    const PxPoint side{beyond * width, 0};
    out.push_back(between(0, 0) - side);
    out.push_back(between(0, 0) - side + up);
    for (int i = 0; i <= 40; ++i) out.push_back(between(i, 0) + up);
    out.push_back(between(40, 0) + side + up);
    out.push_back(between(40, 0) + side);
    for (int i = 40; i >= 0; --i) out.push_back(between(i, below));
    return out;
  };
  sketch.general = lasso(0.45, 0.35, 0.1);
  sketch.specific = lasso(0.04, 0.25, 0.0);
  sketch.reference = part(stage.upper, 0, 1);
  for (int i = 0; i <= 40; ++i) sketch.target.push_back(between(i, closed));
  return sketch;
}

/// Built with the piece of the model that is the lid: the button for the next piece chooses it.
std::shared_ptr<const Deformer> built_lid(const LidStage& stage, Sketch sketch) {
  std::shared_ptr<const Deformer> lid;
  for (sketch.piece = 0; sketch.piece < 8; ++sketch.piece) {
    auto one = build_deformer(sketch, *stage.canvas);
    if (!one.ok()) break;
    const bool of_skin = stage.canvas->mesh().components()[one.value()->vertices().front()] == stage.skin;
    if (of_skin && (!lid || one.value()->vertices().size() > lid->vertices().size())) lid = std::move(one).value();
  }
  return lid;
}

struct Figures {
  double deepest = 0;      ///< in the eye beyond where it was at rest, in its radii
  double from_target = 0;  ///< of the margin as seen at 1, the farthest point, in widths of the eye
  bool slides = false;
};

Figures measure(const LidStage& stage, const Deformer& lid) {
  const geometry::ClosestPointTree eye(stage.canvas->positions(), stage.eye);
  geometry::Box box;
  for (const mesh::Triangle& t : stage.eye) {
    for (const std::uint32_t v : t) box.add(stage.canvas->positions()[v]);
  }
  const double radius = box.diagonal() / std::sqrt(12.0);
  const auto rest = stage.canvas->positions();
  const double width = geometry::distance(stage.upper.front(), stage.upper.back());
  const double length = geometry::distance(stage.margin.front(), stage.margin.back());
  Attachment near(stage.margin);
  Figures figures;
  figures.slides = lid.skin().motion().slide() != nullptr;
  for (int i = 1; i <= 20; ++i) {
    const auto moves = lid.displacements(i / 20.0);
    for (std::size_t k = 0; k < moves.size(); ++k) {
      const ModelPoint& was = rest[lid.vertices()[k]];
      if (geometry::length(moves[k]) < 1e-3 * radius) continue;
      // What lies behind the middle of the eye is its socket, not its lid.
      if (glm::dot(was - box.center(), stage.camera.eye() - box.center()) < 0) continue;
      const double before = std::min(0.0, eye.signed_distance(was));
      figures.deepest = std::max(figures.deepest, (before - eye.signed_distance(was + moves[k])) / radius);
      if (i != 20 || lid.weights()[k] < 0.999) continue;
      // Of the margin alone: what else is under the line as it is seen lies behind.
      near.attach(was);
      if (near.distance() > 0.01 * length) continue;
      const double now = distance_to(*stage.camera.project(was + moves[k]), lid.sketch().target);
      figures.from_target = std::max(figures.from_target, now / width);
    }
  }
  return figures;
}

void expect_lid(const LidStage& stage, Reach reach, double closed) {
  const std::string name = stage.name + (reach == Reach::front ? " front " : " through ") + std::to_string(closed);
  const Sketch sketch = lid_sketch(stage, reach, closed);
  const auto built = built_lid(stage, sketch);
  ASSERT_TRUE(built) << name;
  const Figures figures = measure(stage, *built);
  if (std::getenv("PENPOSE_FIGURES") != nullptr) {
    Sketch straight = sketch;
    straight.surface = Free{};
    const auto free = built_lid(stage, straight);
    const Figures before = measure(stage, *free);
    std::cout << name << ": deep " << before.deepest << " -> " << figures.deepest << ", from target "
              << before.from_target << " -> " << figures.from_target << ", turned over " << free->strain().turned_over
              << " -> " << built->strain().turned_over << '\n';
  }
  EXPECT_TRUE(figures.slides) << name;
  EXPECT_LE(figures.deepest, 0.005) << name;
  EXPECT_LE(figures.from_target, 0.035) << name;
  EXPECT_EQ(built->strain().turned_over, 0U) << name;
}

void expect_made_up(const LidStage& stage) {
  expect_lid(stage, Reach::through, 0.5);
  expect_lid(stage, Reach::front, 1.0);
}

/// Lids with thick rims, whose hidden sides only `through` takes.
void expect_face(const LidStage& stage) {
  for (const double closed : {0.3, 0.5, 0.8, 1.0}) expect_lid(stage, Reach::through, closed);
}

/// The triangles of the piece of the model that has this box's size and lies nearest behind the middle of the eye.
std::vector<mesh::Triangle> triangles_of(const Canvas& canvas, std::uint32_t piece) {
  std::vector<mesh::Triangle> some;
  const auto weld = canvas.mesh().weld();
  for (const mesh::Triangle& t : canvas.mesh().triangles()) {
    if (canvas.mesh().components()[t[0]] == piece) some.push_back({weld[t[0]], weld[t[1]], weld[t[2]]});
  }
  return some;
}

/// The largest piece of those whose box is as a ball's, about a point.
std::uint32_t ball_about(const Canvas& canvas, const ModelPoint& lid, double width) {
  std::vector<geometry::Box> boxes(canvas.mesh().component_count());
  for (std::size_t v = 0; v < canvas.positions().size(); ++v) {
    boxes[canvas.mesh().components()[v]].add(canvas.positions()[v]);
  }
  std::uint32_t best = 0;
  double most = 0;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    const ModelVector size = boxes[i].maximum - boxes[i].minimum;
    const bool round = std::min({size.x, size.y, size.z}) > 0.7 * std::max({size.x, size.y, size.z});
    if (!round || geometry::distance(boxes[i].center(), lid) > width || boxes[i].diagonal() <= most) continue;
    best = i;
    most = boxes[i].diagonal();
  }
  return best;
}

/// The piece with the vertex nearest to a point.
std::uint32_t piece_at(const Canvas& canvas, const ModelPoint& point) {
  const auto nearer = [&](const ModelPoint& a, const ModelPoint& b) {
    return geometry::distance(a, point) < geometry::distance(b, point);
  };
  const auto positions = canvas.positions();
  const auto nearest = std::min_element(positions.begin(), positions.end(), nearer);
  return canvas.mesh().components()[static_cast<std::size_t>(nearest - positions.begin())];
}

LidStage face_stage(const std::string& name, const tests::MarkedFace& face) {
  const auto& upper = face.curves.at("eyelid_upper_L");
  const auto& lower = face.curves.at("eyelid_lower_L");
  const double width = geometry::distance(upper.front(), upper.back());
  const ModelPoint& middle = upper[upper.size() / 2];
  geometry::Box box;
  for (const ModelPoint& p : face.canvas->positions()) {
    if (geometry::distance(p, middle) < 4 * width) box.add(p);
  }
  const auto camera = geometry::frame_box(box, {1000, 1000}, 0, 0);
  return {name,
          face.canvas,
          camera,
          seen(camera, upper),
          seen(camera, lower),
          triangles_of(*face.canvas, ball_about(*face.canvas, middle, width)),
          piece_at(*face.canvas, middle),
          upper};
}

/// How a made-up eye is built: its size, how fine skin and ball are, how far the lids lie off it, and how far a cornea
/// rises.
struct MadeUp {
  double scale = 1;
  std::uint32_t rings = 24;
  std::uint32_t columns = 96;
  std::uint32_t rows = 41;
  double off = 0.02;
  double cornea = 0;
  double half = -90;  ///< degrees: where the ball ends behind
};

LidStage made_up(const std::string& name, const MadeUp& how) {
  tests::Eye eye;
  eye.shell = eye.radius * (1 + how.off);
  const auto bulge = [&](const ModelPoint& d) { return 1 + how.cornea * std::max(0.0, (d.z - 0.85) / 0.15); };
  // The lids lie on the cornea where they cover it.
  const auto on_lid = [&](double azimuth, double elevation) {
    const ModelPoint d = eye.on_shell(azimuth, elevation, 1) - eye.center;
    return (eye.center + d * (eye.shell * bulge(d))) * how.scale;
  };
  mesh::MeshSource source;
  tests::add_grid(source, "skin", how.rings, how.columns, true, [&](std::uint32_t r, std::uint32_t c) {
    const double angle = 360.0 * tests::k_degree * c / how.columns;
    const double s = static_cast<double>(r) / (how.rings - 1);
    const double up = std::sin(angle);
    const double azimuth = std::cos(angle) * (tests::Eye::k_corner + (80 - tests::Eye::k_corner) * s);
    const double edge =
        tests::Eye::margin(std::cos(angle) * tests::Eye::k_corner, up > 0 ? tests::Eye::k_upper : tests::Eye::k_lower);
    return on_lid(azimuth, edge + (70 * up - edge) * s);
  });
  // The grid faces inward.
  for (mesh::Triangle& t : source.triangles) std::swap(t[1], t[2]);
  // Its pole looks ahead, as those of eyes do.
  tests::add_grid(source, "ball", how.rows, 2 * how.rows - 2, true, [&](std::uint32_t r, std::uint32_t c) {
    const double from = std::max(-89.9, how.half);
    const double e = (from + (89.9 - from) * r / (how.rows - 1)) * tests::k_degree;
    const double a = 360.0 * tests::k_degree * c / (2 * how.rows - 2);
    const ModelPoint d{std::cos(a) * std::cos(e), std::sin(a) * std::cos(e), std::sin(e)};
    return (eye.center + d * (eye.radius * bulge(d))) * how.scale;
  });
  eye.camera.eye = eye.camera.eye * how.scale;
  eye.camera.look_at = eye.camera.look_at * how.scale;
  const auto canvas = tests::canvas_of(std::move(source));
  const auto camera = geometry::Camera::make(eye.camera, eye.viewport).value();
  const auto margin = [&](double middle) {
    std::vector<ModelPoint> points;
    for (int i = 0; i <= 60; ++i) {
      const double azimuth = tests::Eye::k_corner * (i / 30.0 - 1);
      points.push_back(on_lid(azimuth, tests::Eye::margin(azimuth, middle)));
    }
    return points;
  };
  return {name,
          canvas,
          camera,
          seen(camera, margin(tests::Eye::k_upper)),
          seen(camera, margin(tests::Eye::k_lower)),
          triangles_of(*canvas, canvas->mesh().components().back()),
          canvas->mesh().components().front(),
          margin(tests::Eye::k_upper)};
}

TEST(BallUnder, LidsGoAroundBallsOfAnySizeAndDensity) {
  expect_made_up(made_up("usual", {}));
  expect_made_up(made_up("small", {.scale = 0.01}));
  expect_made_up(made_up("coarse ball", {.rows = 13}));
  expect_made_up(made_up("coarse lid", {.rings = 10, .columns = 40}));
  expect_made_up(made_up("fine", {.scale = 30, .rings = 40, .columns = 160, .rows = 81}));
  expect_made_up(made_up("thick lid", {.off = 0.12}));
  expect_made_up(made_up("half a ball", {.half = 0}));
}

TEST(BallUnder, LidsGoAroundACornea) {
  expect_made_up(made_up("cornea", {.cornea = 0.06}));
  expect_made_up(made_up("fine cornea", {.rings = 40, .columns = 160, .rows = 81, .off = 0.01, .cornea = 0.1}));
}

TEST(BallUnder, ALidGoesAroundBetweenItsTargetsToo) {
  const LidStage stage = made_up("usual", {});
  Sketch sketch = lid_sketch(stage, Reach::through, 1.0);
  // Slow at first: half-way it has hardly begun.
  sketch.betweens = {{0.5, lid_sketch(stage, Reach::through, 0.15).target, std::nullopt}};
  const Figures figures = measure(stage, *built_lid(stage, sketch));
  EXPECT_TRUE(figures.slides);
  EXPECT_LE(figures.deepest, 0.005);
  EXPECT_LE(figures.from_target, 0.03);
}

/// Sheets that are not over a ball are left alone: a ball behind them, and one that is far away.
TEST(BallUnder, NothingIsABallThatTheCurveDoesNotLieOn) {
  for (const double off : {0.6, 2.0}) {
    const LidStage stage = made_up("far", {.off = off});
    const auto built = built_lid(stage, lid_sketch(stage, Reach::through, 1.0));
    ASSERT_TRUE(built);
    EXPECT_EQ(built->skin().motion().slide(), nullptr) << off;
  }
}

TEST(BallUnder, LidsOfTheBuiltInHeadGoAroundItsEyes) { expect_face(face_stage("built-in", tests::built_in_face())); }

TEST(SharedBallUnder, LidsOfFacesGoAroundTheirEyes) {
  if (!tests::has_shared()) GTEST_SKIP();
  expect_face(face_stage("narrow", tests::shared_face("ict_face_narrow.glb")));
  expect_face(face_stage("avatar", tests::shared_face("ict_avatar.glb")));
  // With lashes, and with sockets behind the eyes that belong to the skin.
  expect_face(face_stage("lashes", tests::shared_face("ict_face.glb")));
}

/// Kept aside while the rules were made.
TEST(SharedBallUnder, LidsThatNothingWasChosenOnGoAroundTheirEyes) {
  if (!tests::has_shared() || std::getenv("PENPOSE_HELD_OUT") == nullptr) GTEST_SKIP();
  expect_made_up(made_up("other", {.scale = 0.3, .rings = 17, .columns = 70, .rows = 23, .off = 0.05, .cornea = 0.08}));
}

}  // namespace
}  // namespace penpose::articulation
