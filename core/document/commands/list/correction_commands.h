#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/articulation/sketch.h"
#include "core/document/commands/command_members.h"
#include "core/document/commands/command_parts.h"

// Commands of corrections.

namespace penpose::document {

/// Begins a correction of the pose that several controls make together; its curves are drawn on the model in that
/// pose, as a deformer's are on the model at rest. Errors: fewer than two controls or more than eight away from rest, a
/// control that no correction can follow.
struct BeginCorrection {
  static constexpr Called k_called{"begin_correction", "Begin a correction"};
  std::string name;                 ///< empty: "correction N" with the first free N
  std::vector<NamedValue> drivers;  ///< empty: all controls that are away from rest, as they are
  articulation::Mode mode = articulation::Mode::automatic;
  static auto members(auto& self) { return base::named("name", self.name, "drivers", self.drivers, "mode", self.mode); }
};
Changed run(const Document&, const BeginCorrection&, ApplyParts&);

struct DeleteCorrection {
  static constexpr Called k_called{"delete_correction", "Delete a correction"};
  std::string correction;
  static auto members(auto& self) { return base::named("correction", self.correction); }
};
Changed run(const Document&, const DeleteCorrection&, ApplyParts&);

using CorrectionCommands = std::variant<BeginCorrection, DeleteCorrection>;

}  // namespace penpose::document
