#include "core/intent/model/control_fields.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "tests/support/models/test_rigs.h"

namespace penpose::intent {
namespace {

/// Random ways of some of many vertices, as all of them and as those alone.
struct Ways {
  std::vector<ModelPoint> rest, moved;
  std::vector<std::uint32_t> vertices;
  std::vector<ModelPoint> few_rest, few_moved;

  Ways(std::size_t count, std::size_t share, tests::Random& random) {
    for (std::uint32_t v = 0; v < count; ++v) {
      rest.push_back(ModelPoint(v, 1, 2));
      moved.push_back(rest.back());
      if (random(0, 1) * static_cast<double>(share) >= 1) continue;
      moved.back() += random.vector(1);
      vertices.push_back(v);
      few_rest.push_back(rest.back());
      few_moved.push_back(moved.back());
    }
  }
};

TEST(ControlFields, AreTheSameWhetherAllVerticesAreGivenOrThoseThatMove) {
  tests::Random random(1);
  constexpr std::size_t k_count = 7000;  // more than samples
  const Ways first(k_count, 3, random);
  ControlFields all(first.rest);
  ControlFields few(first.rest);
  std::vector<std::uint32_t> every;
  for (std::uint32_t v = 0; v < k_count; ++v) every.push_back(v);
  std::vector<Ways> ways{first};
  for (const std::size_t share : {1U, 2U, 50U, 7000U}) ways.emplace_back(k_count, share, random);
  for (const Ways& one : ways) {
    all.add(every, one.rest, one.moved, -1.5);
    few.add(one.vertices, one.few_rest, one.few_moved, -1.5);
  }
  for (std::size_t a = 0; a < ways.size(); ++a) {
    EXPECT_TRUE(std::ranges::equal(all.field(a).samples, few.field(a).samples));
    EXPECT_TRUE(std::ranges::equal(all.field(a).ways, few.field(a).ways));
    EXPECT_EQ(all.square(a), few.square(a));
    EXPECT_EQ(all.usual_way(a), few.usual_way(a));
    for (std::size_t b = 0; b < ways.size(); ++b) {
      double sum = 0;
      for (const std::uint32_t v : all.samples()) {
        const ModelVector one = (ways[a].moved[v] - ways[a].rest[v]) * -1.5;
        const ModelVector other = (ways[b].moved[v] - ways[b].rest[v]) * -1.5;
        sum += one.x * other.x + one.y * other.y + one.z * other.z;
      }
      EXPECT_EQ(few.product(a, b), sum) << "as over all samples, bit for bit";
      EXPECT_EQ(all.product(a, b), sum);
    }
    for (std::size_t back = 1; back <= std::min<std::size_t>(a, 2); ++back)
      EXPECT_EQ(few.product_with_last(a, back), few.product(a, a - back));
  }
}

TEST(ControlFields, HoldOnlyWhatMoves) {
  const std::vector<ModelPoint> rest{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const std::vector<ModelPoint> moved{{0, 0, 0}, {1, 3, 0}, {2, 0, 0}};
  ControlFields fields(rest);
  fields.add(std::vector<std::uint32_t>{0, 1, 2}, rest, moved, 2);
  fields.add({}, {}, {}, 0);
  ASSERT_EQ(fields.control_count(), 2U);
  ASSERT_EQ(fields.field(0).samples.size(), 1U);
  EXPECT_EQ(fields.field(0).samples[0], 1U);
  EXPECT_EQ(fields.field(0).ways[0], (ModelVector{0, 6, 0}));
  EXPECT_TRUE(fields.field(1).samples.empty());
  EXPECT_EQ(fields.square(1), 0);
}

}  // namespace
}  // namespace penpose::intent
