#pragma once

#include <string>

#include "core/curve/stroke.h"

namespace penpose::document {

using curve::PxPoint;

/// A parameter and its value.
struct NamedValue {
  std::string name;
  double value = 0;
  friend bool operator==(const NamedValue&, const NamedValue&) = default;
};

}  // namespace penpose::document
