#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/commands/command.h"
#include "core/document/document.h"

// The rest of a pose, suggested from those that are keyed (core/prior). Nothing here changes a document: the command
// SuggestRest does.

namespace penpose::document {

/// A control has a say in a drawn line where it moves the line by at least this share of what the control does that
/// moves it most.
inline constexpr double k_least_say = 0.1;

/// What counts as posed by the artist, by name in the order of the rig: parameters that are locked; that are neither at
/// rest nor where the timeline has them at the document's moment (of a pose that is keyed as it stands: not at rest);
/// and that have a say in a curve with a target or in a constraint, for they would spoil what was drawn.
[[nodiscard]] std::vector<std::string> posed_parameters(const Document& document);

/// A suggestion that is not taken yet.
struct Suggestion {
  SuggestRest command;   ///< takes it
  rig::Pose pose;        ///< after it
  std::size_t keys = 0;  ///< distinct ones that it was learned from
  double shrinkage = 0;  ///< of their covariance, 0..1
};

/// What keyed poses of the document's rig suggest where the parameters of those names are held. `strength`: none takes
/// that at which suggestions of this kind come nearest to the keys themselves, each left out in turn (prior::trust). A
/// key of the pose as it stands is not learned from: it says nothing new. Errors: those of the command.
[[nodiscard]] base::Result<Suggestion> suggest_rest(const Document& document, std::span<const PoseKey> keys,
                                                    std::vector<std::string> held,
                                                    std::optional<double> strength = std::nullopt);

/// The same of the keys of the document's own timeline and of what is posed: what the window offers.
[[nodiscard]] base::Result<Suggestion> suggest_rest(const Document& document);

/// Why the timeline allows no suggestion, whatever is posed; nothing where it does.
[[nodiscard]] std::optional<base::Error> no_suggestion(const Document& document);

}  // namespace penpose::document
