#include "ui/app/controls/control_parts.h"

#include <gtest/gtest.h>

#include "tests/support/models/sheet_model.h"

namespace penpose::app {
namespace {

/// A feature through vertices of the sheet, 15 a row from below to above.
portrait::FeatureCurve feature(const std::string& name, std::uint32_t row) {
  portrait::FeatureCurve curve{name, {}};
  for (std::uint32_t v = 15 * row + 4; v < 15 * row + 11; ++v) curve.points.push_back(posing::at_vertex(v));
  return curve;
}

TEST(ControlParts, AreToldByWhatControlsMoveAndNotByTheirNames) {
  // "lift" moves the upper half of the sheet, the more the higher; "lean" moves all of it alike.
  const document::Document document = document::make_document(tests::sheet_model());
  const std::vector<portrait::FeatureCurve> features{feature("lip_upper_outer", 2), feature("eyelid_upper_L", 8),
                                                     feature("brow_L", 13)};
  EXPECT_EQ(parts_by_effect(document, features)[0], FacePart::brows);
  const std::vector<portrait::FeatureCurve> turned{feature("brow_L", 2), feature("lip_upper_outer", 13)};
  EXPECT_EQ(parts_by_effect(document, turned)[0], FacePart::mouth);
}

TEST(ControlParts, WhatTurnsAllOfTheFaceIsOfNoPart) {
  const document::Document document = document::make_document(tests::sheet_model());
  const std::vector<portrait::FeatureCurve> features{feature("lip_upper_outer", 2), feature("brow_L", 12)};
  const auto parts = parts_by_effect(document, features);
  const auto number = rig::find_parameter(document.model->rig->parameters(), "base.ry");
  EXPECT_EQ(parts[number.value()], FacePart::all);
}

TEST(ControlParts, WithoutFeaturesTheirNamesAreLeft) {
  const document::Document document = document::make_document(tests::sheet_model());
  const auto parts = parts_by_effect(document, {});
  EXPECT_EQ(parts.size(), document.pose.size());
  EXPECT_EQ(parts[0], part_of("lift"));
}

}  // namespace
}  // namespace penpose::app
