#include "core/character/demo_head.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "core/articulation/deformer.h"
#include "core/articulation/edit.h"
#include "core/head/head.h"
#include "core/head/skin.h"

namespace penpose::character {
namespace {

using geometry::ModelPoint;

class DemoHead : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto made = make_demo_head();
    ASSERT_TRUE(made.ok()) << made.error().line();
    model_ = new document::Model(std::move(made).value());
  }
  static void TearDownTestSuite() { delete model_; }

  static const articulation::Deformer& deformer(const std::string& name) {
    for (const auto& one : model_->deformers->deformers()) {
      if (one->sketch().name == name) return *one;
    }
    ADD_FAILURE() << "no deformer " << name;
    std::abort();
  }
  static std::vector<ModelPoint> posed(const std::vector<std::pair<std::string, double>>& values) {
    document::Model model = *model_;
    for (const auto& [name, value] : values) model.pose[*rig::find_parameter(model.rig->parameters(), name)] = value;
    return document::posed_positions(model);
  }
  static std::vector<ModelPoint> curve(const std::string& name, const std::vector<ModelPoint>& positions) {
    std::vector<ModelPoint> points;
    for (const auto& curve : model_->curves) {
      if (curve.name != name) continue;
      for (const auto& p : curve.points) points.push_back(mesh::position_of(p, model_->mesh->triangles(), positions));
    }
    return points;
  }

  static document::Model* model_;
};
document::Model* DemoHead::model_ = nullptr;

TEST_F(DemoHead, HasEighteenControls) {
  EXPECT_EQ(model_->deformers->size(), 18U);
  EXPECT_EQ(model_->rig->parameters().size(), 18U);
  for (const auto& one : model_->deformers->deformers()) {
    EXPECT_GT(one->vertices().size(), 50U) << one->sketch().name;
    EXPECT_LT(one->vertices().size(), model_->mesh->vertex_count() / 3) << one->sketch().name;
    EXPECT_EQ(*std::max_element(one->weights().begin(), one->weights().end()), 1.0);
  }
}

TEST_F(DemoHead, RestIsTheHeadItself) {
  const document::Model bare = head::make_head();
  EXPECT_EQ(posed({}), document::posed_positions(bare));
}

TEST_F(DemoHead, LidsSlideOverTheEyeball) {
  for (const std::string side : {"_L", "_R"}) {
    const head::Eyeball eye = side == "_L" ? head::head_landmarks().left : head::head_landmarks().right;
    for (const std::string lid : {"eyelid_upper", "eyelid_lower"}) {
      const auto& moved = deformer(lid + side);
      const auto rest = posed({});
      for (int step = 0; step <= 20; ++step) {
        const auto now = posed({{lid + side, step / 20.0}});
        for (const std::uint32_t v : moved.vertices()) {
          const double distance = geometry::distance(now[v], eye.center);
          ASSERT_NEAR(distance, geometry::distance(rest[v], eye.center), 1e-9 * eye.radius) << lid << side << v;
          ASSERT_GT(distance, eye.radius);
        }
      }
    }
  }
}

/// A row of the +x eye's upper (lid 1) or lower (-1) lid, from corner to corner; 0: where it touches the eye, 1: its
/// edge.
std::vector<std::uint32_t> lid_row(const document::Model& model, double lid, double row) {
  const head::Half half = head::make_half().value();
  std::vector<std::pair<double, std::uint32_t>> found;
  for (std::size_t v = 0; v < half.points.size(); ++v) {
    const head::LoopMark& mark = half.marks[v];
    if (std::abs(mark.x - row) > 1e-6 || mark.z * lid < 0.01) continue;
    const ModelPoint wanted = half.points[v] * 0.01;
    const auto all = model.mesh->positions();
    const auto same =
        std::find_if(all.begin(), all.end(), [&](const ModelPoint& p) { return geometry::distance(p, wanted) < 1e-8; });
    if (same != all.end()) found.emplace_back(wanted.x, static_cast<std::uint32_t>(same - all.begin()));
  }
  std::sort(found.begin(), found.end());
  std::vector<std::uint32_t> vertices;
  for (const auto& one : found) vertices.push_back(one.second);
  return vertices;
}

TEST_F(DemoHead, ClosedLidMeetsTheLowerOne) {
  const head::Eyeball eye = head::head_landmarks().left;
  const auto rest = posed({});
  const auto closed = posed({{"eyelid_upper_L", 1}});
  const auto seen = [&](std::uint32_t v) { return geometry::normalized(closed[v] - eye.center); };
  const auto upper = lid_row(*model_, 1, 0);
  const auto lower = lid_row(*model_, -1, 0);
  double largest = 0;  // between what is left open, in eye radii
  double sum = 0;
  for (const std::uint32_t v : upper) {
    double nearest = 2;
    for (std::size_t i = 0; i + 1 < lower.size(); ++i) {
      for (int k = 0; k <= 16; ++k) {
        const auto on_lower = seen(lower[i]) + (seen(lower[i + 1]) - seen(lower[i])) * (k / 16.0);
        const double off = geometry::distance(seen(v), on_lower);
        if (off < nearest) nearest = off;
      }
    }
    largest = std::max(largest, nearest);
    sum += nearest;
  }
  EXPECT_LT(largest, 0.1);
  EXPECT_LT(sum / static_cast<double>(upper.size()), 0.055);
  const std::uint32_t middle = upper[upper.size() / 2];
  EXPECT_GT(geometry::distance(rest[middle], closed[middle]), 0.45 * eye.radius);
  EXPECT_LT(closed[middle].y, closed[lower[lower.size() / 2]].y + 6e-4) << "down to the lower lid";
}

TEST_F(DemoHead, AClosedLidLiesOutsideARaisedLowerOne) {
  const head::Eyeball eye = head::head_landmarks().left;
  const auto both = posed({{"eyelid_upper_L", 1}, {"eyelid_lower_L", 1}});
  const auto lower = curve("eyelid_lower_L", both);
  const auto rim = lid_row(*model_, 1, 0);
  double farthest = 0;
  for (std::size_t i = 3; i + 3 < lower.size(); ++i) {
    farthest = std::max(farthest, geometry::distance(lower[i], eye.center));
  }
  for (std::size_t i = 3; i + 3 < rim.size(); ++i) EXPECT_GT(geometry::distance(both[rim[i]], eye.center), farthest);
}

TEST_F(DemoHead, LidsCutIntoTheEyeWithoutASurface) {
  const head::Eyeball eye = head::head_landmarks().left;
  articulation::Sketch sketch = deformer("eyelid_upper_L").sketch();
  sketch.surface = articulation::Free{};
  const auto canvas = document::make_canvas(*model_).value();
  const auto lid = articulation::build_deformer(sketch, *canvas).value();
  const std::vector<geometry::ModelVector> moves = lid->displacements(0.5);
  std::size_t inside = 0;
  double deepest = 0;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const double depth =
        eye.radius - geometry::distance(canvas->positions()[lid->vertices()[i]] + moves[i], eye.center);
    inside += depth > 0 ? 1 : 0;
    deepest = std::max(deepest, depth);
  }
  EXPECT_GT(inside, 15U);
  EXPECT_GT(deepest, 0.01 * eye.radius);
}

TEST_F(DemoHead, ABallThatIsGivenALittleTooLargeStillMovesTheWholeLid) {
  const auto& lid = deformer("eyelid_upper_L");
  articulation::Sketch sketch = lid.sketch();
  std::get<articulation::Sphere>(sketch.surface).radius *= 1.05;
  const auto canvas = document::make_canvas(*model_).value();
  const auto again = articulation::build_deformer(sketch, *canvas).value();
  EXPECT_EQ(again->vertices().size(), lid.vertices().size());
  std::get<articulation::Sphere>(sketch.surface).radius *= 5;
  const auto refused = articulation::build_deformer(sketch, *canvas);
  ASSERT_FALSE(refused.ok());
  EXPECT_FALSE(refused.error().remedy.empty()) << refused.error().line();
}

TEST_F(DemoHead, AnotherOrderOfDeformersChangesNoMoreThanTheLastBit) {
  std::vector<std::pair<std::string, double>> values;
  for (std::size_t i = 0; i < model_->rig->parameters().size(); ++i) {
    values.emplace_back(model_->rig->parameters()[i].name, 0.31 + 0.04 * static_cast<double>(i));
  }
  const auto in_order = posed(values);
  std::vector<std::shared_ptr<const articulation::Deformer>> deformers(model_->deformers->deformers().begin(),
                                                                       model_->deformers->deformers().end());
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 6; ++trial) {
    for (std::size_t i = deformers.size(); i > 1; --i) std::swap(deformers[i - 1], deformers[random() % i]);
    auto model = document::with_deformers(*model_, articulation::SketchedDeformers::make(deformers).value()).value();
    for (const auto& [name, value] : values) model.pose[*rig::find_parameter(model.rig->parameters(), name)] = value;
    const auto other = document::posed_positions(model);
    for (std::size_t v = 0; v < other.size(); ++v) {
      const double size = geometry::length(in_order[v]);
      const double last_bit = std::nextafter(size, 1.0) - size;
      for (int k = 0; k < 3; ++k) ASSERT_LE(std::abs(other[v][k] - in_order[v][k]), last_bit) << "vertex " << v;
    }
  }
}

TEST_F(DemoHead, NothingBehindTheHeadMoves) {
  for (const auto& one : model_->deformers->deformers()) {
    for (const std::uint32_t v : one->vertices()) {
      EXPECT_GT(model_->mesh->positions()[v].z, -0.001) << one->sketch().name;
    }
  }
}

TEST_F(DemoHead, NoTargetOfTheBundledSketchWasTurnedRound) {
  for (const auto& one : model_->deformers->deformers()) EXPECT_FALSE(one->turned_round()) << one->sketch().name;
}

TEST_F(DemoHead, EveryDeformerReachesItsTarget) {
  for (const auto& one : model_->deformers->deformers()) {
    const auto start = one->curve_at(0);
    const auto end = one->curve_at(1);
    for (std::size_t i = 0; i < end.size(); ++i) {
      EXPECT_LT(geometry::distance(start[i], one->reference()[i]), 1e-15) << one->sketch().name;
      EXPECT_LT(geometry::distance(end[i], one->target()[i]), 1e-9) << one->sketch().name;
    }
  }
}

TEST_F(DemoHead, TheLeftLidMakesTheRightOneInOneCommand) {
  const auto canvas = document::make_canvas(*model_).value();
  const auto& set = *model_->deformers;
  const auto left = *articulation::find_deformer(set, "eyelid_upper_L");
  const auto right = *articulation::find_deformer(set, "eyelid_upper_R");
  const auto one_less = articulation::without(set, right).value();
  const auto again = articulation::with_mirrored(*one_less, left, *canvas).value();
  EXPECT_EQ(again->deformers().back()->sketch().name, "eyelid_upper_R");
  const auto& mirrored = *again->deformers().back();
  const auto& lid = *set.deformers()[left];
  ASSERT_EQ(mirrored.vertices().size(), lid.vertices().size());
  const std::vector<geometry::ModelVector> moves = mirrored.displacements(1.0);
  const head::Eyeball eye = head::head_landmarks().right;
  double farthest = 0;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const ModelPoint rest = model_->mesh->positions()[mirrored.vertices()[i]];
    EXPECT_LT(rest.x, 0);
    EXPECT_NEAR(geometry::distance(rest + moves[i], eye.center), geometry::distance(rest, eye.center),
                1e-9 * eye.radius);
    farthest = std::max(farthest, geometry::length(moves[i]));
  }
  EXPECT_GT(farthest, 0.45 * eye.radius);
}

TEST_F(DemoHead, JawPartsTheLips) {
  const auto rest = posed({});
  const auto open = posed({{"jaw", 1}});
  const auto upper = curve("lip_upper_inner", open);
  const auto lower = curve("lip_lower_inner", open);
  const std::size_t middle = upper.size() / 2;
  EXPECT_GT(upper[middle].y - lower[middle].y, 0.010);
  EXPECT_EQ(curve("lip_upper_inner", rest)[middle], upper[middle]);
  EXPECT_EQ(curve("nose_bridge", rest), curve("nose_bridge", open));
  EXPECT_LT(geometry::distance(upper.front(), lower.front()), 0.002);
}

TEST_F(DemoHead, SidesMirrorEachOther) {
  const auto rest = posed({});
  for (const std::string name : {"eyelid_upper", "brow_inner", "cheek", "mouth_corner"}) {
    const auto left = posed({{name + "_L", 1}});
    const auto right = posed({{name + "_R", 1}});
    for (const std::string curve_name : {"eyelid_upper", "brow"}) {
      const auto a = curve(curve_name + "_L", left);
      const auto b = curve(curve_name + "_R", right);
      ASSERT_EQ(a.size(), b.size());
      for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_NEAR(a[i].x, -b[i].x, 2e-4) << name << ' ' << i;
        EXPECT_NEAR(a[i].y, b[i].y, 2e-4) << name << ' ' << i;
      }
    }
  }
}

TEST_F(DemoHead, BrowsAndCornersMoveTheirWay) {
  const auto rest = posed({});
  const auto up = [&](const std::string& parameter, const std::string& name, std::size_t point) {
    return curve(name, posed({{parameter, 1}}))[point].y - curve(name, rest)[point].y;
  };
  EXPECT_GT(up("brow_inner_L", "brow_L", 2), 0.004);
  EXPECT_GT(up("brow_outer_L", "brow_L", 20), 0.004);
  EXPECT_LT(up("brow_inner_L", "brow_L", 24), 0.001);
  EXPECT_GT(up("mouth_corner_L", "lip_upper", 38), 0.005);
  EXPECT_LT(up("mouth_corner_L", "lip_upper", 4), 0.0005);
  EXPECT_GT(up("lip_upper", "lip_upper", 20), 0.003);
  const auto narrow = curve("lip_upper", posed({{"lips_pucker", 1}}));
  EXPECT_LT(narrow.back().x, 0.75 * curve("lip_upper", rest).back().x);
}

}  // namespace
}  // namespace penpose::character
