#include "core/articulation/deformer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "core/curve/polyline.h"
#include "tests/support/models/articulation_models.h"

namespace penpose::articulation {
namespace {

using tests::Eye;
using tests::Trunk;

/// As the paper says (method, section 3).
std::shared_ptr<const Deformer> built(Sketch sketch, const Canvas& canvas) {
  sketch.paper = true;
  auto deformer = build_deformer(sketch, canvas);
  EXPECT_TRUE(deformer.ok()) << deformer.error().line();
  return std::move(deformer).value();
}

/// All vertices of the model with the deformer at an amount.
std::vector<ModelPoint> posed(const Canvas& canvas, const Deformer& deformer, double amount) {
  std::vector<ModelPoint> positions(canvas.positions().begin(), canvas.positions().end());
  const std::vector<ModelVector> moves = deformer.displacements(amount);
  for (std::size_t i = 0; i < moves.size(); ++i) positions[deformer.vertices()[i]] += moves[i];
  return positions;
}

/// The largest change of a width along the lid: of the sideways extent between neighbours.
double largest_stretch(std::span<const ModelPoint> before, std::span<const ModelPoint> after,
                       std::span<const std::uint32_t> line) {
  double worst = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double was = before[line[i + 1]].x - before[line[i]].x;
    worst = std::max(worst, std::abs((after[line[i + 1]].x - after[line[i]].x) / was - 1.0));
  }
  return worst;
}

TEST(Eyelid, SlidesOverTheBallAtEveryAmount) {
  const Eye eye = tests::make_eye();
  const auto blink = built(eye.blink(), *eye.canvas);
  EXPECT_EQ(blink->mode(), Mode::translate);  // both ends stay at the corners
  const auto rest = eye.canvas->positions();
  for (int step = 0; step <= 20; ++step) {
    const auto now = posed(*eye.canvas, *blink, step / 20.0);
    double farthest = 0;
    for (const std::uint32_t v : blink->vertices()) {
      const double kept = geometry::distance(rest[v], eye.center);
      const double distance = geometry::distance(now[v], eye.center);
      EXPECT_NEAR(distance, kept, 1e-9 * eye.radius);
      EXPECT_GT(distance, eye.radius);
      farthest = std::max(farthest, geometry::distance(now[v], rest[v]));
    }
    EXPECT_LT(largest_stretch(rest, now, Eye::upper_margin()), 0.05) << "amount " << step / 20.0;
    EXPECT_GE(farthest, 0.02 * step * eye.radius);
  }
}

TEST(Eyelid, MeetsTheLowerLidWhenClosed) {
  const Eye eye = tests::make_eye();
  const auto blink = built(eye.blink(), *eye.canvas);
  const auto now = posed(*eye.canvas, *blink, 1.0);
  // Column c of the upper margin has column -c of the lower one below it.
  for (std::uint32_t c = 2; c < Eye::k_columns / 2 - 1; ++c) {
    const PxPoint upper = eye.seen(now[Eye::vertex(0, c)]);
    double nearest = 1e9;
    for (std::uint32_t k = Eye::k_columns / 2; k < Eye::k_columns; ++k) {
      const PxPoint lower = eye.seen(now[Eye::vertex(0, k)]);
      nearest = std::min(nearest, geometry::distance(upper, lower));
    }
    EXPECT_LT(nearest, 9.0) << "column " << c;  // neighbouring columns are about 8 px apart
    EXPECT_NEAR(upper.y, eye.seen(now[Eye::vertex(0, Eye::k_columns - c)]).y, 6.0) << "column " << c;
  }
}

TEST(Eyelid, CutsIntoTheEyeWithoutTheBall) {
  const Eye eye = tests::make_eye();
  Sketch sketch = eye.blink();
  sketch.surface = Free{};
  const auto blink = built(sketch, *eye.canvas);
  const auto half = posed(*eye.canvas, *blink, 0.5);
  std::size_t inside = 0;
  for (const std::uint32_t v : blink->vertices()) {
    if (geometry::distance(half[v], eye.center) < 0.99 * eye.radius) ++inside;
  }
  EXPECT_GT(inside, 50U);
}

TEST(Eyelid, SlidesOverAPartOfTheModelToo) {
  const Eye eye = tests::make_eye();
  Sketch sketch = eye.blink();
  sketch.surface = PartSurface{"ball_L"};
  const auto blink = built(sketch, *eye.canvas);
  const auto kept = KeptSurface::make(sketch.surface, *eye.canvas).value();
  for (const double amount : {0.2, 0.5, 0.9, 1.0}) {
    const auto now = posed(*eye.canvas, *blink, amount);
    for (const std::uint32_t v : blink->vertices()) {
      EXPECT_NEAR(kept.level(now[v]), kept.level(eye.canvas->positions()[v]), 1e-9 * eye.radius);
    }
  }
  sketch.surface = PartSurface{"skull"};
  const auto missing = build_deformer(sketch, *eye.canvas);
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().place, "surface/mesh");
  EXPECT_NE(missing.error().remedy.find("ball_L"), std::string::npos);
}

TEST(Trunk, BendsWithoutThinning) {
  const Trunk trunk = tests::make_trunk();
  const auto curl = built(trunk.curl(), *trunk.canvas);
  EXPECT_EQ(curl->mode(), Mode::rotate);
  const auto now = posed(*trunk.canvas, *curl, 1.0);
  double worst = 0;
  for (std::uint32_t ring = 0; ring < Trunk::k_rings; ++ring) {
    if (Trunk::along(ring) < 0.6) continue;
    for (std::uint32_t c = 0; c < Trunk::k_around / 2; ++c) {  // diameters in every direction
      const std::uint32_t a = ring * Trunk::k_around + c;
      const std::uint32_t b = a + Trunk::k_around / 2;
      worst = std::max(worst, std::abs(geometry::distance(now[a], now[b]) / (2 * Trunk::k_radius) - 1.0));
    }
  }
  EXPECT_LT(worst, 0.10);
  // The tip has turned by a right angle: what pointed along +x points down.
  const std::uint32_t last = (Trunk::k_rings - 1) * Trunk::k_around;
  const ModelVector direction = now[last] - now[last - 4 * Trunk::k_around];
  EXPECT_LT(direction.y, 0.0);
  EXPECT_LT(std::abs(direction.x), 0.1 * std::abs(direction.y));
}

TEST(Trunk, MovesNothingElse) {
  const Trunk trunk = tests::make_trunk();
  const auto curl = built(trunk.curl(), *trunk.canvas);
  const auto now = posed(*trunk.canvas, *curl, 1.0);
  std::size_t still = 0;
  for (std::uint32_t v = 0; v < now.size(); ++v) {
    if (trunk.canvas->positions()[v].x >= 0.35 - 0.02) continue;
    ++still;
    EXPECT_EQ(now[v], trunk.canvas->positions()[v]);
  }
  EXPECT_GT(still, 1000U);
}

TEST(Trunk, BendsFromItsRootWhicheverWayTheReferenceWasInferred) {
  const Trunk trunk = tests::make_trunk();
  Sketch sketch = trunk.curl();
  sketch.reference.clear();
  sketch.mode = Mode::rotate;
  const auto right = built(sketch, *trunk.canvas);
  EXPECT_LT(right->reference().front().x, right->reference().back().x);
  // The same trunk seen from behind: its vertices are ordered from the tip to the root.
  Sketch behind = sketch;
  behind.camera.eye.z = -behind.camera.eye.z;
  for (auto* curve : {&behind.general, &behind.specific, &behind.target}) {
    for (PxPoint& p : *curve) p.x = behind.viewport.width - p.x;
  }
  const auto left = built(behind, *trunk.canvas);
  EXPECT_LT(left->reference().front().x, left->reference().back().x);
}

TEST(Trunk, StaysOnItsBodyWhereTheTargetRunsFromItsRoot) {
  const Trunk trunk = tests::make_trunk();
  for (const bool from_behind : {false, true}) {
    for (const bool from_the_goal : {false, true}) {
      Sketch sketch = trunk.curl();
      sketch.reference.clear();
      sketch.target.clear();
      // Steeply up: its start is nearer to the root, and to the tip as well.
      for (int i = 0; i <= 50; ++i) {
        const double u = i / 50.0;
        sketch.target.push_back(trunk.seen({0.65 + 0.25 * u, 2.2 * u, 0}));
      }
      if (from_the_goal) std::reverse(sketch.target.begin(), sketch.target.end());
      if (from_behind) {
        sketch.camera.eye.z = -sketch.camera.eye.z;
        for (auto* curve : {&sketch.general, &sketch.specific, &sketch.target}) {
          for (PxPoint& p : *curve) p.x = sketch.viewport.width - p.x;
        }
      }
      const auto up = build_deformer(sketch, *trunk.canvas).value();
      const auto now = posed(*trunk.canvas, *up, 1.0);
      ModelPoint tip{0};
      for (std::uint32_t c = 0; c < Trunk::k_around; ++c)
        tip += now[(Trunk::k_rings - 1) * Trunk::k_around + c] / double{Trunk::k_around};
      EXPECT_LT(geometry::distance(tip, {0.9, 2.2, 0}), 0.3) << from_behind << from_the_goal;
    }
  }
}

TEST(Deformer, MovesNothingAtZeroAndReachesTheTargetAtOne) {
  const Eye eye = tests::make_eye();
  const Trunk trunk = tests::make_trunk();
  for (const auto& [sketch, canvas] : {std::pair{eye.blink(), eye.canvas}, {trunk.curl(), trunk.canvas}}) {
    for (const Mode mode : {Mode::translate, Mode::rotate}) {
      Sketch tried = sketch;
      tried.mode = mode;
      const auto deformer = built(tried, *canvas);
      CurveSkinWorkspace work;
      std::vector<ModelVector> moves(deformer->vertices().size(), ModelVector{7});
      deformer->skin().displacements(0.0, work, moves);
      for (const ModelVector& move : moves) EXPECT_EQ(move, ModelVector{0});
      const auto start = deformer->curve_at(0.0);
      const auto end = deformer->curve_at(1.0);
      // The reference's own points, carried with weight 1 and with the surface in the way, reach the target.
      std::vector<ClosestBinding> bindings;
      for (std::uint32_t i = 0; i < start.size(); ++i) {
        const bool last = i + 1 == start.size();
        bindings.push_back({last ? i - 1 : i, last ? 1.0 : 0.0, 1.0, deformer->reference()[i], glm::dmat3(1)});
      }
      const CurveSkin own(std::make_shared<const CurveMotion>(deformer->skin().motion()),
                          KeptSurface::make(tried.surface, *canvas).value(), bindings, false);
      std::vector<ModelVector> own_moves(bindings.size());
      own.displacements(1.0, work, own_moves);
      for (std::size_t i = 0; i < start.size(); ++i) {
        EXPECT_LT(geometry::distance(start[i], deformer->reference()[i]), 1e-12);
        EXPECT_LT(geometry::distance(end[i], deformer->target()[i]), 1e-12);
        EXPECT_LT(geometry::distance(bindings[i].rest + own_moves[i], deformer->target()[i]), 1e-9);
      }
    }
  }
}

TEST(Deformer, PutsTheTargetUnderTheLineThatWasDrawn) {
  const Eye eye = tests::make_eye();
  const Sketch sketch = eye.blink();
  const auto blink = built(sketch, *eye.canvas);
  for (const ModelPoint& p : blink->target()) {
    const PxPoint px = eye.seen(p);
    double nearest = 1e9;
    for (std::size_t i = 0; i + 1 < sketch.target.size(); ++i) {
      for (int k = 0; k <= 100; ++k) {
        const PxPoint q = sketch.target[i] + (sketch.target[i + 1] - sketch.target[i]) * (k / 100.0);
        nearest = std::min(nearest, geometry::distance(px, q));
      }
    }
    EXPECT_LT(nearest, 0.1);
  }
}

TEST(Deformer, ChoosesTheModeByItsEndsAndObeysTheUser) {
  const Eye eye = tests::make_eye();
  Sketch sketch = eye.blink();
  EXPECT_EQ(built(sketch, *eye.canvas)->mode(), Mode::translate);
  sketch.mode = Mode::rotate;
  EXPECT_EQ(built(sketch, *eye.canvas)->mode(), Mode::rotate);
  sketch.mode = Mode::automatic;
  for (PxPoint& p : sketch.target) p.y += 15;
  EXPECT_EQ(built(sketch, *eye.canvas)->mode(), Mode::rotate);
  // On a screen of twice the density the same drawing comes to the same choice.
  Sketch dense = sketch;
  dense.viewport = {2000, 2000};
  for (PxPoint& p : sketch.target) p.y -= 7;
  for (auto* curve : {&dense.general, &dense.specific, &dense.reference, &dense.target}) {
    for (PxPoint& p : *curve) p = p * 2.0;
  }
  for (PxPoint& p : dense.target) p.y -= 14;
  EXPECT_EQ(built(sketch, *eye.canvas)->mode(), Mode::translate);
  EXPECT_EQ(built(dense, *eye.canvas)->mode(), Mode::translate);
}

TEST(Deformer, ExtrapolatesBeyondItsRange) {
  const Trunk trunk = tests::make_trunk();
  const auto curl = built(trunk.curl(), *trunk.canvas);
  const auto wide = curl->with_range(-1, 2).value();
  EXPECT_EQ(wide->parameter().minimum, -1.0);
  EXPECT_EQ(wide->parameter().maximum, 2.0);
  const auto up = posed(*trunk.canvas, *wide, -1.0);
  const std::uint32_t last = (Trunk::k_rings - 1) * Trunk::k_around;
  EXPECT_GT(up[last].y, 1.0);  // bent the other way
  const auto over = posed(*trunk.canvas, *wide, 2.0);
  EXPECT_LT(geometry::distance(over[last], {0.6, -1.53, 0}), 0.4);  // half a turn: below the root
  EXPECT_FALSE(curl->with_range(0.5, 1).ok());
  EXPECT_FALSE(curl->with_range(0, 1e9).ok());
}

TEST(Deformer, TellsWhichCurveIsAtFault) {
  const Eye eye = tests::make_eye();
  const auto place_of = [&](const std::function<void(Sketch&)>& change) {
    Sketch sketch = eye.blink();
    change(sketch);
    const auto deformer = build_deformer(sketch, *eye.canvas);
    EXPECT_FALSE(deformer.ok());
    if (deformer.ok()) return std::string("built");
    EXPECT_FALSE(deformer.error().what.empty());
    EXPECT_FALSE(deformer.error().remedy.empty());
    return deformer.error().place;
  };
  EXPECT_EQ(place_of([](Sketch& s) { s.name.clear(); }), "name");
  EXPECT_EQ(place_of([](Sketch& s) { s.general = {{1, 1}, {2, 2}}; }), "general");
  EXPECT_EQ(place_of([](Sketch& s) { s.general = {{1, 1}, {5, 1}, {3, 4}}; }), "general");  // beside the model
  EXPECT_EQ(place_of([](Sketch& s) { s.specific = {{1, 1}, {5, 1}, {3, 4}}; }), "specific");
  EXPECT_EQ(place_of([](Sketch& s) { s.reference = {{1, 1}, {5, 1}}; }), "reference");
  EXPECT_EQ(place_of([](Sketch& s) { s.target = {{1, 1}}; }), "target");
  EXPECT_EQ(place_of([](Sketch& s) { s.target[3].x = std::nan(""); }), "target/3");
  EXPECT_EQ(place_of([](Sketch& s) { s.camera.eye = s.camera.look_at; }), "camera/eye");
  EXPECT_EQ(place_of([](Sketch& s) {
              s.target_camera = geometry::CameraPose{{0, 0, 1}, {0, 0, 1}};
            }),
            "target_camera/eye");
  EXPECT_EQ(place_of([](Sketch& s) { s.surface = Sphere{{0, 0, 0}, -1}; }), "surface/sphere/radius");
  EXPECT_EQ(place_of([](Sketch& s) { s.minimum = 0.2; }), "range");
}

enum class StrokeKind : std::uint8_t {
  scribble,
  tiny,
  huge,
  closed,
  self_crossing,
  there_and_back,
  beside,
  silhouette
};
constexpr std::array<StrokeKind, 8> k_stroke_kinds{
    StrokeKind::scribble,      StrokeKind::tiny,           StrokeKind::huge,   StrokeKind::closed,
    StrokeKind::self_crossing, StrokeKind::there_and_back, StrokeKind::beside, StrokeKind::silhouette};

/// A stroke on a viewport of 1000 px with the model in its middle.
std::vector<PxPoint> random_stroke(std::mt19937_64& random, StrokeKind kind) {
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const double size = kind == StrokeKind::tiny ? 0.01 : kind == StrokeKind::huge ? 4000 : 400;
  PxPoint middle{uniform() * 1000, uniform() * 1000};
  if (kind == StrokeKind::beside) middle = {-600 - 400 * uniform(), 1700 + 400 * uniform()};
  if (kind == StrokeKind::silhouette) middle = {450 + 100 * uniform(), 450 + 100 * uniform()};
  const double heading = 6.3 * uniform();
  std::vector<PxPoint> stroke;
  const std::size_t count = random() % 5 == 0 ? random() % 4 : 3 + random() % 60;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count);
    const double turn = 6.3 * share;
    switch (kind) {
      case StrokeKind::closed:
        stroke.push_back(middle + PxPoint{std::cos(turn), std::sin(turn)} * (size * (0.5 + 0.3 * uniform())));
        break;
      case StrokeKind::self_crossing:  // an eight
        stroke.push_back(middle + PxPoint{std::sin(turn), std::sin(2 * turn)} * size);
        break;
      case StrokeKind::there_and_back:
        stroke.push_back(i == 0 || i % 2 == 1 ? middle : stroke.front());
        break;
      case StrokeKind::silhouette:  // right across the model, from beside it to beside it
        stroke.push_back(middle + PxPoint{std::cos(heading), std::sin(heading)} * (1200 * (share - 0.5)));
        break;
      default:
        stroke.push_back(middle + PxPoint{uniform() - 0.5, uniform() - 0.5} * size);
    }
  }
  return stroke;
}

/// Draws some of a deformer's curves at random; finite at every amount, or an error that says what is wrong. True:
/// made.
bool survives(const Canvas& canvas, const Sketch& sketch) {
  const auto deformer = build_deformer(sketch, canvas);
  if (!deformer) {
    EXPECT_FALSE(deformer.error().what.empty());
    EXPECT_FALSE(deformer.error().remedy.empty());
    return false;
  }
  for (const double amount : {0.0, 0.3, 1.0, -2.0, 10.0}) {
    for (const ModelPoint& p : posed(canvas, **deformer, amount)) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
        ADD_FAILURE() << "not finite at " << amount;
        return false;
      }
    }
  }
  return true;
}

TEST(Deformer, SurvivesAnyStrokes) {
  const Eye eye = tests::make_eye();
  const Trunk trunk = tests::make_trunk();
  std::mt19937_64 random(20060901);
  for (const StrokeKind kind : k_stroke_kinds) {
    std::size_t made = 0;
    for (int trial = 0; trial < 120; ++trial) {
      const bool lid = trial % 2 == 0;
      Sketch sketch = lid ? eye.blink() : trunk.curl();
      const auto& canvas = lid ? eye.canvas : trunk.canvas;
      for (auto* curve : {&sketch.general, &sketch.specific, &sketch.reference, &sketch.target}) {
        if (random() % 3 == 0) *curve = random_stroke(random, kind);
      }
      sketch.mode = static_cast<Mode>(random() % 3);
      if (random() % 3 == 0) sketch.surface = Sphere{{0.3, 0.1, 0}, 1};
      if (lid && random() % 16 == 0) sketch.surface = PartSurface{"ball_L"};
      if (random() % 4 == 0) {
        sketch.target_camera = sketch.camera;
        sketch.target_camera->eye = {14.0 * static_cast<double>(random() % 3) - 14, 3, 1e-3};
      }
      made += survives(*canvas, sketch) ? 1 : 0;
    }
    EXPECT_GT(made, 15U) << "kind " << static_cast<int>(kind);
    EXPECT_LT(made, 120U) << "kind " << static_cast<int>(kind);
  }
}

TEST(Deformer, SaysWhenItTurnedTheTargetRound) {
  const Trunk trunk = tests::make_trunk();
  Sketch sketch = trunk.curl();
  EXPECT_FALSE(built(sketch, *trunk.canvas)->turned_round());
  std::reverse(sketch.target.begin(), sketch.target.end());
  EXPECT_TRUE(built(sketch, *trunk.canvas)->turned_round());
  // An inferred reference runs in no direction that anyone drew.
  sketch.reference.clear();
  EXPECT_FALSE(built(sketch, *trunk.canvas)->turned_round());
}

}  // namespace
}  // namespace penpose::articulation
