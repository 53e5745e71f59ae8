#include "core/intent/model/composites.h"

#include <gtest/gtest.h>

#include "core/intent/model/whole_model.h"
#include "tests/core/intent/face.h"

namespace penpose::intent {
namespace {

using tests::Face;

TEST(Composites, AnExpressionIsTheSumOfItsShapes) {
  Face face = tests::usual_face();
  face.sum("joy", {{0, 1.0}, {1, 1.0}, {2, 0.5}});
  face.sum("aa", {{5, 0.4}, {4, 0.6}});
  face.ready();
  const WholeModel whole = measure_whole_model(*face.rig);
  const Composite& joy = whole.composites[face.number("joy")];
  const std::vector<std::size_t> corners{face.number("cornerLeft"), face.number("cornerRight")};
  for (const std::size_t corner : corners) EXPECT_EQ(std::count(joy.of.begin(), joy.of.end(), corner), 1);
  EXPECT_GT(joy.parts, 2.0);
  EXPECT_LE(joy.parts, 3.0) << "the brow is a small part";
  EXPECT_GT(whole.composites[face.number("aa")].parts, 1.3);
  for (const char* shape : {"cornerLeft", "jawOpen", "lipUp", "swell"}) {
    EXPECT_EQ(whole.composites[face.number(shape)].parts, 1.0) << shape;
    EXPECT_TRUE(whole.composites[face.number(shape)].of.empty()) << shape;
  }
}

TEST(Composites, WhatGoesFartherThanAnyOtherIsNoSum) {
  // The half of a shape is the shape by half; twice a shape is more than that can.
  Face face = tests::usual_face();
  face.sum("half", {{0, 0.5}});
  face.ready();
  const WholeModel whole = measure_whole_model(*face.rig);
  for (const Composite& one : whole.composites) EXPECT_EQ(one.parts, 1.0);
}

}  // namespace
}  // namespace penpose::intent
