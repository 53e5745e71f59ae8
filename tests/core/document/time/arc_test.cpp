#include "core/document/time/arc.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "core/curve/distance.h"
#include "core/curve/polyline.h"
#include "core/document/commands/list/arc_commands.h"
#include "tests/support/document_hand.h"
#include "tests/support/models/sheet_model.h"

namespace penpose::document {
namespace {

constexpr int k_rate = 24;

std::vector<double> frames(double from_s, double to_s) {
  std::vector<double> moments;
  for (int f = 0; f <= static_cast<int>(std::lround((to_s - from_s) * k_rate)); ++f)
    moments.push_back(from_s + static_cast<double>(f) / k_rate);
  return moments;
}

/// The sheet keyed at 0, 1, 2 and 3 s, and a point of it that both of its shapes move.
class ArcHand : public tests::DocumentHand {
 public:
  ArcHand() {
    const std::vector<std::pair<double, double>> values{{0.2, -0.4}, {0.8, 0.4}, {0.5, 0.1}, {0.3, 0.6}};
    for (std::size_t k = 0; k < values.size(); ++k) {
      does(SetParameters{{{"lift", values[k].first}, {"lean", values[k].second}}});
      does(SetKey{static_cast<double>(k), ""});
    }
    const auto triangles = document().model->mesh->triangles();
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      const auto at = document().model->mesh->positions()[triangles[t][0]];
      if (at.x > 0.6F && at.y > 0.6F) point = {t, {1, 0, 0}};
    }
  }
  std::vector<PxPoint> places(std::span<const double> moments) const {
    const auto camera = geometry::Camera::make(view.camera, view.viewport).value();
    return arc_of(document(), posing::at_mesh_point(point, document().model->mesh->triangles()), camera,
                  poses_of_timeline(document(), moments));
  }
  RedrawArc redrawn(double from_s, double to_s, std::vector<PxPoint> line, std::vector<double> shares = {}) const {
    return {point, view, from_s, to_s, k_rate, std::move(line), std::move(shares)};
  }
  /// The arc with a bow across it, drawn with few points.
  std::vector<PxPoint> bowed(double from_s, double to_s, double px) const {
    const auto now = places(frames(from_s, to_s));
    const PxPoint along = now.back() - now.front();
    const double size = std::sqrt(geometry::dot(along, along));
    std::vector<PxPoint> line;
    for (int i = 0; i <= 30; ++i) {
      const double u = i / 30.0;
      line.push_back(now.front() + along * u + PxPoint{-along.y, along.x} * (4 * u * (1 - u) * px / size));
    }
    return line;
  }
  std::size_t keys_within(double from_s, double to_s) const {
    const auto& keys = document().timeline->keys;
    return static_cast<std::size_t>(std::count_if(
        keys.begin(), keys.end(), [&](const PoseKey& key) { return key.time_s >= from_s && key.time_s <= to_s; }));
  }

  mesh::MeshPoint point;
};

TEST(Arc, ARedrawnPathIsMetWithFewKeysAndNothingElseChanges) {
  ArcHand hand;
  const auto before = hand.places(frames(0, 3));
  const auto line = hand.bowed(1, 2, 25);
  hand.does(hand.redrawn(1, 2, line));
  const auto after = hand.places(frames(0, 3));
  double most = 0;
  for (std::size_t f = 0; f < after.size(); ++f) {
    if (f >= 24 && f <= 48) {
      most = std::max(most, curve::distance_to(line, after[f]));
    } else {
      EXPECT_LT(geometry::distance(after[f], before[f]), 0.02) << f;
    }
  }
  EXPECT_LT(most, 1) << "px off the line that was drawn";
  EXPECT_GT(geometry::distance(after[36], before[36]), 15);
  EXPECT_LE(hand.keys_within(1, 2), 5U);
}

TEST(Arc, AControlThatRestsStaysIfThoseThatMoveAreEnough) {
  ArcHand hand;
  for (std::size_t k = 0; k < 4; ++k) {
    hand.does(SetParameters{{{"lift", 0.2 * static_cast<double>(k)}, {"lean", 0.1}}});
    hand.does(SetKey{static_cast<double>(k), ""});
  }
  const auto moments = frames(1, 2);
  const auto before = hand.places(moments);
  std::vector<double> shares;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double u = static_cast<double>(i) / static_cast<double>(before.size() - 1);
    shares.push_back(u * (0.5 + 0.5 * u));
  }
  hand.does(hand.redrawn(1, 2, before, shares));
  EXPECT_GT(geometry::distance(hand.places(moments)[12], before[12]), 1) << "its pace is another one";
  const auto lean = rig::find_parameter(hand.document().model->rig->parameters(), "lean").value();
  for (const rig::Pose& pose : poses_of_timeline(hand.document(), moments)) EXPECT_NEAR(pose[lean], 0.1, 1e-12);
}

TEST(Arc, TheSpacingStaysUnlessTheLineHasAPaceOfItsOwn) {
  ArcHand hand;
  const auto moments = frames(0, 1);
  const auto share = [&](const std::vector<PxPoint>& places, std::size_t f) {
    return curve::shares_of(std::span<const PxPoint>(places)).value()[f];
  };
  const auto was = hand.places(moments);
  const auto line = hand.bowed(0, 1, 20);
  hand.does(hand.redrawn(0, 1, line));
  const auto kept = hand.places(moments);
  for (const std::size_t f : {6U, 12U, 18U}) EXPECT_NEAR(share(kept, f), share(was, f), 0.02) << f;
  // Half of the way in the last fifth of the time.
  std::vector<double> shares;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const double u = static_cast<double>(i) / static_cast<double>(line.size() - 1);
    shares.push_back(u < 0.5 ? 1.6 * u : 0.8 + 0.4 * (u - 0.5));
  }
  hand.does(hand.redrawn(0, 1, line, shares));
  const auto paced = hand.places(moments);
  EXPECT_NEAR(share(paced, 19), 0.5, 0.04);
  EXPECT_NEAR(share(paced, 10), 0.26, 0.04);
}

TEST(Arc, WhatCannotBeRedrawnIsRefused) {
  ArcHand hand;
  const auto line = hand.bowed(0, 1, 20);
  EXPECT_EQ(hand.refuses(hand.redrawn(1, 1, line)).place, "from_s");
  EXPECT_EQ(hand.refuses(hand.redrawn(0, 1, {line.front()})).place, "line");
  EXPECT_EQ(hand.refuses(hand.redrawn(0, 1, line, {0, 1})).place, "shares");
  EXPECT_EQ(hand.refuses(hand.redrawn(0, 3000, line)).place, "rate");
  RedrawArc other = hand.redrawn(0, 1, line);
  other.point.triangle = 99999;
  EXPECT_EQ(hand.refuses(other).place, "point");
  hand.does(LockParameters{{"lift", "lean", "base.rx", "base.ry", "base.rz"}, true});
  EXPECT_EQ(hand.refuses(hand.redrawn(0, 1, line)).place, "point") << "all that moves it is locked";
}

}  // namespace
}  // namespace penpose::document
