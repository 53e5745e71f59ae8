#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <map>

#include "core/curve/polyline.h"
#include "core/geometry/bvh.h"
#include "core/head/head.h"
#include "ui/demo/run_demo.h"

// What somebody who looks at the pictures of the head and of the demo's expressions sees.
namespace penpose::demo {
namespace {

using geometry::ModelPoint;
using geometry::ModelVector;
using Line = std::vector<ModelPoint>;

class HeadLooks : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto made = run_demo();
    ASSERT_TRUE(made.ok()) << made.error().line();
    demo_ = new Demo(std::move(made).value());
  }
  static void TearDownTestSuite() { delete demo_; }

  static const document::Model& model() { return *demo_->document.model; }
  static Line posed(const rig::Pose& pose) {
    document::Model posed = model();
    posed.pose = pose;
    return document::posed_positions(posed);
  }
  static Line rest() { return posed(rig::rest_pose(*model().rig)); }
  static Line with(const std::string& name, double value) {
    rig::Pose pose = rig::rest_pose(*model().rig);
    pose[*rig::find_parameter(model().rig->parameters(), name)] = value;
    return posed(pose);
  }
  static Line expression(const std::string& name) {
    for (const NamedPose& one : demo_->poses) {
      if (one.name == name) return posed(one.pose);
    }
    ADD_FAILURE() << "no expression " << name;
    return posed(rig::rest_pose(*model().rig));
  }
  static Line curve(const std::string& name, const Line& positions) {
    Line points;
    for (const auto& curve : model().curves) {
      if (curve.name != name) continue;
      for (const auto& p : curve.points) points.push_back(mesh::position_of(p, model().mesh->triangles(), positions));
    }
    return points;
  }
  static double mean_move(const std::string& part, const Line& now) {
    const Line rest = HeadLooks::rest();
    for (const mesh::Part& one : model().mesh->parts()) {
      if (one.name != part) continue;
      double sum = 0;
      for (std::uint32_t v = one.first_vertex; v < one.first_vertex + one.vertex_count; ++v) {
        sum += geometry::distance(rest[v], now[v]) / one.vertex_count;
      }
      return sum;
    }
    ADD_FAILURE() << "no part " << part;
    return 0;
  }

  static Demo* demo_;
};
Demo* HeadLooks::demo_ = nullptr;

TEST_F(HeadLooks, JawTakesChinTeethAndTongueAlongAndLeavesTheUpperTeeth) {
  const Line rest = HeadLooks::rest();
  const auto open = with("jaw", 1);
  const auto middle = [](const Line& line) { return line[line.size() / 2]; };
  const double lip = geometry::distance(middle(curve("lip_lower", open)), middle(curve("lip_lower", rest)));
  const double chin = geometry::distance(middle(curve("jaw", open)), middle(curve("jaw", rest)));
  EXPECT_GT(lip, 0.012);
  EXPECT_GT(chin, 0.8 * lip);
  EXPECT_GT(mean_move("teeth_lower", open), 0.5 * lip);
  EXPECT_GT(mean_move("tongue", open), 0.3 * lip);
  EXPECT_EQ(mean_move("teeth", open), 0.0);
  EXPECT_LT(middle(curve("jaw", open)).z, middle(curve("jaw", rest)).z) << "it turns, and so goes back";
}

TEST_F(HeadLooks, MouthsOpenToARoundedShape) {
  for (const char* name : {"laugh", "surprised"}) {
    const auto now = expression(name);
    const auto upper = curve("lip_upper_inner", now);
    const auto lower = curve("lip_lower_inner", now);
    const std::size_t half = upper.size() / 2;
    const auto gap = [&](std::size_t i) { return upper[i].y - lower[i].y; };
    const double most = gap(half);
    EXPECT_GT(most, 0.006) << name;
    // Where the mouth is 60 % of the way to its corner: an ellipse is open by 80 % there, a V by 40 %.
    const double there = std::abs(lower[half].x) + 0.6 * std::abs(lower.back().x - lower[half].x);
    std::size_t at = half;
    while (at + 1 < lower.size() && lower[at].x < there) ++at;
    EXPECT_GT(gap(at), 0.55 * most) << name;
    EXPECT_LT(gap(lower.size() - 1), 0.15 * most) << name << ": corners are corners";
  }
}

TEST_F(HeadLooks, PuckerComesForward) {
  const Line rest = HeadLooks::rest();
  const auto now = with("lips_pucker", 1);
  const auto middle = [](const Line& line) { return line[line.size() / 2]; };
  EXPECT_GT(middle(curve("lip_lower", now)).z - middle(curve("lip_lower", rest)).z, 0.004);
  EXPECT_GT(middle(curve("lip_upper", now)).z - middle(curve("lip_upper", rest)).z, 0.003);
}

TEST_F(HeadLooks, NothingBetweenTheBrowsIsLeftBehind) {
  const Line rest = HeadLooks::rest();
  rig::Pose pose = rig::rest_pose(*model().rig);
  for (const char* name : {"brow_inner_L", "brow_inner_R"}) {
    pose[*rig::find_parameter(model().rig->parameters(), name)] = 0.8;
  }
  const auto now = posed(pose);
  double middle = 0;
  double side = 0;
  for (std::size_t v = 0; v < rest.size(); ++v) {
    const ModelPoint& p = rest[v];
    if (p.z < 0.08 || std::abs(p.y - 0.03) > 0.003) continue;
    if (std::abs(p.x) < 0.001) middle = std::max(middle, now[v].y - p.y);
    if (std::abs(std::abs(p.x) - 0.011) < 0.002) side = std::max(side, now[v].y - p.y);
  }
  EXPECT_GT(side, 0.004);
  EXPECT_GT(middle, 0.5 * side);
}

/// How many of the lines of sight straight onto the nose's underside end in the dark lining.
int dark_nostril_sights() {
  const document::Model model = head::make_head();
  const std::vector<glm::vec3> positions(model.mesh->positions().begin(), model.mesh->positions().end());
  const geometry::TriangleBvh tree(positions, model.mesh->triangles());
  const auto parts = model.mesh->parts();
  const auto lining = std::find_if(parts.begin(), parts.end(), [](const mesh::Part& p) { return p.name == "lining"; });
  int dark = 0;
  for (double x = 0.004; x < 0.018; x += 0.0005) {
    for (double y = -0.047; y < -0.037; y += 0.0005) {
      const auto hit = tree.nearest_hit({{x, y, 0.6}, {0, 0, -1}});
      if (hit && hit->triangle >= lining->first_triangle &&
          hit->triangle < lining->first_triangle + lining->triangle_count) {
        ++dark;
      }
    }
  }
  return dark;
}

TEST_F(HeadLooks, NostrilsAreDarkAsSeenFromTheFront) { EXPECT_GT(dark_nostril_sights(), 15); }

TEST_F(HeadLooks, ASurprisedMouthIsRoundAndBothBrowsRiseAsAWhole) {
  const Line now = expression("surprised");
  const Line before = rest();
  const Line upper = curve("lip_upper_inner", now);
  const Line lower = curve("lip_lower_inner", now);
  const double height = upper[upper.size() / 2].y - lower[lower.size() / 2].y;
  EXPECT_LT(lower.back().x - lower.front().x, 2.2 * height);
  for (const char* name : {"brow_L", "brow_R"}) {
    const Line up = curve(name, now);
    const Line was = curve(name, before);
    for (std::size_t i = 0; i < up.size(); ++i) EXPECT_NEAR(up[i].y - was[i].y, 0.0085, 0.0035) << name << ' ' << i;
  }
}

TEST_F(HeadLooks, CornersGoDownInSadnessAndUpInASmile) {
  const Line was = curve("lip_lower_inner", rest());
  const Line sad = curve("lip_lower_inner", expression("sad"));
  const Line smile = curve("lip_lower_inner", expression("smile"));
  for (const std::size_t end : {std::size_t{0}, was.size() - 1}) {
    const std::size_t middle = was.size() / 2;
    EXPECT_LT(sad[end].y - sad[middle].y, was[end].y - was[middle].y - 0.002);
    EXPECT_GT(smile[end].y, was[end].y + 0.003);
  }
  // A frown bends the line evenly; no step beside the corner, as there was when a smile was drawn backwards.
  // The last points lie in the corner itself, where the line ends.
  for (std::size_t i = 3; i + 3 < sad.size(); ++i) {
    const double before = (sad[i].y - sad[i - 1].y) / (sad[i].x - sad[i - 1].x);
    const double after = (sad[i + 1].y - sad[i].y) / (sad[i + 1].x - sad[i].x);
    EXPECT_LT(std::abs(std::atan(after) - std::atan(before)), 0.6) << i;
  }
}

TEST_F(HeadLooks, AKissShutsTheEyesAndPushesTheLipsForward) {
  const Line now = expression("kiss");
  const Line before = rest();
  for (const char* side : {"_L", "_R"}) {
    const Line upper = curve(std::string("eyelid_upper") + side, now);
    const Line lower = curve(std::string("eyelid_lower") + side, now);
    const Line open = curve(std::string("eyelid_upper") + side, before);
    const std::size_t half = upper.size() / 2;
    EXPECT_LT(upper[half].y - lower[half].y, 0.15 * (open[half].y - lower[half].y)) << side;
  }
  const Line lips = curve("lip_upper", now);
  const Line lips_before = curve("lip_upper", before);
  EXPECT_GT(lips[lips.size() / 2].z, lips_before[lips.size() / 2].z + 0.004);
  EXPECT_LT(lips.back().x - lips.front().x, 0.75 * (lips_before.back().x - lips_before.front().x));
}

/// The sharpest fold of the skin between the brows, in degrees: of two triangles that share an edge.
double sharpest_fold(const document::Model& model, const Line& now) {
  const auto triangles = model.mesh->triangles();
  const auto normal = [&](const mesh::Triangle& t) {
    return geometry::normalized(glm::cross(now[t[1]] - now[t[0]], now[t[2]] - now[t[0]]), ModelVector{0});
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> sides;
  double sharpest = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const mesh::Triangle& t = triangles[i];
    const ModelPoint middle = (now[t[0]] + now[t[1]] + now[t[2]]) / 3.0;
    if (std::abs(middle.x) > 0.014 || middle.y < 0.012 || middle.y > 0.040 || middle.z < 0.05) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto side = std::minmax(t[k], t[(k + 1) % 3]);
      const auto [other, first] = sides.emplace(side, i);
      if (first) continue;
      const double cosine = glm::dot(normal(t), normal(triangles[other->second]));
      sharpest = std::max(sharpest, std::acos(std::clamp(cosine, -1.0, 1.0)) * 57.29577951308232);
    }
  }
  return sharpest;
}

TEST_F(HeadLooks, NoNotchOpensBetweenBrowsThatAreDrawnTogether) {
  const double at_rest = sharpest_fold(model(), rest());
  const double drawn_together = sharpest_fold(model(), expression("angry"));
  EXPECT_LT(drawn_together, at_rest + 10);
}

TEST_F(HeadLooks, RowsOfAClosingLidKeepTheirWidth) {
  const ModelPoint center = head::head_landmarks().left.center;
  const auto deformers = model().deformers->deformers();
  const auto& lid = **std::find_if(deformers.begin(), deformers.end(),
                                   [](const auto& one) { return one->sketch().name == "eyelid_upper_L"; });
  const Line rest = HeadLooks::rest();
  const Line closed = with("eyelid_upper_L", 1);
  // Rows by their elevation as seen from the ball's centre; the lowest hold the corners and what lies behind them.
  std::map<int, std::vector<std::uint32_t>> rows;
  for (const std::uint32_t v : lid.vertices()) {
    const ModelVector p = rest[v] - center;
    if (p.z > 0) rows[static_cast<int>(std::floor(std::atan2(p.y, p.z) / 0.06))].push_back(v);
  }
  double worst = 0;
  for (auto& [elevation, row] : rows) {
    if (elevation < 0 || row.size() < 12) continue;
    std::sort(row.begin(), row.end(), [&](std::uint32_t a, std::uint32_t b) { return rest[a].x < rest[b].x; });
    const std::uint32_t a = row[row.size() * 15 / 100];
    const std::uint32_t b = row[row.size() - 1 - row.size() * 15 / 100];
    worst = std::max(worst, std::abs((closed[b].x - closed[a].x) / (rest[b].x - rest[a].x) - 1));
  }
  EXPECT_LT(worst, 0.05);
  EXPECT_EQ(lid.strain().turned_over, 0U);
}

TEST_F(HeadLooks, NoControlTurnsATriangleOverOrStretchesBeyondTwiceItsTarget) {
  for (const auto& deformer : model().deformers->deformers()) {
    EXPECT_EQ(deformer->strain().turned_over, 0U) << deformer->sketch().name;
    const double ratio =
        curve::arc_length<ModelPoint>(deformer->target()) / curve::arc_length<ModelPoint>(deformer->reference());
    EXPECT_LE(deformer->strain().stretch, 2 * std::max(1.0, ratio)) << deformer->sketch().name;
  }
}

}  // namespace
}  // namespace penpose::demo
