#include "core/head/skin.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <map>
#include <utility>

#include "core/base/math.h"
#include "core/geometry/rotation.h"

namespace penpose::head {
namespace {

const Half& half() {
  static const Half made = make_half().value();
  return made;
}
ModelPoint eye() { return {k_eye_center[0], k_eye_center[1], k_eye_center[2]}; }

TEST(Skin, NoFaceIsDegenerateOrTurnsBackOnItsNeighbour) {
  // Normals of neighbours part by less than 120 degrees, also at the thin rims of the lids; only where the lips lie on
  // each other does the surface turn back.
  std::vector<ModelVector> normals;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> quad_at;
  for (std::size_t q = 0; q < half().quads.size(); ++q) {
    const mesh::Quad& v = half().quads[q];
    const auto& p = half().points;
    const ModelVector n = glm::cross(p[v[2]] - p[v[0]], p[v[3]] - p[v[1]]);
    EXPECT_GT(geometry::length(n), 1e-4) << p[v[0]].x << " " << p[v[0]].y << " " << p[v[0]].z;
    normals.push_back(geometry::normalized(n));
    for (std::size_t k = 0; k < 4; ++k) quad_at[{v[k], v[(k + 1) & 3U]}] = q;
  }
  for (const auto& [edge, q] : quad_at) {
    const auto other = quad_at.find({edge.second, edge.first});
    if (other == quad_at.end()) continue;
    const ModelPoint& p = half().points[edge.first];
    const double seam = std::max(half().marks[edge.first].y, half().marks[edge.second].y);
    if (seam < 1.1) continue;
    EXPECT_GT(glm::dot(normals[q], normals[other->second]), -0.5) << p.x << " " << p.y << " " << p.z;
  }
}

TEST(Skin, LidRimsLieOnTheEyeball) {
  int rim = 0;
  for (std::size_t v = 0; v < half().points.size(); ++v) {
    if (std::abs(half().marks[v].x) > 1e-6) continue;
    ++rim;
    const double away = geometry::distance(half().points[v], eye()) / k_eye_radius;
    EXPECT_GE(away, 1.01);
    EXPECT_LT(away, 1.05);
  }
  EXPECT_EQ(rim, 48);
}

TEST(Skin, UpperLidClosesOverTheEyeball) {
  // Turning a lid about the eye's centre keeps its distance from the ball. The rim's middle comes down to the lower
  // rim.
  const auto rotate = [](const ModelPoint& p, double angle) {
    return eye() + geometry::rotation_about({1, 0, 0}, angle) * (p - eye());
  };
  const auto elevation = [](const ModelPoint& p) { return base::atan2(p.y - eye().y, p.z - eye().z); };
  double high = -4;
  double low = 4;
  for (std::size_t v = 0; v < half().points.size(); ++v) {
    if (std::abs(half().marks[v].x) > 1e-6 || std::abs(half().points[v].x - eye().x) > 0.3) continue;
    high = std::max(high, elevation(half().points[v]));
    low = std::min(low, elevation(half().points[v]));
  }
  ASSERT_GT(high - low, 0.45);
  for (std::size_t v = 0; v < half().points.size(); ++v) {
    const double loop = half().marks[v].x;
    if (loop < 0 || loop > 2.01 || half().points[v].y < eye().y) continue;
    const double weight = 1 - loop / 3;
    const ModelPoint closed = rotate(half().points[v], (high - low) * weight);
    EXPECT_GT(geometry::distance(closed, eye()), k_eye_radius * 1.01);
  }
}

TEST(Skin, OpenMouthShowsACavity) {
  // Behind the seam there is room: the lining reaches far back and apart.
  double back = 1e300;
  double top = -1e300;
  double bottom = 1e300;
  double seam = 0;
  for (std::size_t v = 0; v < half().points.size(); ++v) {
    const ModelPoint& p = half().points[v];
    const double loop = half().marks[v].y;
    if (loop > 0.01) continue;
    if (loop > -0.01 && p.x < 0.3) seam = std::max(seam, p.z);
    back = std::min(back, p.z);
    top = std::max(top, p.y);
    bottom = std::min(bottom, p.y);
  }
  EXPECT_GT(seam - back, 2);
  EXPECT_GT(top - bottom, 1.5);
}

TEST(Skin, LipsDoNotCross) {
  for (std::size_t v = 0; v < half().points.size(); ++v) {
    const LoopMark& mark = half().marks[v];
    if (mark.y < -1.5 || mark.y > 2 || std::abs(mark.z) < 1e-6) continue;
    const double above = (half().points[v].y - seam_height(half().points[v].z)) * mark.z;
    EXPECT_GT(above, 0);
  }
}

TEST(Skin, CoarseAndFineMeetWithoutCracks) {
  const Skin skin = make_skin(half());
  // A vertex on an edge of the coarse side would leave a border; the only border of the whole is the neck.
  for (const Surface* part : {&skin.bare, &skin.lips, &skin.brows, &skin.lining, &skin.lashes}) {
    ASSERT_FALSE(part->triangles.empty());
    for (const mesh::Triangle& t : part->triangles) {
      const ModelVector n =
          glm::cross(part->points[t[1]] - part->points[t[0]], part->points[t[2]] - part->points[t[0]]);
      EXPECT_GT(geometry::length(n), 1e-6);
    }
  }
}

}  // namespace
}  // namespace penpose::head
