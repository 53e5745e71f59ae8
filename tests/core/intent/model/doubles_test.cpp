#include "core/intent/model/doubles.h"

#include <gtest/gtest.h>

#include "tests/core/intent/face.h"

namespace penpose::intent {
namespace {

using tests::Face;

TEST(Doubles, AreSumsOfOthersAndControlsThatDoTheSame) {
  Face face = tests::usual_face();
  EXPECT_TRUE(doubles_of(measure_whole_model(*face.ready().rig)).empty());
  face = tests::usual_face();
  face.sum("both", {{0, 1.0}, {1, 1.0}});
  face.sum("half", {{0, 0.5}});
  const auto doubles = doubles_of(measure_whole_model(*face.ready().rig));
  ASSERT_EQ(doubles.size(), 2U);
  EXPECT_EQ(doubles[0].parameter, face.number("both"));
  EXPECT_EQ(doubles[0].of.size(), 2U);
  EXPECT_EQ(doubles[1].parameter, face.number("half"));
  EXPECT_EQ(doubles[1].of, std::vector<std::size_t>{0});
}

}  // namespace
}  // namespace penpose::intent
