#include "core/io/tracks/increasing_values.h"

#include <cmath>
#include <gtest/gtest.h>

namespace penpose::io {
namespace {

using Values = std::vector<std::optional<double>>;

TEST(IncreasingValues, FindsWhatIsOutOfOrder) {
  const auto repeated = find_increasing(Values{1, 2, 2, 3});
  EXPECT_EQ(repeated.in_order, (std::vector<bool>{true, true, false, true}));
  EXPECT_EQ(repeated.out_of_order, 1U);
  EXPECT_TRUE(repeated.trusted());
  EXPECT_EQ(find_increasing(Values{1, 2, 90, 3, 4}).in_order, (std::vector<bool>{true, true, false, true, true}));
  EXPECT_EQ(find_increasing(Values{1, 2, 3, 1, 4}).in_order, (std::vector<bool>{true, true, true, false, true}));
  EXPECT_FALSE(find_increasing(Values{0, 0, 0, 0}).trusted());
  EXPECT_FALSE(find_increasing(Values{1, 2, 3, 1, 2, 3}).trusted());
  EXPECT_FALSE(find_increasing(Values{1, std::nullopt, std::nullopt}).trusted());
  EXPECT_TRUE(find_increasing(Values{}).in_order.empty());
}

TEST(IncreasingValues, PlacesTheOthersBetweenAndBeyond) {
  const Values times{std::nullopt, 1.0, 0.5, std::nullopt, 2.5, 2.5};
  IncreasingValues increasing = find_increasing(times);
  increasing.in_order = {false, true, false, false, true, false};
  EXPECT_EQ(interpolate_missing(times, increasing, std::vector<double>{0, 1, 2, 3, 4, 5}),
            (std::vector<double>{0.5, 1, 1.5, 2, 2.5, 3}));
}

TEST(UsualStep, IsThatOfMostWithoutGapsAndRounding) {
  EXPECT_EQ(typical_step({}), 0);
  EXPECT_EQ(typical_step(Values{3, 2, 2}), 0);
  EXPECT_EQ(typical_step(Values{0, 1, 900, 2, 3, std::nullopt, 70, 71}), 1);
  Values times;
  for (int i = 0; i < 61; ++i) times.emplace_back(std::round(1000 * i / 30.0) / 1000);
  times.emplace_back(10000);
  EXPECT_NEAR(typical_step(times), 1 / 30.0, 1e-9);
}

TEST(FindLeap, IsWhatNoRecordingHas) {
  Values values{0, 1, 2, 3, 55, 56};
  EXPECT_FALSE(find_leap(values, find_increasing(values), 10));
  values[4] = 64;
  values[5] = 65;
  EXPECT_EQ(find_leap(values, find_increasing(values), 10), 4U);
  EXPECT_FALSE(find_leap(values, find_increasing(values), 100));
  for (const Values& few : {Values{5}, Values{0, std::nullopt, 900}, Values{0, 1, 0, 1, 900}})
    EXPECT_FALSE(find_leap(few, find_increasing(few), 10));
}

}  // namespace
}  // namespace penpose::io
