#include "core/inference/weights.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <string>

namespace penpose::inference {
namespace {

TEST(Weights, NoneIsNegativeAndTheEvidenceIsTakenAsItIs) {
  const Weights& table = learned_weights();
  for (const double weight : table.by.values()) EXPECT_GE(weight, 0);
  EXPECT_EQ(table.by[Term::evidence], 1) << "an energy is -log of a likelihood";
  EXPECT_EQ(table.by[Term::taught], 1);
}

TEST(Weights, EachScaleIsListedOnceWithANumber) {
  std::set<std::string> names;
  for (const Scale& scale : scales()) {
    EXPECT_TRUE(names.insert(scale.name).second) << scale.name;
    EXPECT_TRUE(std::isfinite(learned_weights().*scale.value));
  }
  EXPECT_EQ(sizeof(Weights), sizeof(Terms) + scales().size() * sizeof(double)) << "none is left out";
}

}  // namespace
}  // namespace penpose::inference
