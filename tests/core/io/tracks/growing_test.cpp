#include "core/io/tracks/growing.h"

#include <cmath>
#include <gtest/gtest.h>

namespace penpose::io {
namespace {

using Values = std::vector<std::optional<double>>;

TEST(Growing, FindsWhatIsOutOfOrder) {
  const auto repeated = find_growing(Values{1, 2, 2, 3});
  EXPECT_EQ(repeated.in_order, (std::vector<bool>{true, true, false, true}));
  EXPECT_EQ(repeated.astray, 1U);
  EXPECT_TRUE(repeated.trusted());
  EXPECT_EQ(find_growing(Values{1, 2, 90, 3, 4}).in_order, (std::vector<bool>{true, true, false, true, true}));
  EXPECT_EQ(find_growing(Values{1, 2, 3, 1, 4}).in_order, (std::vector<bool>{true, true, true, false, true}));
  EXPECT_FALSE(find_growing(Values{0, 0, 0, 0}).trusted());
  EXPECT_FALSE(find_growing(Values{1, 2, 3, 1, 2, 3}).trusted());
  EXPECT_FALSE(find_growing(Values{1, std::nullopt, std::nullopt}).trusted());
  EXPECT_TRUE(find_growing(Values{}).in_order.empty());
}

TEST(Growing, PlacesTheOthersBetweenAndBeyond) {
  const Values times{std::nullopt, 1.0, 0.5, std::nullopt, 2.5, 2.5};
  Growing growing = find_growing(times);
  growing.in_order = {false, true, false, false, true, false};
  EXPECT_EQ(placed_between(times, growing, std::vector<double>{0, 1, 2, 3, 4, 5}),
            (std::vector<double>{0.5, 1, 1.5, 2, 2.5, 3}));
}

TEST(UsualStep, IsThatOfMostWithoutGapsAndRounding) {
  EXPECT_EQ(usual_step({}), 0);
  EXPECT_EQ(usual_step(Values{3, 2, 2}), 0);
  EXPECT_EQ(usual_step(Values{0, 1, 900, 2, 3, std::nullopt, 70, 71}), 1);
  Values times;
  for (int i = 0; i < 61; ++i) times.emplace_back(std::round(1000 * i / 30.0) / 1000);
  times.emplace_back(10000);
  EXPECT_NEAR(usual_step(times), 1 / 30.0, 1e-9);
}

TEST(FindLeap, IsWhatNoRecordingHas) {
  Values values{0, 1, 2, 3, 55, 56};
  EXPECT_FALSE(find_leap(values, find_growing(values), 10));
  values[4] = 64;
  values[5] = 65;
  EXPECT_EQ(find_leap(values, find_growing(values), 10), 4U);
  EXPECT_FALSE(find_leap(values, find_growing(values), 100));
  for (const Values& few : {Values{5}, Values{0, std::nullopt, 900}, Values{0, 1, 0, 1, 900}})
    EXPECT_FALSE(find_leap(few, find_growing(few), 10));
}

}  // namespace
}  // namespace penpose::io
