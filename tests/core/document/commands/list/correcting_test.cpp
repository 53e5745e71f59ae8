#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/models/laughing_head.h"

// Correcting a target touches what is touched: the other side and the rest of the feature hold still.

namespace penpose::document {
namespace {

using geometry::PxPoint;

/// The built-in head, with a smile that was drawn for its mouth.
class DrawnSmile {
 public:
  DrawnSmile() : head_(tests::demo_character()), view_(head_.view_from(0)) {
    EXPECT_TRUE(head_.perform(DrawReference{{view_, mouth()}}));
    EXPECT_TRUE(head_.perform(SetParameters{{{"mouth_corner_L", 0.5}, {"mouth_corner_R", 0.5}}}));
    const auto smile = mouth();
    EXPECT_TRUE(head_.perform(ResetParameters{}));
    EXPECT_TRUE(head_.perform(DrawTarget{k_mouth, view_, smile, {}}));
    EXPECT_GT(value("mouth_corner_L"), 0.15);
    EXPECT_GT(value("mouth_corner_R"), 0.15);
  }

  static constexpr CurveId k_mouth{1};

  [[nodiscard]] double value(const std::string& name) const {
    const auto parameters = head_.document().model->rig->parameters();
    return head_.document().pose[*rig::find_parameter(parameters, name)];
  }
  /// How far a corner of the mouth is up, by what lifts it and what pulls it down.
  [[nodiscard]] double corner(const std::string& side) const {
    return value("mouth_corner" + side) - value("mouth_frown" + side);
  }
  [[nodiscard]] const rig::Pose& pose() const { return head_.document().pose; }
  [[nodiscard]] const std::vector<PxPoint>& line() const { return find_curve(head_.document(), k_mouth)->target->line; }
  void pull(PxPoint at, PxPoint by) {
    EXPECT_TRUE(head_.perform(PullTarget{k_mouth, view_, at, by, curve::k_usual_reach}));
  }
  void draw_over(const std::vector<PxPoint>& stroke) {
    EXPECT_TRUE(head_.perform(OversketchTarget{k_mouth, view_, stroke}));
  }
  /// The largest change since another pose of what is not of one of the sides.
  [[nodiscard]] double changed_besides(const rig::Pose& before, const std::string& side) const {
    const auto parameters = head_.document().model->rig->parameters();
    double most = 0;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (!parameters[i].name.ends_with(side)) most = std::max(most, std::abs(pose()[i] - before[i]));
    }
    return most;
  }
  /// Which side of the model is at the end of the line: "_L" or "_R".
  [[nodiscard]] std::string side_at(PxPoint end) const { return (end.x > 0.5 * view_.viewport.width) ? "_L" : "_R"; }

 private:
  [[nodiscard]] std::vector<PxPoint> mouth() const {
    const auto camera = geometry::Camera::make(view_.camera, view_.viewport).value();
    std::vector<PxPoint> line;
    for (const NamedCurve& curve : head_.document().model->curves) {
      if (curve.name != "lip_lower_inner") continue;
      for (const auto& p : positions_of(head_.document(), curve.points)) line.push_back(camera.project(p).value());
    }
    return line;
  }

  character::Character head_;
  View view_;
};

TEST(Correcting, ACornerThatIsPulledUpOrDownMovesItsSideAlone) {
  for (const bool up : {true, false}) {
    DrawnSmile smile;
    const rig::Pose before = smile.pose();
    const PxPoint end = up ? smile.line().back() : smile.line().front();
    const std::string side = smile.side_at(end);
    const double was = smile.corner(side);
    smile.pull(end, up ? PxPoint{4, -16} : PxPoint{0, 16});
    const double moved = smile.corner(side) - was;
    EXPECT_GT(up ? moved : -moved, 0.15);
    EXPECT_LT(smile.changed_besides(before, side), 0.01);
  }
}

TEST(Correcting, APartThatIsRedrawnIsAPart) {
  DrawnSmile smile;
  const rig::Pose before = smile.pose();
  const auto line = smile.line();
  const std::string side = smile.side_at(line.back());
  const double was = smile.corner(side);
  // From two thirds on it goes on flat.
  const PxPoint from = line[42];
  std::vector<PxPoint> flat;
  for (int i = 0; i <= 20; ++i) flat.push_back({from.x + (line.back().x - from.x) * i / 20, from.y});
  smile.draw_over(flat);
  EXPECT_LT(smile.corner(side), was - 0.1);
  EXPECT_LT(smile.changed_besides(before, side), 0.01);
}

}  // namespace
}  // namespace penpose::document
