#include "ui/files/natural_order.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace penpose::files {
namespace {

TEST(NaturalOrder, ComparesNumbersAsNumbers) {
  const std::vector<std::string> ordered{"a",
                                         "a1b",
                                         "a1c",
                                         "a2b",
                                         "a10b",
                                         "b",
                                         "k01",
                                         "k1",
                                         "k1.5",
                                         "k1.10",
                                         "k2",
                                         "k10",
                                         "k99999999999999999998",
                                         "k99999999999999999999",
                                         "kx",
                                         "\xc3\xa4"};
  std::vector<std::string> names = ordered;
  for (int i = 0; i < 50; ++i) {
    std::next_permutation(names.begin() + 3, names.end());
    std::rotate(names.begin(), names.begin() + 5, names.end());
    std::vector<std::string> sorted = names;
    std::sort(sorted.begin(), sorted.end(), natural_less);
    ASSERT_EQ(sorted, ordered);
  }
  for (const std::string& name : ordered) EXPECT_FALSE(natural_less(name, name));
}

}  // namespace
}  // namespace penpose::files
