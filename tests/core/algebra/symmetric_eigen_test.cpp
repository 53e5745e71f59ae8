#include "core/algebra/symmetric_eigen.h"

#include <gtest/gtest.h>
#include <vector>

namespace penpose::algebra {
namespace {

TEST(SymmetricEigen, TheLargestComesFirst) {
  const SymmetricEigen eigen = symmetric_eigen({2, 0, 0, 0, 5, 0, 0, 0, 3}, 3);
  EXPECT_EQ(eigen.values, (std::vector<double>{5, 3, 2}));
  EXPECT_EQ(eigen.vectors, (std::vector<double>{0, 1, 0, 0, 0, 1, 1, 0, 0}));
}

}  // namespace
}  // namespace penpose::algebra
