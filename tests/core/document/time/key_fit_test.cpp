#include "core/document/time/key_fit.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace penpose::document {
namespace {

TEST(KeyFit, FewKeysKeepASmoothCurveWithinTheTolerance) {
  std::vector<double> moments;
  std::vector<rig::Pose> poses;
  for (int f = 0; f <= 72; ++f) {
    moments.push_back(f / 24.0);
    poses.push_back({0.5 + 0.3 * std::sin(2 * moments.back()), 0.2 * moments.back()});
  }
  const std::vector<std::size_t> controls{0, 1};
  KeyFit fit(moments, poses, controls);
  const auto errors = [&] {
    std::vector<double> off;
    for (std::size_t f = 0; f < poses.size(); ++f) {
      const rig::Pose is = fit.fitted(f);
      off.push_back(std::max(std::abs(is[0] - poses[f][0]), std::abs(is[1] - poses[f][1])));
    }
    return off;
  };
  fit.refine(0.002, errors);
  const auto off = errors();
  EXPECT_LE(*std::max_element(off.begin(), off.end()), 0.002);
  EXPECT_LE(fit.keys().size(), moments.size() / 5);
  EXPECT_EQ(fit.keys().front(), 0U);
  EXPECT_EQ(fit.keys().back(), poses.size() - 1);
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_EQ(fit.at(c, 0).first, poses.front()[c]);
    EXPECT_EQ(fit.at(c, poses.size() - 1).first, poses.back()[c]);
  }
}

TEST(KeyFit, WhereNothingElseHelpsEveryPoseIsAKey) {
  const std::vector<double> moments{0, 1, 2, 3, 4};
  const std::vector<rig::Pose> poses{{0.0}, {1.0}, {0.0}, {1.0}, {0.0}};
  const std::vector<std::size_t> controls{0};
  KeyFit fit(moments, poses, controls);
  fit.refine(1e-6, [&] {
    std::vector<double> off;
    for (std::size_t f = 0; f < poses.size(); ++f) off.push_back(std::abs(fit.fitted(f)[0] - poses[f][0]));
    return off;
  });
  for (std::size_t f = 0; f < poses.size(); ++f) EXPECT_NEAR(fit.fitted(f)[0], poses[f][0], 1e-6) << f;
}

}  // namespace
}  // namespace penpose::document
