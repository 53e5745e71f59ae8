#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/document/model.h"
#include "ui/demo/pose_expression.h"

namespace penpose::demo {

/// What the demo makes of the built-in head.
struct Demo {
  document::Model model;  ///< articulated, posed as the first expression, with an animation through all of them
  std::vector<PosedExpression> expressions;
  double build_us = 0;  ///< the head and all its deformers
};

/// Articulates the built-in head from the bundled sketch and poses every bundled expression from rest.
[[nodiscard]] base::Result<Demo> run_demo();

}  // namespace penpose::demo
