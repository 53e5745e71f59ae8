#pragma once

#include "core/base/result.h"

namespace penpose::tests {

/// The error of a result; one that says so where it has none.
template <typename T>
[[nodiscard]] base::Error error_of(const base::Result<T>& result) {
  return result ? base::Error{"(no error)", "", ""} : result.error();
}

}  // namespace penpose::tests
