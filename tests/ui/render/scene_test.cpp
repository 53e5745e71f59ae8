#include "ui/render/scene.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace penpose::render {
namespace {

TEST(Scene, ReferencesAreGreenTargetsBlueConstraintsRed) {
  const Color reference = curve_color(CurveKind::reference);
  const Color target = curve_color(CurveKind::target);
  const Color constraint = curve_color(CurveKind::constraint);
  EXPECT_GT(reference.g, 2 * std::max(reference.r, reference.b));
  EXPECT_GT(target.b, 2 * std::max(target.r, target.g));
  EXPECT_GT(constraint.r, 2 * std::max(constraint.g, constraint.b));
}

}  // namespace
}  // namespace penpose::render
