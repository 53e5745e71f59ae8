#pragma once

#include <optional>
#include <span>

#include "tests/judges/drawing/known/known_drawing.h"

namespace penpose::judges::drawn {

/// How well a drawing of a known pose was read.
struct KnownVerdict {
  std::size_t right = 0, of = 0;        ///< lines given a mark that is right
  std::optional<double> error_percent;  ///< |found - true| / |true| over all vertices; none of a face at rest
  double stray_percent = 0;             ///< the largest movement of what should not move, of the diagonal of the marks
};

/// `found`: the pose that a drawing was read as; `lines`: what each of its lines was taken for.
[[nodiscard]] KnownVerdict judged(const JudgedFace& face, const rig::Pose& meant, const rig::Pose& found,
                                  const KnownDrawing& drawing, std::span<const portrait::LineRead> lines);

}  // namespace penpose::judges::drawn
