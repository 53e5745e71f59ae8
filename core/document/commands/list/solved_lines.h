#pragma once

#include <vector>

#include "core/document/commands/command_parts.h"
#include "core/document/document.h"

// What commands of posing have in common: solving for lines that were drawn.

namespace penpose::document {

/// Brings the references of a moment to their targets, one of which was just drawn. `stays`: points of its reference
/// that a correction does not touch (DrawnCurve::stays).
[[nodiscard]] Changed solved_for(Document document, CurveId drawn, ApplyParts& work,
                                 const std::vector<bool>& stays = {});

/// Solves for a target a part of which was changed. What is touched moves alone where the rig can do that; where it
/// cannot, the line is read as a whole. `stays`: as above.
[[nodiscard]] Changed corrected(const Document& document, const PoseCurve& other, const std::vector<bool>& stays,
                                ApplyParts& work);

}  // namespace penpose::document
