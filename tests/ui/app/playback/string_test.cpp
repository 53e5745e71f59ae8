#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/document/time/timeline.h"
#include "core/intent/model/whole_model.h"
#include "tests/support/models/laughing_head.h"
#include "ui/app/playback/performance.h"
#include "ui/app/playback/thin_take.h"
#include "ui/app/session/live_follow.h"

// A target as a puppet's string: what is pulled follows from the first px on, and the take has few keys.

namespace penpose::app {
namespace {

/// The built-in head with a smile that was drawn, at its mouth.
struct Puppet {
  character::Character head = tests::demo_character();
  document::View view = head.view_from(0);
  static constexpr document::CurveId k_mouth{1};

  Puppet() {
    EXPECT_TRUE(head.perform(document::DrawReference{{view, mouth()}}));
    EXPECT_TRUE(head.perform(document::SetParameters{{{"mouth_corner_L", 0.5}, {"mouth_corner_R", 0.5}}}));
    const auto smile = mouth();
    EXPECT_TRUE(head.perform(document::ResetParameters{}));
    EXPECT_TRUE(head.perform(document::DrawTarget{k_mouth, view, smile, {}}));
  }
  [[nodiscard]] std::vector<geometry::PxPoint> mouth() const {
    const auto camera = geometry::Camera::make(view.camera, view.viewport).value();
    std::vector<geometry::PxPoint> line;
    for (const document::NamedCurve& curve : document().model->curves) {
      if (curve.name != "lip_lower_inner") continue;
      for (const auto& p : document::positions_of(document(), curve.points)) line.push_back(camera.project(p).value());
    }
    return line;
  }
  [[nodiscard]] const document::Document& document() const { return head.document(); }
  [[nodiscard]] std::size_t number(const std::string& name) const {
    return *rig::find_parameter(document().model->rig->parameters(), name);
  }
  [[nodiscard]] geometry::PxPoint end() const { return document::find_curve(document(), k_mouth)->target->line.back(); }
};

/// Pulls the end of the mouth up and back, in so many steps; what is performed in two seconds.
Performance pull_up_and_back(const Puppet& puppet, int steps, std::vector<double>& values, double& others) {
  LiveFollow follow;
  follow.begin_drag(puppet.document(), Puppet::k_mouth, puppet.view, PullHold{puppet.end()}, true);
  EXPECT_TRUE(follow.active());
  const std::string side = puppet.end().x > 0.5 * puppet.view.viewport.width ? "_L" : "_R";
  const std::size_t held = puppet.number("mouth_corner" + side);
  const rig::Pose& still = puppet.document().pose;
  Performance performance(0, 24, still);
  others = 0;
  for (int i = 0; i <= steps; ++i) {
    const double u = 1 - std::abs(2.0 * i / steps - 1);
    follow.drag({4 * u, -12 * u});
    values.push_back(follow.pose()[held]);
    for (std::size_t p = 0; p < still.size(); ++p)
      others = std::max(others, p == held ? 0 : std::abs(follow.pose()[p] - still[p]));
    performance.take(2.0 * i / steps, follow.pose());
  }
  return performance;
}

TEST(String, ACornerFollowsThePenFromTheFirstPxOnAndTheOtherSideHoldsStill) {
  const Puppet puppet;
  std::vector<double> values;
  double others = 0;
  static_cast<void>(pull_up_and_back(puppet, 40, values, others));
  EXPECT_GT(values[20], values[0] + 0.2);
  for (std::size_t i = 1; i <= 20; ++i) {
    EXPECT_TRUE(values[i] > values[i - 1] || values[i] == 1.0) << i << ": until it can go no farther";
    EXPECT_LT(values[i], values[i - 1] + 0.05) << i << ": no jump";
  }
  EXPECT_NEAR(values[40], values[0], 1e-9) << "it goes back with the pen";
  EXPECT_LT(others, 0.01);
}

TEST(String, ATakeHasAFifthOfItsFramesAsKeysAndLooksTheSame) {
  const Puppet puppet;
  std::vector<double> values;
  double others = 0;
  const Performance performance = pull_up_and_back(puppet, 96, values, others);
  const auto parameters = puppet.document().model->rig->parameters();
  const auto all = performance.keys(parameters, puppet.document().pose);
  ASSERT_TRUE(all);
  const auto whole = intent::measure_whole_model(*puppet.document().model->rig);
  const auto few = thinned(puppet.document(), *all, *whole.fields, puppet.view);
  EXPECT_EQ(few.names, all->names);
  EXPECT_LE(5 * few.times_s.size(), all->times_s.size());
  EXPECT_EQ(few.times_s.front(), all->times_s.front());
  EXPECT_EQ(few.times_s.back(), all->times_s.back());
  // Every vertex of the model, frame by frame.
  document::Document dense = puppet.document();
  character::Character a{dense};
  character::Character b{dense};
  ASSERT_TRUE(a.perform(*all));
  ASSERT_TRUE(b.perform(few));
  const auto camera = geometry::Camera::make(puppet.view.camera, puppet.view.viewport).value();
  std::vector<rig::ModelPoint> at(dense.model->mesh->positions().size());
  std::vector<rig::ModelPoint> is(at.size());
  double worst = 0;
  for (const double time_s : all->times_s) {
    dense.model->rig->evaluate(document::pose_at(a.document(), time_s), at);
    dense.model->rig->evaluate(document::pose_at(b.document(), time_s), is);
    for (std::size_t v = 0; v < at.size(); ++v) {
      const auto from = camera.project(at[v]);
      const auto to = camera.project(is[v]);
      if (from && to) worst = std::max(worst, geometry::distance(*from, *to));
    }
  }
  EXPECT_LE(worst, 1.05 * k_take_px);
}

}  // namespace
}  // namespace penpose::app
