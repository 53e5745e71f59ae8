#include <gtest/gtest.h>

#include "core/articulation/deformer.h"
#include "core/articulation/measure/doubts.h"
#include "tests/support/models/articulation_models.h"

// What strokes and meshes may be wrong with: a message that names the stroke, and never a deformer that tears.

namespace penpose::articulation {
namespace {

/// A flat sheet 4 units wide seen from +z, 100 px a unit.
mesh::MeshSource sheet(std::uint32_t side = 41) {
  mesh::MeshSource source;
  tests::add_grid(source, "sheet", side, side, false, [side](std::uint32_t r, std::uint32_t c) {
    const double step = 4.0 / (side - 1);
    return ModelPoint{c * step - 2, r * step - 2, 0};
  });
  return source;
}

std::vector<PxPoint> box(double half, PxPoint middle = {500, 500}) {
  return {middle + PxPoint{-half, -half}, middle + PxPoint{half, -half}, middle + PxPoint{half, half},
          middle + PxPoint{-half, half}};
}

Sketch lift() {
  Sketch sketch;
  sketch.name = "lift";
  sketch.viewport = {1000, 1000};
  const double away = 5 / std::tan(15 * tests::k_degree);
  sketch.camera = {{0, 0, away}, {0, 0, 0}, {0, 1, 0}, 30};
  sketch.general = box(155);
  sketch.specific = box(55);
  for (int i = -4; i <= 4; ++i) {
    sketch.reference.push_back({500.0 + 10 * i, 500});
    sketch.target.push_back({500.0 + 10 * i, 440});
  }
  return sketch;
}

std::string place_of(const Sketch& sketch, const Canvas& canvas) {
  const auto built = build_deformer(sketch, canvas);
  if (built) return "none";
  EXPECT_FALSE(built.error().what.empty());
  EXPECT_FALSE(built.error().remedy.empty()) << built.error().what;
  return built.error().place;
}

TEST(BadRegions, ARegionOfNothingIsTold) {
  const auto canvas = tests::canvas_of(sheet());
  Sketch sketch = lift();
  sketch.general = box(20, {950, 950});
  EXPECT_EQ(place_of(sketch, *canvas), "general");
  sketch = lift();
  sketch.general = {{500, 500}, {500, 500}, {500, 500}};
  EXPECT_EQ(place_of(sketch, *canvas), "general");
}

TEST(BadRegions, ALassoThatCrossesItselfIsTold) {
  const auto canvas = tests::canvas_of(sheet());
  Sketch sketch = lift();
  EXPECT_EQ(place_of(sketch, *canvas), "none");
  sketch.general = {{345, 345}, {655, 655}, {655, 345}, {345, 655}};  // an eight
  EXPECT_EQ(place_of(sketch, *canvas), "general");
  sketch.general = box(155);
  for (const PxPoint& p : box(150)) sketch.general.push_back(p);  // twice around
  EXPECT_EQ(place_of(sketch, *canvas), "general");
  sketch = lift();
  sketch.specific = {{445, 445}, {555, 555}, {555, 445}, {445, 555}};
  EXPECT_EQ(place_of(sketch, *canvas), "specific");
  // A hand that goes a little beyond where it began has not crossed anything.
  sketch = lift();
  sketch.general.insert(sketch.general.end(), {{345, 345}, {365, 335}});
  EXPECT_EQ(place_of(sketch, *canvas), "none");
}

TEST(BadRegions, StrokesOffTheMeshAreTold) {
  const auto canvas = tests::canvas_of(sheet());
  Sketch sketch = lift();
  sketch.reference = {{5, 5}, {60, 5}};
  EXPECT_TRUE(place_of(sketch, *canvas).starts_with("reference"));
  sketch = lift();
  sketch.target = {{500, 440}};
  EXPECT_TRUE(place_of(sketch, *canvas).starts_with("target"));
  sketch.target = {{1e9, 0}, {0, 0}};
  EXPECT_TRUE(place_of(sketch, *canvas).starts_with("target"));
}

TEST(BadRegions, ACoreOutsideSaysOnWhichSideItLies) {
  const auto canvas = tests::canvas_of(sheet());
  Sketch sketch = lift();
  sketch.specific = box(20, {690, 500});
  const auto built = build_deformer(sketch, *canvas);
  ASSERT_FALSE(built.ok());
  EXPECT_EQ(built.error().place, "specific");
  EXPECT_NE(built.error().what.find("right of"), std::string::npos) << built.error().what;
  // Partly outside it is built, and told.
  sketch.specific = box(55, {640, 500});
  const auto partly = build_deformer(sketch, *canvas).value();
  EXPECT_EQ(partly->reaches_beyond(), "on its right");
  EXPECT_FALSE(doubts_of(*partly).empty());
}

TEST(BadRegions, AMeshOfOneTriangleIsTold) {
  mesh::MeshSource source;
  source.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  source.triangles = {{0, 1, 2}};
  source.parts.push_back({"one", 0, 3, 0, 1});
  EXPECT_EQ(place_of(lift(), *tests::canvas_of(std::move(source))), "general");
}

TEST(BadRegions, DuplicateVerticesMoveAlike) {
  mesh::MeshSource source = sheet();
  // Every triangle gets corners of its own.
  const auto canvas = tests::canvas_of(tests::triangle_soup(source));
  const auto built = build_deformer(lift(), *canvas).value();
  const std::vector<ModelVector> moves = built->displacements(1);
  std::vector<ModelVector> of(canvas->positions().size(), ModelVector{0});
  for (std::size_t i = 0; i < moves.size(); ++i) of[built->vertices()[i]] = moves[i];
  for (std::uint32_t v = 0; v < of.size(); ++v) EXPECT_EQ(of[v], of[canvas->mesh().weld()[v]]) << v;
  EXPECT_EQ(built->strain().turned_over, 0U);
}

TEST(BadRegions, AHoleInsideTearsNothing) {
  const auto canvas = tests::canvas_of(tests::with_hole(sheet()));
  const auto built = build_deformer(lift(), *canvas).value();
  EXPECT_EQ(built->strain().turned_over, 0U);
  EXPECT_LE(built->strain().stretch, 2.0);
}

TEST(BadRegions, AFinOnTheSheetIsDrawnOnAsEver) {
  mesh::MeshSource source = sheet();
  const auto plain = build_deformer(lift(), *tests::canvas_of(sheet())).value();
  // It stands on the sheet along an edge that has two triangles already.
  const auto tip = static_cast<std::uint32_t>(source.positions.size());
  source.positions.push_back({0.05, 0, 0.5});
  const std::uint32_t a = 20 * 41 + 20;
  source.triangles.push_back({a, a + 1, tip});
  source.parts.front().vertex_count += 1;
  source.parts.front().triangle_count += 1;
  const auto canvas = tests::canvas_of(std::move(source));
  const auto built = build_deformer(lift(), *canvas);
  ASSERT_TRUE(built) << built.error().line();
  EXPECT_GE((*built)->vertices().size(), plain->vertices().size());
  EXPECT_EQ((*built)->strain().turned_over, 0U);
}

TEST(BadRegions, APieceThatIsNotThereIsTold) {
  const auto canvas = tests::canvas_of(sheet());
  Sketch sketch = lift();
  sketch.piece = 1;
  EXPECT_EQ(place_of(sketch, *canvas), "piece");
}

TEST(InferredDoubt, TwoLipsAndABlobAreDoubtedAndALineIsNot) {
  // Two sheets, 0.02 apart, that meet far to the left only: lips.
  mesh::MeshSource lips;
  tests::add_grid(lips, "lips", 41, 41, false, [](std::uint32_t r, std::uint32_t c) {
    const double gap = c < 6 || r == 20 ? 0.0 : r < 20 ? -0.01 : 0.01;
    return ModelPoint{c * 0.1 - 2, r * 0.1 - 2 + gap, 0};
  });
  std::erase_if(lips.triangles, [](const mesh::Triangle& t) {
    for (const std::uint32_t v : t) {
      if (v / 41 == 20 && v % 41 > 5) return true;
    }
    return false;
  });
  // What is left of the row between them closes up, so that both rims lie beside each other.
  for (std::uint32_t c = 6; c < 41; ++c) {
    lips.positions[19 * 41 + c].y = -0.005;
    lips.positions[21 * 41 + c].y = 0.005;
  }
  lips.parts.front().triangle_count = static_cast<std::uint32_t>(lips.triangles.size());
  Sketch sketch = lift();
  sketch.reference.clear();
  sketch.specific = {{420, 475}, {640, 475}, {640, 525}, {420, 525}};
  sketch.general = box(155);
  const auto canvas = tests::canvas_of(std::move(lips));
  const auto between = build_deformer(sketch, *canvas);
  ASSERT_TRUE(between.ok()) << between.error().line();
  EXPECT_NE((*between)->doubtful_reference().find("two sheets"), std::string::npos);
  bool told = false;
  for (const std::string& doubt : doubts_of(**between)) told = told || doubt.find("two sheets") != std::string::npos;
  EXPECT_TRUE(told);

  const auto whole = tests::canvas_of(sheet());
  EXPECT_EQ(build_deformer(sketch, *whole).value()->doubtful_reference(), "") << "a long core on one sheet";
  sketch.specific = box(55);
  EXPECT_NE(build_deformer(sketch, *whole).value()->doubtful_reference().find("wide"), std::string::npos);
}

}  // namespace
}  // namespace penpose::articulation
