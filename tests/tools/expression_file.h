#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/curve/stroke.h"
#include "core/geometry/camera.h"

namespace penpose::tests {

/// Two strokes in one view: a line on the face at rest, and where that line should go. px of the viewport.
struct DrawnPair {
  std::vector<curve::PxPoint> reference;
  std::vector<curve::PxPoint> target;
  std::optional<geometry::CameraPose> camera;  ///< set when the camera moved before both were drawn
};

/// An expression as it was drawn. No values of parameters: those are what the solver finds.
struct Expression {
  std::string name;
  geometry::CameraPose camera;
  std::vector<DrawnPair> curves;
};

struct ExpressionFile {
  geometry::Viewport viewport;
  std::vector<Expression> expressions;
};

/// Reads {"viewport": [w, h], "expressions": [{"name", "camera", "curves": [{"reference": [[x, y], ...], "target": [[x,
/// y], ...], "camera" (if moved)}]}]}; a camera is that of a sketch file. Other keys are skipped. Errors (place: JSON
/// pointer): no JSON, a key that is missing or of another type, an empty name or one that is there twice.
[[nodiscard]] base::Result<ExpressionFile> read_expressions(std::string_view text);

}  // namespace penpose::tests
