#include "core/intent/model/places_moved.h"

#include <gtest/gtest.h>

#include "tests/core/intent/face.h"

namespace penpose::intent {
namespace {

TEST(PlacesMoved, AnExpressionMovesSeveralAndAMouthOne) {
  tests::Face face;
  face.bump("mouth", 0, -0.4, {0, 0.1, 0});
  face.bump("left_lid", -0.5, 0.5, {0, -0.1, 0}, 0.2);
  face.bump("right_lid", 0.5, 0.5, {0, -0.06, 0}, 0.2);
  face.sum("kiss", {{0, 1}, {1, 1}, {2, 1}});
  face.ready();
  const WholeModel whole = measure_whole_model(*face.rig);
  EXPECT_EQ(whole.places[0].size(), 1U);
  ASSERT_EQ(whole.places[3].size(), 3U);
  EXPECT_NEAR(whole.places[3][0].way, 0.1, 0.01) << "places come in the order of their samples";
  EXPECT_NEAR(whole.places[3][1].way, 0.1, 0.01);
  EXPECT_NEAR(whole.places[3][2].way, 0.06, 0.01);
}

TEST(PlacesMoved, WhatHardlyMovesIsNoPlace) {
  tests::Face face;
  face.bump("mouth", 0, -0.4, {0, 0.1, 0});
  face.bump("brow", 0.5, 0.5, {0, 0.1, 0}, 0.2);
  face.sum("smile", {{0, 1}, {1, 0.2}});
  face.ready();
  EXPECT_EQ(measure_whole_model(*face.rig).places[2].size(), 1U);
}

}  // namespace
}  // namespace penpose::intent
