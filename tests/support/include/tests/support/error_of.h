#pragma once

#include <gtest/gtest.h>
#include <string>

#include "core/base/result.h"

namespace penpose::tests {

/// The error of a result; one that says so where it has none.
template <typename T>
[[nodiscard]] base::Error error_of(const base::Result<T>& result) {
  return result ? base::Error{"(no error)", "", ""} : result.error();
}

/// The place of a fault, which says what it is and what helps; "fine" where there is none.
[[nodiscard]] inline std::string place_of_fault(const base::Status& status) {
  if (status) return "fine";
  EXPECT_FALSE(status.error().what.empty());
  EXPECT_FALSE(status.error().remedy.empty());
  return status.error().place;
}

}  // namespace penpose::tests
