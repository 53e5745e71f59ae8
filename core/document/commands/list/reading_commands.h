#pragma once

#include <cstdint>

#include "core/document/commands/command_members.h"
#include "core/document/commands/command_parts.h"
#include "core/document/drawing/pose_curve.h"

namespace penpose::document {

/// Takes another reading of the last line in place of the one there is, which can be taken back in the same way; later
/// lines follow the choice (Document::taken). Errors: the curve's line is not the last one any more, no such reading.
struct TakeReading {
  static constexpr Called k_called{"take_reading", "Take another reading"};
  CurveId curve;
  std::uint32_t which = 0;  ///< of Moment::others
  static auto members(auto& self) { return base::named("curve", self.curve, "which", self.which); }
};
Changed run(const Document&, const TakeReading&, ApplyParts&);

}  // namespace penpose::document
