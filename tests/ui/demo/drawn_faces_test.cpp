#include <cmath>
#include <gtest/gtest.h>

#include "core/character/demo_head.h"
#include "core/document/commands/apply.h"
#include "core/drawing/tool.h"

// What an artist draws on the head that the program begins with is what its face does.

namespace penpose::demo {
namespace {

using document::PxPoint;
using Line = std::vector<PxPoint>;

class DrawnFaces : public testing::Test {
 protected:
  DrawnFaces() : document_(document::make_document(*character::make_demo_head())) {
    view_.camera = {{0, -0.0173, 0.7837}, {0, -0.0173, 0.003}, {0, 1, 0}, 30};
    view_.viewport = {1000, 1000};
  }

  /// A named curve of the head as the view shows it.
  [[nodiscard]] Line curve(const std::string& name) const {
    const auto camera = geometry::Camera::make(view_.camera, view_.viewport).value();
    const auto positions = document::posed_positions(*document_.model);
    Line line;
    for (const auto& one : document_.model->curves) {
      if (one.name != name) continue;
      for (const auto& p : one.points)
        line.push_back(*camera.project(mesh::position_of(p, document_.model->mesh->triangles(), positions)));
    }
    return line;
  }
  /// A line wider by a factor and moved by px down, of its share from -1 to 1.
  template <typename Down>
  static Line moved(Line line, double wider, const Down& down) {
    const double middle = 0.5 * (line.front().x + line.back().x);
    const double half = 0.5 * (line.back().x - line.front().x);
    for (PxPoint& p : line) {
      p.y += down((p.x - middle) / half);
      p.x = middle + wider * (p.x - middle);
    }
    return line;
  }
  void draw(const Line& reference, const Line& target) {
    document::ApplyWorkspace work;
    auto drawn = document::apply(document_, document::DrawReference{view_, reference}, work);
    ASSERT_TRUE(drawn.ok()) << drawn.error().line();
    const document::CurveId id = drawn->curves.back()->id;
    auto posed = document::apply(*drawn, document::DrawTarget{id, view_, target, {}}, work);
    ASSERT_TRUE(posed.ok()) << posed.error().line();
    pose_ = posed->pose;
    drawn_ = *posed;
  }
  [[nodiscard]] double value(const std::string& name) const {
    return pose_[*rig::find_parameter(document_.model->rig->parameters(), name)];
  }

  document::Document document_;
  document::View view_;
  document::Document drawn_;  ///< the document with what was drawn last
  rig::Pose pose_;
};

TEST_F(DrawnFaces, ASmileLiftsBothCornersOfTheMouth) {
  const Line mouth = curve("lip_upper_inner");
  for (const double wider : {1.08, 1.16}) {
    draw(mouth, moved(mouth, wider, [](double x) { return 5 - 25 * x * x; }));
    EXPECT_GT(value("mouth_corner_L"), 0.3) << wider;
    EXPECT_GT(value("mouth_corner_R"), 0.3) << wider;
    EXPECT_EQ(value("jaw"), 0);
  }
}

TEST_F(DrawnFaces, AFrownPullsBothCornersDown) {
  // From near by: what a control does has to be more than a hand's doubt.
  view_.camera = {{0, -0.03, 0.6}, {0, -0.03, 0}, {0, 1, 0}, 20};
  const auto frown = [](double x) { return 13 * std::pow(x, 8); };
  const Line upper = curve("lip_upper_inner");
  const Line lower = curve("lip_lower_inner");
  draw(upper, moved(upper, 1, frown));
  document_ = drawn_;
  draw(lower, moved(lower, 1, frown));
  EXPECT_GT(value("mouth_frown_L"), 0.3);
  EXPECT_GT(value("mouth_frown_R"), 0.3);
}

TEST_F(DrawnFaces, ALineAlongClosedLipsBelongsToTheLipThatItsGoalMoves) {
  for (const char* lip : {"lip_upper_inner", "lip_lower_inner"}) {
    const Line mouth = curve(lip);
    draw(mouth, moved(mouth, 1, [](double x) { return 5 + 45 * (1 - x * x); }));
    EXPECT_GT(value("jaw"), 0.5) << lip;
  }
}

TEST_F(DrawnFaces, ALineThatOvershootsStraightOnMovesNothing) {
  Line mouth = curve("lip_upper_inner");
  Line longer = mouth;
  longer.insert(longer.begin(), mouth.front() + (mouth.front() - mouth[3]));
  longer.push_back(mouth.back() + (mouth.back() - mouth[mouth.size() - 4]));
  draw(mouth, longer);
  EXPECT_EQ(pose_, document_.pose);
}

}  // namespace
}  // namespace penpose::demo
