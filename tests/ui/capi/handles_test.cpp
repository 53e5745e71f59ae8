#include <gtest/gtest.h>
#include <set>

#include "tests/support/c_desk.h"

namespace penpose::tests {
namespace {

TEST(CHandles, AFreedHandleNamesNothingForEver) {
  CDesk desk;
  penpose_handle copy = 0;
  ASSERT_EQ(penpose_character_copy(desk.open, desk.sheet, &copy, nullptr), PENPOSE_OK);
  ASSERT_EQ(penpose_free(desk.open, copy, nullptr), PENPOSE_OK);
  EXPECT_EQ(penpose_free(desk.open, copy, &desk.error), PENPOSE_BAD_HANDLE);
  EXPECT_NE(std::string(desk.error.message).find("names nothing"), std::string::npos);
  // What is made next lies in the same place.
  penpose_handle next = 0;
  ASSERT_EQ(penpose_character_copy(desk.open, desk.sheet, &next, nullptr), PENPOSE_OK);
  EXPECT_NE(next, copy);
  EXPECT_EQ(penpose_solve(desk.open, copy, 0, nullptr), PENPOSE_BAD_HANDLE);
  EXPECT_EQ(penpose_solve(desk.open, next, 0, nullptr), PENPOSE_OK);
}

TEST(CHandles, NoHandleIsGivenOutTwiceAndAllCanBeFreed) {
  CDesk desk;
  std::set<penpose_handle> seen{desk.sheet};
  for (int round = 0; round < 10; ++round) {
    std::vector<penpose_handle> made(100);
    for (penpose_handle& one : made) {
      ASSERT_EQ(penpose_character_copy(desk.open, desk.sheet, &one, nullptr), PENPOSE_OK);
      EXPECT_TRUE(seen.insert(one).second);
    }
    for (const penpose_handle one : made) EXPECT_EQ(penpose_free(desk.open, one, nullptr), PENPOSE_OK);
  }
  std::size_t count = 0;
  EXPECT_EQ(penpose_handle_count(desk.open, &count, nullptr), PENPOSE_OK);
  EXPECT_EQ(count, 1U);
}

TEST(CHandles, AThousandCharactersOfTheirOwnAreMadeAndFreed) {
  CDesk desk;
  for (int i = 0; i < 1000; ++i) {
    penpose_handle made = 0;
    ASSERT_EQ(penpose_character_from_arrays(desk.open, &desk.sheet_arrays.arrays, &made, nullptr), PENPOSE_OK);
    // Every other one is left for the library's end.
    if (i % 2 == 0) {
      ASSERT_EQ(penpose_free(desk.open, made, nullptr), PENPOSE_OK);
    }
  }
  std::size_t count = 0;
  EXPECT_EQ(penpose_handle_count(desk.open, &count, nullptr), PENPOSE_OK);
  EXPECT_EQ(count, 501U);
}

TEST(CHandles, AHandleOfAnotherKindIsRefused) {
  CDesk desk;
  const std::uint32_t curve = desk.draw(desk.line(-0.5, 0.5, 0.5, 0.5));
  penpose_handle live = 0;
  ASSERT_EQ(penpose_live_begin(desk.open, desk.sheet, curve, &desk.view, &live, &desk.error), PENPOSE_OK)
      << desk.error.message;
  EXPECT_EQ(penpose_solve(desk.open, live, 0, &desk.error), PENPOSE_BAD_HANDLE);
  EXPECT_NE(std::string(desk.error.message).find("another kind"), std::string::npos);
  double values[2];
  EXPECT_EQ(penpose_live_follow(desk.open, desk.sheet, nullptr, 0, values, 2, nullptr, nullptr), PENPOSE_BAD_HANDLE);
  EXPECT_EQ(penpose_live_follow(desk.open, live ^ (std::uint64_t{3} << 56U), nullptr, 0, values, 2, nullptr, nullptr),
            PENPOSE_BAD_HANDLE);
  EXPECT_EQ(penpose_free(desk.open, 0, nullptr), PENPOSE_BAD_HANDLE);
  EXPECT_EQ(penpose_free(desk.open, ~std::uint64_t{0}, nullptr), PENPOSE_BAD_HANDLE);
}

TEST(CHandles, ALibraryClosesOnceWithAllThatLivesInIt) {
  penpose_close(nullptr);
  penpose_library* library = nullptr;
  penpose_close(&library);
  ASSERT_EQ(penpose_open(&library, nullptr), PENPOSE_OK);
  penpose_close(&library);
  EXPECT_EQ(library, nullptr);
  penpose_close(&library);
  EXPECT_EQ(penpose_free(nullptr, 1, nullptr), PENPOSE_BAD_ARGUMENT);
}

TEST(CHandles, TheVersionOfTheInterfaceIsTheHeaders) {
  EXPECT_EQ(penpose_abi_version(), static_cast<std::uint32_t>(PENPOSE_ABI_VERSION));
  EXPECT_STRNE(penpose_version(), "");
}

}  // namespace
}  // namespace penpose::tests
