#include "core/portrait/pose_from_drawing.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

#include "core/character/demo_head.h"
#include "core/document/features/feature_curves.h"
#include "tests/core/portrait/drawn_face.h"
#include "tests/support/random.h"

// Drawings of known poses of the built-in head, by an unsteady hand.

namespace penpose::portrait {
namespace {

struct Drawn {
  DrawnLine line;
  std::size_t curve = 0;
};

/// A line from one point to another that bows down by so much, in the middle.
DrawnLine bow(PxPoint from, PxPoint to, double down) {
  DrawnLine line;
  for (int i = 0; i <= 20; ++i) {
    const double t = i / 20.0;
    line.push_back(from * (1.0 - t) + to * t + PxPoint{0.8 * std::sin(5.0 * t), 4.0 * t * (1.0 - t) * down});
  }
  return line;
}

class DrawingOfTheHead : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    model_ = new document::Model(character::make_demo_head().value());
    whole_ = new intent::WholeModel(intent::measure_whole_model(*model_->rig));
    curves_ = new std::vector<FeatureCurve>(document::feature_curves_of(*model_, *whole_, {}).value().curves);
  }
  static void TearDownTestSuite() {
    delete model_;
    delete whole_;
    delete curves_;
  }

  [[nodiscard]] static const rig::Rig& rig() { return *model_->rig; }
  [[nodiscard]] static geometry::Camera camera(double yaw = 0) {
    return camera_of_drawing(rig(), *curves_, rig::rest_pose(rig()), yaw);
  }
  [[nodiscard]] static rig::Pose pose(const std::vector<std::pair<const char*, double>>& values) {
    rig::Pose out = rig::rest_pose(rig());
    for (const auto& [name, value] : values) out[rig::find_parameter(rig().parameters(), name).value()] = value;
    return out;
  }

  /// A line for each curve, 30 points with a tremor of a 400th of the face; every other one from its end.
  static std::vector<Drawn> draw(const rig::Pose& posed, std::uint32_t seed, double yaw = 0) {
    std::vector<geometry::ModelPoint> places(rig().vertex_count());
    rig().evaluate(posed, places);
    tests::Random random(seed);
    std::vector<Drawn> out;
    for (std::size_t c = 0; c < curves_->size(); ++c) {
      Drawn one{{}, c};
      const double phase = random(0.0, 6.0), size = random(0.5, 2.0);
      for (const posing::CurvePoint& point : (*curves_)[c].points) {
        geometry::ModelPoint p(0);
        for (std::size_t k = 0; k < 3; ++k) p += places[point.vertex[k]] * point.weight[k];
        const double along = static_cast<double>(one.line.size());
        one.line.push_back(camera(yaw).project(p).value() +
                           PxPoint{size * std::sin(phase + 0.5 * along), size * std::cos(phase + 0.4 * along)});
      }
      if (c % 2 == 1) std::reverse(one.line.begin(), one.line.end());
      out.push_back(std::move(one));
    }
    std::rotate(out.begin(), out.begin() + 5, out.end());
    return out;
  }
  static std::vector<DrawnLine> lines(const std::vector<Drawn>& drawn) {
    std::vector<DrawnLine> out;
    for (const Drawn& one : drawn) out.push_back(one.line);
    return out;
  }
  static base::Result<DrawnPose> read(const Drawing& drawing, double yaw = 0) {
    std::vector<std::size_t> free(rig().parameters().size());
    std::iota(free.begin(), free.end(), std::size_t{0});
    return pose_from_drawing(rig(), *whole_, *curves_, drawing, camera(yaw), rig::rest_pose(rig()), free);
  }
  static std::size_t rightly_known(const std::vector<Drawn>& drawn, const std::vector<LineRead>& lines) {
    std::size_t right = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i) right += lines[i].curve == drawn[i].curve ? 1U : 0U;
    return right;
  }
  /// |found - meant| / |meant| over all vertices.
  static double error(const rig::Pose& found, const rig::Pose& meant) {
    std::vector<geometry::ModelPoint> a(rig().vertex_count()), b(a), rest(a);
    rig().evaluate(found, a);
    rig().evaluate(meant, b);
    rig().evaluate(rig::rest_pose(rig()), rest);
    double off = 0, way = 0;
    for (std::size_t v = 0; v < a.size(); ++v) {
      off += std::pow(geometry::distance(a[v], b[v]), 2);
      way += std::pow(geometry::distance(rest[v], b[v]), 2);
    }
    return std::sqrt(off / way);
  }
  [[nodiscard]] static const rig::Pose& laugh() {
    static const rig::Pose one = pose({{"jaw", 0.5}, {"mouth_corner_L", 0.8}, {"mouth_corner_R", 0.8}});
    return one;
  }

  static inline document::Model* model_ = nullptr;
  static inline intent::WholeModel* whole_ = nullptr;
  static inline std::vector<FeatureCurve>* curves_ = nullptr;
};

TEST_F(DrawingOfTheHead, EachLineFindsItsCurveAndTheFaceIsThatOfTheDrawing) {
  for (const auto& meant :
       {laugh(),
        pose({{"brow_inner_L", 0.8}, {"brow_inner_R", 0.8}, {"mouth_frown_L", 0.7}, {"mouth_frown_R", 0.7}})}) {
    const auto drawn = draw(meant, 3);
    const auto read = this->read({lines(drawn), {}});
    ASSERT_TRUE(read) << read.error().line();
    EXPECT_GE(rightly_known(drawn, read->read.lines), drawn.size() - 1);
    EXPECT_LT(error(read->pose, meant), 0.3);
  }
}

TEST_F(DrawingOfTheHead, AFaceAtRestStaysAtRest) {
  const auto drawn = draw(rig::rest_pose(rig()), 4);
  const auto read = this->read({lines(drawn), {}});
  ASSERT_TRUE(read);
  EXPECT_EQ(read->pose, rig::rest_pose(rig()));
}

TEST_F(DrawingOfTheHead, ItMayLieAnywhereOnTheSheetInAnySizeAndALittleTurned) {
  auto drawn = draw(laugh(), 5);
  const auto plain = read({lines(drawn), {}});
  for (Drawn& one : drawn) {
    for (PxPoint& p : one.line)
      p = PxPoint{3.0 * (0.99 * p.x - 0.12 * p.y) + 4000.0, 3.0 * (0.12 * p.x + 0.99 * p.y) - 700.0};
  }
  const auto moved = read({lines(drawn), {}});
  ASSERT_TRUE(plain && moved);
  EXPECT_GE(rightly_known(drawn, moved->read.lines), drawn.size() - 1);
  EXPECT_LT(error(moved->pose, plain->pose), 0.1);
  EXPECT_NEAR(moved->read.placement.scale(), plain->read.placement.scale() / 3.0, 0.03 * plain->read.placement.scale());
}

TEST_F(DrawingOfTheHead, PiecesAndDoublesOfALineAreOneCurve) {
  auto drawn = draw(laugh(), 6);
  Drawn second = drawn[0];
  const auto half = static_cast<std::ptrdiff_t>(drawn[0].line.size() / 2);
  second.line.erase(second.line.begin(), second.line.begin() + half);
  drawn[0].line.resize(static_cast<std::size_t>(half) + 1);
  Drawn again = drawn[3];
  for (PxPoint& p : again.line) p = p + PxPoint{1.5, -1.0};
  drawn.push_back(second);
  drawn.push_back(again);
  const auto read = this->read({lines(drawn), {}});
  ASSERT_TRUE(read);
  EXPECT_GE(rightly_known(drawn, read->read.lines), drawn.size() - 1);
  EXPECT_LT(error(read->pose, laugh()), 0.3);
  const LineRead& piece = read->read.lines.front();
  EXPECT_LT(piece.to - piece.from, 0.8);
}

TEST_F(DrawingOfTheHead, ANeutralDrawingTakesTheProportionsOfItsArtistOut) {
  // Eyes and mouth a sixth too far out.
  const auto widened = [&](std::vector<Drawn> drawn) {
    for (Drawn& one : drawn) {
      for (PxPoint& p : one.line) p.x = 500.0 + 1.17 * (p.x - 500.0);
    }
    return lines(drawn);
  };
  const auto neutral = widened(draw(rig::rest_pose(rig()), 7));
  const auto laughing = read({widened(draw(laugh(), 8)), neutral});
  ASSERT_TRUE(laughing);
  EXPECT_LT(error(laughing->pose, laugh()), 0.25);
  const auto still = read({widened(draw(rig::rest_pose(rig()), 9)), neutral});
  ASSERT_TRUE(still);
  EXPECT_EQ(still->pose, rig::rest_pose(rig()));
  EXPECT_EQ(still->read.neutral.size(), neutral.size());
}

TEST_F(DrawingOfTheHead, FromBesideItIsReadInThatView) {
  const auto drawn = draw(laugh(), 10, 20);
  const auto read = this->read({lines(drawn), {}}, 20);
  ASSERT_TRUE(read);
  EXPECT_LT(error(read->pose, laugh()), 0.3);
}

TEST_F(DrawingOfTheHead, ASmileOfSixFlatStrokesIsOne) {
  // Eyes far apart and of one arc each, a wide mouth, proportions that are not the head's.
  const std::vector<DrawnLine> face = {bow({185, 180}, {310, 178}, -22), bow({390, 178}, {515, 182}, -22),
                                       bow({200, 275}, {300, 275}, -34), bow({400, 275}, {500, 275}, -34),
                                       bow({332, 395}, {370, 395}, 12),  bow({235, 470}, {465, 470}, 52)};
  const std::vector<const char*> meant = {"brow_R", "brow_L", "eyelid_upper_R", "eyelid_upper_L", "nose", "lip"};
  const auto read = this->read({face, {}});
  ASSERT_TRUE(read);
  for (std::size_t i = 0; i < face.size(); ++i) {
    if (i == 4) continue;  // a nose of one arc says nothing of an expression
    ASSERT_TRUE(read->read.lines[i].curve) << meant[i];
    EXPECT_EQ((*curves_)[*read->read.lines[i].curve].name.rfind(meant[i], 0), 0U) << meant[i];
  }
  for (const char* corner : {"mouth_corner_L", "mouth_corner_R"})
    EXPECT_GT(read->pose[rig::find_parameter(rig().parameters(), corner).value()], 0.2) << corner;
}

TEST_F(DrawingOfTheHead, AnEyeThatIsDrawnAroundIsBothLids) {
  const auto eye = [](double left) {
    DrawnLine line = bow({left, 165}, {left + 53, 165}, -18);
    const DrawnLine below = bow({left + 53, 165}, {left, 165}, 15);
    line.insert(line.end(), below.begin() + 1, below.end());
    return line;
  };
  const std::vector<DrawnLine> face = {
      bow({100, 128}, {156, 96}, 4),  bow({244, 98}, {300, 126}, 4),   eye(105), eye(243),
      bow({188, 234}, {212, 234}, 6), bow({150, 300}, {252, 302}, -20)};
  const auto read = this->read({face, {}});
  ASSERT_TRUE(read);
  const auto name = [&](const std::optional<std::size_t>& curve) {
    return curve ? (*curves_)[*curve].name : std::string();
  };
  EXPECT_EQ(name(read->read.lines[2].curve), "eyelid_upper_R");
  EXPECT_EQ(name(read->read.lines[2].lower), "eyelid_lower_R");
  EXPECT_EQ(name(read->read.lines[3].curve), "eyelid_upper_L");
  EXPECT_EQ(name(read->read.lines[3].lower), "eyelid_lower_L");
  EXPECT_EQ(name(read->read.lines[0].curve), "brow_R");
  EXPECT_EQ(name(read->read.lines[1].curve), "brow_L");
  for (const char* inner : {"brow_inner_L", "brow_inner_R"})
    EXPECT_GT(read->pose[rig::find_parameter(rig().parameters(), inner).value()], 0.1) << inner;
}

TEST_F(DrawingOfTheHead, WhatIsNoFeatureIsSaidAndMovesNothing) {
  auto drawn = draw(rig::rest_pose(rig()), 11);
  // A hat far above.
  Drawn hat{{}, 0};
  for (int i = 0; i < 30; ++i) hat.line.push_back({200.0 + 20.0 * i, -400.0 + (i % 7) * 30.0});
  drawn.push_back(hat);
  const auto read = this->read({lines(drawn), {}});
  ASSERT_TRUE(read);
  EXPECT_FALSE(read->read.lines.back().curve);
  EXPECT_EQ(read->pose, rig::rest_pose(rig()));
}

TEST_F(DrawingOfTheHead, AFaceOfAFewLinesIsReadAsPeopleReadIt) {
  const auto moved = [&](const DrawnFace& drawn, const char* control) {
    const auto read = this->read({drawn.lines(), {}});
    EXPECT_TRUE(read);
    return read ? read->pose[rig::find_parameter(rig().parameters(), control).value()] : 0.0;
  };
  DrawnFace smile;
  smile.smile = 16;
  EXPECT_GT(moved(smile, "mouth_corner_L"), 0.3);
  EXPECT_GT(moved(smile, "mouth_corner_R"), 0.3);
  DrawnFace sad;
  sad.brow_inner = {20, 20};
  EXPECT_GT(moved(sad, "brow_inner_L"), 0.3);
  DrawnFace wink;
  wink.shut[1] = true;  // at the right of the picture, the face's left
  EXPECT_GT(moved(wink, "eyelid_upper_L"), 0.6);
  EXPECT_LT(moved(wink, "eyelid_upper_R"), 0.1);
  const auto rest = this->read({DrawnFace{}.lines(), {}});
  ASSERT_TRUE(rest);
  EXPECT_EQ(rest->pose, rig::rest_pose(rig()));
  // The sheet lies with its eyes, 100 px apart about (200, 200), on those of the model.
  const PxPoint left = rest->sheet(PxPoint{150, 200});
  const PxPoint right = rest->sheet(PxPoint{250, 200});
  EXPECT_NEAR(left.y, right.y, 2);
  for (const char* lid : {"eyelid_upper_R", "eyelid_upper_L"}) {
    const auto names = names_of(*curves_);
    const auto& points =
        (*curves_)[static_cast<std::size_t>(std::find(names.begin(), names.end(), lid) - names.begin())].points;
    std::vector<geometry::ModelPoint> places(rig().vertex_count());
    rig().evaluate(rig::rest_pose(rig()), places);
    const auto at = camera().project(places[nearest_vertex(points[points.size() / 2])]).value();
    const PxPoint& eye = std::string(lid).back() == 'R' ? left : right;
    EXPECT_NEAR(at.x, eye.x, 0.1 * (right.x - left.x));
    EXPECT_NEAR(at.y, eye.y, 0.3 * (right.x - left.x));
  }
}

TEST_F(DrawingOfTheHead, AHouseAndAScribbleMoveNothingWildly) {
  const std::vector<DrawnLine> house = {
      {{50, 200}, {50, 380}, {350, 380}, {350, 200}},   {{30, 210}, {200, 60}, {370, 210}},
      {{170, 380}, {170, 280}, {230, 280}, {230, 380}}, {{80, 240}, {130, 240}, {130, 290}, {80, 290}, {80, 240}},
      {{300, 120}, {300, 60}, {330, 60}, {330, 150}},
  };
  std::vector<DrawnLine> scribble;
  tests::Random random(13);
  for (int i = 0; i < 25; ++i) {
    scribble.push_back({{random(50, 750), random(50, 750)}});
    for (int k = 0; k < 20; ++k)
      scribble.back().push_back(scribble.back().back() + PxPoint{random(-70, 70), random(-70, 70)});
  }
  for (const auto& lines : {house, scribble}) {
    const auto read = this->read({lines, {}});
    ASSERT_TRUE(read);
    EXPECT_EQ(read->pose, rig::rest_pose(rig()));
    for (const LineRead& line : read->read.lines) EXPECT_FALSE(line.curve);
  }
}

TEST_F(DrawingOfTheHead, TheSameDrawingGivesTheSameBits) {
  const auto drawn = draw(laugh(), 12);
  const auto one = read({lines(drawn), {}});
  const auto other = read({lines(drawn), {}});
  ASSERT_TRUE(one && other);
  EXPECT_EQ(one->pose, other->pose);
  EXPECT_EQ(one->read.energy, other->read.energy);
}

TEST_F(DrawingOfTheHead, BadDrawingsAreRefusedInOneLine) {
  EXPECT_EQ(read({{}, {}}).error().line(), "the drawing has no lines; draw the features of the face");
  EXPECT_EQ(read({{{{1, 1}, {1, 1}}}, {}}).error().line(), "drawing, line 0: a line has no length; leave dots out");
  const std::vector<DrawnLine> many(k_most_drawn_lines + 1, {{0, 0}, {1, 1}});
  EXPECT_EQ(read({many, {}}).error().line(),
            "drawing: 401 lines are more than the 400 of a drawing; draw fewer, longer lines");
  EXPECT_EQ(read({{{{0, 0}, {1, 1}}}, {}, true, {1000}}).error().place, "given");
  EXPECT_EQ(read({{{{0, 0}, {1, 1}}}, {}, true, {0, 0}}).error().place, "given");
  const double nan = std::nan("");
  EXPECT_FALSE(read({{{{nan, 0}, {1, 1}}}, {}}));
  EXPECT_FALSE(read({{{{0, 0}, {1e12, 1}}}, {}}));
}

}  // namespace
}  // namespace penpose::portrait
