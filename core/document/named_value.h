#pragma once

#include <string>

namespace penpose::document {

/// A parameter and its value.
struct NamedValue {
  std::string name;
  double value = 0;
  friend bool operator==(const NamedValue&, const NamedValue&) = default;
};

}  // namespace penpose::document
