#include "core/document/features/feature_curves.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "core/character/demo_head.h"

namespace penpose::document {
namespace {

TEST(FeatureCurves, ALineThatSomebodyNamedTakesThePlaceOfTheOneThatLiesThere) {
  Model model = character::make_demo_head().value();
  const intent::WholeModel whole = intent::measure_whole_model(*model.rig);
  NamedCurve own;
  for (const NamedCurve& curve : model.curves) {
    if (curve.name == "lip_upper_inner") own = curve;
  }
  ASSERT_FALSE(own.points.empty());
  own.name = "mouth above";
  model.curves = {};
  const auto found = names_of(feature_curves_of(model, whole, {}).value().curves);
  ASSERT_EQ(std::count(found.begin(), found.end(), "lip_upper_inner"), 1);
  model.curves = {own};
  const auto names = names_of(feature_curves_of(model, whole, {}).value().curves);
  EXPECT_EQ(names.size(), found.size()) << "the others are still found";
  EXPECT_EQ(names.front(), own.name);
  EXPECT_EQ(std::count(names.begin(), names.end(), "lip_upper_inner"), 0);
}

}  // namespace
}  // namespace penpose::document
