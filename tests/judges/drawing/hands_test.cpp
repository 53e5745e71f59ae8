#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <set>

#include "tests/judges/cases/known_faces.h"
#include "tests/judges/drawing/faces/artist.h"
#include "tests/judges/drawing/faces/drawing_sets.h"
#include "tests/judges/drawing/faces/no_faces.h"
#include "tests/judges/drawing/known/camera_picture.h"
#include "tests/judges/drawing/known/known_drawing.h"

namespace penpose::judges::drawn {
namespace {

const Rig& some_rig() {
  static const Rig rig = own_rigs().front().make();
  return rig;
}

TEST(DrawingArtists, AThirdOfThemIsHeldOutAndDrawsOnHeldOutRigsAlone) {
  EXPECT_GE(3 * artists_for(Group::held_out).size(), all_artists().size());
  EXPECT_EQ(artists_for(Group::held_out).size() + artists_for(Group::seen).size(), all_artists().size());
  EXPECT_EQ(artists_for(Group::shared).size(), all_artists().size());
}

TEST(DrawingArtists, TheSameSeedGivesTheSameFaceAndAnotherSeedAnotherOne) {
  for (const GroupedArtist& one : all_artists()) {
    const auto first = drawn_face(one.artist, Expression::happy, {}, 7);
    EXPECT_EQ(first.lines, drawn_face(one.artist, Expression::happy, {}, 7).lines) << one.artist.name;
    EXPECT_NE(first.lines, drawn_face(one.artist, Expression::happy, {}, 8).lines) << one.artist.name;
  }
}

TEST(DrawingArtists, EveryDrawingIsOneThatTheProgramTakes) {
  for (const GroupedArtist& one : all_artists()) {
    for (std::size_t e = 0; e < k_expression_count; ++e) {
      const auto drawing = drawn_face(one.artist, static_cast<Expression>(e), Side::left, e);
      EXPECT_GE(drawing.lines.size(), 3U);
      EXPECT_LE(drawing.lines.size(), portrait::k_most_lines);
    }
  }
  for (const NoFace& thing : no_faces()) EXPECT_GE(drawn_thing(thing, 1).lines.size(), 3U) << thing.name;
}

/// How high the corners of the widest line below the eyes are above its middle, in its width.
double corners_of_widest_line(const portrait::Drawing& drawing) {
  double widest = 0, high = 0;
  double top = 1e300, bottom = -1e300;
  for (const auto& line : drawing.lines) {
    for (const PxPoint& p : line) top = std::min(top, p.y), bottom = std::max(bottom, p.y);
  }
  for (const auto& line : drawing.lines) {
    const double width = std::abs(line.front().x - line.back().x);
    if (line[line.size() / 2].y < top + 0.6 * (bottom - top) || width <= widest) continue;
    widest = width;
    high = (line[line.size() / 2].y - (line.front().y + line.back().y) / 2) / width;
  }
  return high;
}

TEST(DrawingArtists, AMouthOfOneLineGoesUpWhereSomebodyIsHappyAndDownWhereHeIsSad) {
  const auto artists = artists_for(Group::seen);
  const auto found = std::find_if(artists.begin(), artists.end(),
                                  [](const Artist& one) { return std::string(one.name) == "felt_pen"; });
  ASSERT_NE(found, artists.end());
  for (std::uint64_t seed = 1; seed < 9; ++seed) {
    EXPECT_GT(corners_of_widest_line(drawn_face(*found, Expression::happy, {}, seed)), 0.1);
    EXPECT_LT(corners_of_widest_line(drawn_face(*found, Expression::sad, {}, seed)), -0.1);
    EXPECT_NEAR(corners_of_widest_line(drawn_face(*found, Expression::rest, {}, seed)), 0, 0.05);
  }
}

/// What each hand of a set drew.
std::map<std::string, std::set<Expression>> drawn_by(Group group) {
  std::map<std::string, std::set<Expression>> hands;
  for (const SharedDrawing& one : drawing_set(group)) {
    if (one.face) hands[one.folder].insert(one.meant);
  }
  return hands;
}

TEST(DrawingSets, EveryHandDrewEveryExpressionAndAThirdOfTheHandsIsHeldOut) {
  const auto seen = drawn_by(Group::seen), held_out = drawn_by(Group::held_out);
  EXPECT_EQ(seen.size(), 8U);
  EXPECT_EQ(held_out.size(), 4U);
  for (const auto& hands : {seen, held_out}) {
    for (const auto& [hand, meant] : hands) EXPECT_EQ(meant.size(), k_expression_count) << hand;
  }
  for (const auto& [hand, meant] : held_out) EXPECT_FALSE(seen.contains(hand)) << hand;
}

TEST(DrawingSets, TheFaceAtRestIsOfTheSameHandAndThingsHaveNone) {
  const auto set = drawing_set(Group::seen);
  std::size_t things = 0;
  for (const SharedDrawing& one : set) {
    const SharedDrawing* rest = rest_by_the_same_hand(set, one);
    things += one.face ? 0 : 1;
    ASSERT_EQ(rest != nullptr, one.face) << one.name;
    if (rest == nullptr) continue;
    EXPECT_EQ(rest->name, one.folder + "_neutral");
    EXPECT_GE(rest->drawing.lines.size(), 3U) << rest->name;
  }
  EXPECT_EQ(things, 18U);
}

TEST(DrawingSets, SidesAreOfExpressionsThatHaveThem) {
  for (const Group group : {Group::seen, Group::held_out}) {
    for (const SharedDrawing& one : drawing_set(group)) {
      EXPECT_EQ(one.side.has_value(), one.face && has_side(one.meant)) << one.name;
      EXPECT_LE(one.drawing.lines.size(), portrait::k_most_drawn_lines) << one.name;
    }
  }
}

TEST(DrawingOfAKnownPose, LinesOverTheFaceLieOnTheirMarksWithinTheHand) {
  const Rig& rig = some_rig();
  const auto kept = face_of(rig);
  const JudgedFace& face = *kept;
  const rig::Pose pose = pose_of(face.rig(), rig.poses.front().values);
  for (const Artist& artist : artists_for(Group::seen)) {
    const auto drawing = draw_known(face, pose, artist, {0, true}, 3, 4);
    const CameraPicture picture(face, drawing.yaw_degrees);
    ASSERT_GE(drawing.lines.size(), 5U);
    for (const MeantLine& line : drawing.lines) {
      portrait::DrawnLine mark = picture.seen(pose)[line.right.front()];
      for (PxPoint& p : mark) p = picture.on_camera(p);
      double farthest = 0;
      for (const PxPoint& p : line.points) {
        double least = 1e300;
        for (const PxPoint& q : resampled(mark, 200)) least = std::min(least, geometry::distance(p, q));
        farthest = std::max(farthest, least);
      }
      // A tremor of 2 px, a double 2.5 px beside, an end a tenth of the line too long.
      EXPECT_LT(farthest, 12 + 0.11 * geometry::distance(mark.front(), mark.back())) << artist.name;
    }
  }
}

TEST(DrawingOfAKnownPose, TheRightLabelsAreAllRightAndOthersAreNot) {
  const Rig& rig = some_rig();
  const auto kept = face_of(rig);
  const JudgedFace& face = *kept;
  const auto drawing =
      draw_known(face, pose_of(face.rig(), rig.poses.front().values), artists_for(Group::seen)[0], {0.1, false}, 3, 4);
  std::vector<portrait::LineRead> right, wrong;
  for (const MeantLine& line : drawing.lines) {
    right.emplace_back().curve = line.right.front();
    wrong.emplace_back();
  }
  EXPECT_EQ(right_labels(drawing, right), drawing.lines.size());
  EXPECT_EQ(right_labels(drawing, wrong), 0U);
}

TEST(DrawingOfAKnownPose, WhatIsOffIsFartherFromItsMark) {
  const Rig& rig = some_rig();
  const auto kept = face_of(rig);
  const JudgedFace& face = *kept;
  const rig::Pose rest = rig::rest_pose(face.rig());
  std::vector<double> far;
  for (const double off : {0.0, 0.1, 0.2}) {
    double sum = 0;
    for (std::uint64_t seed = 1; seed < 6; ++seed) {
      const auto drawing = draw_known(face, rest, artists_for(Group::seen)[0], {off, true}, seed, seed);
      const CameraPicture picture(face, drawing.yaw_degrees);
      for (const MeantLine& line : drawing.lines) {
        portrait::DrawnLine mark = picture.rest()[line.right.front()];
        for (PxPoint& p : mark) p = picture.on_camera(p);
        sum += apart(line.points, mark) / static_cast<double>(drawing.lines.size());
      }
    }
    far.push_back(sum);
  }
  EXPECT_LT(2 * far[0], far[1]);
  EXPECT_LT(1.3 * far[1], far[2]);
}

}  // namespace
}  // namespace penpose::judges::drawn
