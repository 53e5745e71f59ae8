#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>

#include "core/articulation/deformer.h"
#include "core/articulation/measure/doubts.h"
#include "core/articulation/motion/slide.h"
#include "tests/support/models/articulation_models.h"

namespace penpose::articulation {
namespace {

using tests::Eye;

std::vector<ModelPoint> posed(const Canvas& canvas, const Deformer& deformer, double amount) {
  std::vector<ModelPoint> positions(canvas.positions().begin(), canvas.positions().end());
  const std::vector<ModelVector> moves = deformer.displacements(amount);
  for (std::size_t i = 0; i < moves.size(); ++i) positions[deformer.vertices()[i]] += moves[i];
  return positions;
}

/// The longest that any edge has become, as a multiple of its length at rest.
double largest_stretch(const Canvas& canvas, std::span<const ModelPoint> now) {
  double worst = 1;
  for (const mesh::Triangle& t : canvas.mesh().triangles()) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k];
      const std::uint32_t b = t[(k + 1) % 3];
      const double was = geometry::distance(canvas.positions()[a], canvas.positions()[b]);
      worst = std::max(worst, geometry::distance(now[a], now[b]) / was);
    }
  }
  return worst;
}

/// Triangles of a sheet in the plane of the picture that face away.
std::size_t turned_over(const Canvas& canvas, std::span<const ModelPoint> now) {
  std::size_t count = 0;
  for (const auto& [a, b, c] : canvas.mesh().triangles()) {
    const ModelVector e = now[b] - now[a];
    const ModelVector f = now[c] - now[a];
    count += e.x * f.y - e.y * f.x <= 0 ? 1 : 0;
  }
  return count;
}

using Grid = std::function<ModelPoint(std::uint32_t, std::uint32_t)>;

ModelPoint flat(std::uint32_t r, std::uint32_t c) { return {c * 0.1 - 2, r * 0.1 - 2, 0}; }

mesh::MeshSource sheet_source(const Grid& at = flat) {
  mesh::MeshSource source;
  tests::add_grid(source, "sheet", 41, 41, false, at);
  return source;
}

/// 100 px a unit, the origin in the middle.
PxPoint px(double x, double y) { return {500 + 100 * x, 500 - 100 * y}; }

std::vector<PxPoint> box(double x, double y, double half) {
  return {px(x - half, y - half), px(x + half, y - half), px(x + half, y + half), px(x - half, y + half)};
}

/// A line across the middle is brought up.
Sketch lift(double up, double turn = 0) {
  Sketch sketch;
  sketch.name = "lift";
  sketch.viewport = {1000, 1000};
  sketch.camera = {{0, 0, 5 / std::tan(15 * tests::k_degree)}, {0, 0, 0}, {0, 1, 0}, 30};
  sketch.general = box(0, 0, 1.55);
  sketch.specific = box(0, 0, 0.55);
  for (int i = -4; i <= 4; ++i) {
    sketch.reference.push_back(px(0.1 * i, 0));
    const double angle = turn * tests::k_degree;
    sketch.target.push_back(px(0.1 * i * std::cos(angle), up + 0.1 * i * std::sin(angle)));
  }
  return sketch;
}

TEST(HeldDeformer, StretchesNothingTwiceWhereThePaperDoes) {
  const auto canvas = tests::canvas_of(sheet_source());
  Sketch sketch = lift(0.9, 50);
  sketch.paper = true;
  const auto torn = posed(*canvas, *build_deformer(sketch, *canvas).value(), 1);
  sketch.paper = false;
  const auto held = build_deformer(sketch, *canvas).value();
  const auto now = posed(*canvas, *held, 1);
  EXPECT_EQ(held->strain().turned_over, 0U);
  EXPECT_LE(largest_stretch(*canvas, now), 2.0);
  EXPECT_TRUE(doubts_of(*held).empty());
  // The line still goes where it was drawn to.
  for (std::size_t i = 0; i < held->target().size(); ++i) {
    EXPECT_LT(geometry::distance(held->curve_at(1)[i], held->target()[i]), 1e-9);
  }
  const ModelPoint& middle = now[20 * 41 + 20];
  EXPECT_NEAR(middle.y, 0.9, 0.02);
}

TEST(HeldDeformer, HoldsAtBothEndsOfItsRange) {
  const auto canvas = tests::canvas_of(sheet_source());
  Sketch sketch = lift(0.9);
  sketch.mode = Mode::translate;
  sketch.minimum = -1;
  const auto held = build_deformer(sketch, *canvas).value();
  for (const double amount : {-1.0, -0.5, 0.5, 1.0}) {
    const auto now = posed(*canvas, *held, amount);
    EXPECT_EQ(turned_over(*canvas, now), 0U) << amount;
    EXPECT_LE(largest_stretch(*canvas, now), 2.0) << amount;
    EXPECT_NEAR(now[20 * 41 + 20].y, 0.9 * amount, 0.03) << amount;
  }
}

TEST(HeldDeformer, KeepsTheWidthOfEveryRowOfALid) {
  const Eye eye = tests::make_eye();
  const auto rest = eye.canvas->positions();
  const auto blink = build_deformer(eye.blink(), *eye.canvas).value();
  for (const double amount : {0.25, 0.5, 0.75, 1.0}) {
    const auto now = posed(*eye.canvas, *blink, amount);
    for (const std::uint32_t v : blink->vertices()) {
      EXPECT_NEAR(geometry::distance(now[v], eye.center), geometry::distance(rest[v], eye.center), 1e-9);
    }
    for (std::uint32_t row = 0; row < Eye::k_rings - 1; ++row) {
      const auto at = [&](std::uint32_t c) { return Eye::vertex(row, c); };
      const double was = rest[at(4)].x - rest[at(Eye::k_columns / 2 - 4)].x;
      const double is = now[at(4)].x - now[at(Eye::k_columns / 2 - 4)].x;
      EXPECT_NEAR(is / was, 1.0, 0.02) << amount << ' ' << row;
    }
  }
}

TEST(HeldDeformer, ALidThatGivesWayKeepsTheWidthOfItsRowsToo) {
  const Eye eye = tests::make_eye();
  const auto rest = eye.canvas->positions();
  // So little room above the lid that the surface has to give way.
  Sketch sketch = eye.blink();
  sketch.general = eye.around(
      62, [](double a) { return Eye::margin(a, Eye::k_upper) - 3; },
      [](double a) { return 14 + Eye::margin(a, Eye::k_upper); });
  const auto blink = build_deformer(sketch, *eye.canvas).value();
  const auto now = posed(*eye.canvas, *blink, 1);
  for (std::uint32_t row = 0; row < Eye::k_rings - 1; ++row) {
    // Every place between two columns, not the row as a whole alone.
    for (std::uint32_t c = 4; c + 8 <= Eye::k_columns / 2; c += 4) {
      const auto at = [&](std::uint32_t column) { return Eye::vertex(row, column); };
      const double was = rest[at(c)].x - rest[at(c + 4)].x;
      EXPECT_NEAR((now[at(c)].x - now[at(c + 4)].x) / was, 1.0, 0.05) << row << ' ' << c;
    }
  }
}

TEST(Slide, TakesEveryPointToItsTargetOnItsCircle) {
  const std::vector<ModelPoint> from{{-0.6, 0, 0.8}, {0, 0, 1}, {0.6, 0, 0.8}};
  const std::vector<ModelPoint> to{{-0.6, -0.1, 0.79372539331937719}, {0, -0.6, 0.8}, {0.6, -0.1, 0.79372539331937719}};
  const Slide slide({0, 0, 0}, from, to);
  for (std::size_t i = 0; i < from.size(); ++i) {
    EXPECT_LT(geometry::distance(turned_by(slide.tilts()[i], turned_by(slide.turns()[i], from[i])), to[i]), 1e-12);
    // What goes straight down keeps its place across.
    EXPECT_LT(geometry::length(slide.tilts()[i]), 1e-9);
    EXPECT_NEAR(turned_by(slide.turns()[i] * 0.5, from[i]).x, from[i].x, 1e-12);
  }
}

/// Two lips that meet along y = 0, joined only at their ends and behind: an upper sheet and a lower one, the lower a
/// little deeper.
std::shared_ptr<const Canvas> mouth() {
  mesh::MeshSource source;
  tests::add_grid(source, "upper", 21, 81, false, [](std::uint32_t r, std::uint32_t c) {
    return ModelPoint{c * 0.05 - 2, r * 0.05 + 0.004, 0};
  });
  tests::add_grid(source, "lower", 21, 81, false, [](std::uint32_t r, std::uint32_t c) {
    return ModelPoint{c * 0.05 - 2, r * 0.05 - 1.004, 0};
  });
  tests::add_grid(source, "left", 41, 21, false, [](std::uint32_t r, std::uint32_t c) {
    const double y = r < 20 ? r * 0.05 - 1.004 : r == 20 ? 0 : r * 0.05 - 1 + 0.004 - 0.05;
    return ModelPoint{c * 0.05 - 3, y, 0};
  });
  return tests::canvas_of(std::move(source));
}

Sketch along_the_mouth(unsigned seed) {
  Sketch sketch = lift(0);
  sketch.general = box(0, 0, 1.9);
  sketch.specific = box(0, 0.3, 0.6);
  sketch.reference.clear();
  sketch.target.clear();
  std::minstd_rand random(seed);
  double y = 0;
  for (int i = -40; i <= 40; ++i) {
    y = 0.7 * y + 0.012 * (static_cast<double>(random() % 2001) / 1000.0 - 1.0);
    sketch.reference.push_back(px(0.03 * i, y));
    sketch.target.push_back(px(0.03 * i, y + 0.3));
  }
  return sketch;
}

TEST(SheetReference, AlongClosedLipsBelongsToOneOfThem) {
  const auto canvas = mouth();
  for (unsigned seed = 1; seed <= 25; ++seed) {
    Sketch sketch = along_the_mouth(seed);
    sketch.specific = box(0, 0, 1.0);
    const auto deformer = build_deformer(sketch, *canvas);
    ASSERT_TRUE(deformer.ok()) << deformer.error().line();
    const auto line = (*deformer)->reference();
    const bool upper = line.front().y > 0;
    for (const ModelPoint& p : line) EXPECT_EQ(p.y > 0, upper) << "seed " << seed;
    sketch.other_sheet = true;
    const auto other = build_deformer(sketch, *canvas);
    ASSERT_TRUE(other.ok()) << other.error().line();
    for (const ModelPoint& p : (*other)->reference()) EXPECT_EQ(p.y > 0, !upper) << "seed " << seed;
  }
}

TEST(SheetReference, SaysThatThereIsNoOtherSheet) {
  const auto canvas = tests::canvas_of(sheet_source());
  Sketch sketch = lift(0.3);
  sketch.other_sheet = true;
  const auto none = build_deformer(sketch, *canvas);
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().place, "reference");
  EXPECT_NE(none.error().what.find("no other sheet"), std::string::npos);
}

TEST(SheetReference, SaysWhatWasCutOff) {
  mesh::MeshSource source;  // two flat sheets, one far behind the other
  tests::add_grid(source, "near", 41, 25, false, flat);
  tests::add_grid(source, "far", 41, 41, false, [](std::uint32_t r, std::uint32_t c) {
    return ModelPoint{c * 0.1 - 2, r * 0.1 - 2, -3};
  });
  const auto canvas = tests::canvas_of(std::move(source));
  Sketch sketch = lift(0.2);
  sketch.reference = {px(-1.5, 0), px(1.2, 0)};
  sketch.target = {px(-1.5, 0.2), px(0.35, 0.2)};
  const auto deformer = build_deformer(sketch, *canvas);
  ASSERT_TRUE(deformer.ok()) << deformer.error().line();
  for (const ModelPoint& p : (*deformer)->reference()) EXPECT_NEAR(p.z, 0, 1e-9);
  const auto doubts = doubts_of(**deformer);
  EXPECT_TRUE(std::any_of(doubts.begin(), doubts.end(),
                          [](const std::string& one) { return one.find("longest part") != std::string::npos; }));
}

// What users and files bring that makes no control, or a poor one.

base::Error refused(const Sketch& sketch, const Canvas& canvas) {
  const auto deformer = build_deformer(sketch, canvas);
  EXPECT_FALSE(deformer.ok());
  if (deformer.ok()) return {};
  EXPECT_FALSE(deformer.error().what.empty());
  EXPECT_FALSE(deformer.error().remedy.empty());
  EXPECT_EQ(deformer.error().line().find('\n'), std::string::npos);
  return deformer.error();
}

TEST(BadSketch, RegionsOfNothingAndStrokesOffTheMeshAreNamed) {
  const auto canvas = tests::canvas_of(sheet_source());
  Sketch sketch = lift(0.3);
  sketch.general = box(4, 4, 0.3);
  EXPECT_EQ(refused(sketch, *canvas).place, "general");
  sketch = lift(0.3);
  sketch.general = {px(0, 0), px(0, 0), px(0, 0)};
  EXPECT_EQ(refused(sketch, *canvas).place, "general");
  sketch = lift(0.3);
  sketch.specific = box(1.8, 1.8, 0.1);
  const base::Error outside = refused(sketch, *canvas);
  EXPECT_EQ(outside.place, "specific");
  EXPECT_NE(outside.what.find("right of"), std::string::npos) << outside.what;
  sketch = lift(0.3);
  sketch.reference = {px(3, 3), px(4, 4)};
  EXPECT_EQ(refused(sketch, *canvas).place, "reference");
}

TEST(BadSketch, ACoreThatReachesBeyondTheRegionIsSaidWithItsSide) {
  const auto canvas = tests::canvas_of(sheet_source());
  Sketch sketch = lift(0.1);
  sketch.specific = box(1.4, 0, 0.45);
  const auto deformer = build_deformer(sketch, *canvas).value();
  EXPECT_EQ(deformer->reaches_beyond(), "on its right");
}

TEST(BadSketch, OneTriangleIsNoRegion) {
  mesh::MeshSource source;
  source.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  source.triangles = {{0, 1, 2}};
  source.parts.push_back({"one", 0, 3, 0, 1});
  const auto canvas = tests::canvas_of(std::move(source));
  EXPECT_EQ(refused(lift(0.3), *canvas).place, "general");
}

TEST(BadSketch, DuplicateVerticesHolesAndManyTrianglesAtAnEdgeAreHeldToo) {
  mesh::MeshSource holes = tests::with_hole(sheet_source());
  mesh::MeshSource apart = tests::triangle_soup(sheet_source());
  mesh::MeshSource fins = sheet_source();  // a third triangle at edges of the middle row
  for (std::uint32_t c = 15; c < 25; ++c) {
    fins.positions.push_back({c * 0.1 - 1.95, 0, 0.05});
    fins.triangles.push_back({20 * 41 + c, 20 * 41 + c + 1, static_cast<std::uint32_t>(fins.positions.size() - 1)});
  }
  fins.parts.front().vertex_count = static_cast<std::uint32_t>(fins.positions.size());
  fins.parts.front().triangle_count = static_cast<std::uint32_t>(fins.triangles.size());
  for (mesh::MeshSource* source : {&holes, &apart, &fins}) {
    const auto built = mesh::TriangleMesh::build(std::move(*source));
    if (!built) continue;  // refused where the mesh is read
    const auto canvas = Canvas::make(*built, nullptr).value();
    const auto deformer = build_deformer(lift(0.7), *canvas);
    ASSERT_TRUE(deformer.ok()) << deformer.error().line();
    for (const ModelPoint& p : posed(*canvas, **deformer, 1)) {
      EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    }
    EXPECT_EQ((*deformer)->strain().turned_over, 0U);
  }
}

}  // namespace
}  // namespace penpose::articulation
