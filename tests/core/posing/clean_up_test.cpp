#include "core/posing/clean_up.h"

#include <functional>
#include <gtest/gtest.h>
#include <set>
#include <vector>

namespace penpose::posing {
namespace {

/// A solution whose energy depends on the set of variables that went back.
class Solved final : public Revertible {
 public:
  Solved(std::size_t count, std::function<double(const std::set<std::size_t>&)> energy,
         std::set<std::size_t> unchanged = {})
      : count_(count), energy_(std::move(energy)), unchanged_(std::move(unchanged)) {}
  [[nodiscard]] std::size_t count() const override { return count_; }
  [[nodiscard]] bool changed(std::size_t i) const override { return !unchanged_.contains(i) && !back_.contains(i); }
  double energy_without(std::size_t i) override {
    auto with = back_;
    with.insert(i);
    return energy_(with);
  }
  void put_back(std::size_t i) override {
    EXPECT_TRUE(changed(i));
    back_.insert(i);
    order.push_back(i);
  }
  [[nodiscard]] double energy() const { return energy_(back_); }
  std::vector<std::size_t> order;

 private:
  std::size_t count_;
  std::function<double(const std::set<std::size_t>&)> energy_;
  std::set<std::size_t> unchanged_;
  std::set<std::size_t> back_;
};

/// Each variable has its price; the prices add up.
auto priced(std::vector<double> price) {
  return [price = std::move(price)](const std::set<std::size_t>& back) {
    double sum = 1;
    for (const std::size_t i : back) sum += price[i];
    return sum;
  };
}

TEST(CleanUp, PutsBackWhatWasChangedWithoutNeedInOrderOfLeastChange) {
  Solved solved(4, priced({0.003, 5, 0.001, 0.002}));
  EXPECT_EQ(clean_up(solved, 1.01), 3U);
  EXPECT_EQ(solved.order, (std::vector<std::size_t>{2, 3, 0}));
}

TEST(CleanUp, TogetherTheyCannotUndoTheSolution) {
  // Each alone would be within the limit, but no three together.
  Solved solved(5, priced({0.004, 0.004, 0.004, 0.004, 0.004}));
  EXPECT_EQ(clean_up(solved, 1.01), 2U);
  EXPECT_LE(solved.energy(), 1.01);
  EXPECT_EQ(solved.order, (std::vector<std::size_t>{0, 1})) << "of equals the first";
}

TEST(CleanUp, OneOfTwoThatDoTheSameStays) {
  // Either may go, but one of them is needed.
  Solved solved(2, [](const std::set<std::size_t>& back) { return back.size() == 2 ? 100.0 : 1.0; });
  EXPECT_EQ(clean_up(solved, 1.5), 1U);
  EXPECT_EQ(solved.energy(), 1.0);
}

TEST(CleanUp, ALargerResetMayFitWhereASmallerOneDoesNot) {
  // 0 and 1 belong together; 2 is dearer than 1 alone, yet fits beside 0.
  Solved solved(3, [](const std::set<std::size_t>& back) {
    double sum = 1 + 0.001 * static_cast<double>(back.count(0)) + 0.002 * static_cast<double>(back.count(1)) +
                 0.003 * static_cast<double>(back.count(2));
    if (back.contains(0) && back.contains(1)) sum += 1;
    return sum;
  });
  EXPECT_EQ(clean_up(solved, 1.01), 2U);
  EXPECT_EQ(solved.order, (std::vector<std::size_t>{0, 2}));
}

TEST(CleanUp, LeavesAloneWhatDidNotMove) {
  Solved solved(3, priced({0, 0, 0}), {0, 2});
  EXPECT_EQ(clean_up(solved, 1), 1U);
  EXPECT_EQ(solved.order, (std::vector<std::size_t>{1}));
  Solved nothing(0, priced({}));
  EXPECT_EQ(clean_up(nothing, 1), 0U);
}

}  // namespace
}  // namespace penpose::posing
