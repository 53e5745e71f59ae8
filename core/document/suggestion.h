#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/commands/command.h"
#include "core/document/document.h"

// Completes a pose from keyed poses (core/prior). Nothing here changes a document; the command SuggestRest does.

namespace penpose::document {

/// A control affects a drawn line if it moves the line by at least this share of the movement by the strongest control.
inline constexpr double k_least_say = 0.1;

/// Parameters that count as posed by the artist, by name in the order of the rig: locked ones; those neither at rest
/// nor at their value on the timeline at the document's time (if the current pose is keyed: not at rest); and those
/// that affect a curve with a target or a constraint, because changing them would spoil the drawing.
[[nodiscard]] std::vector<std::string> posed_parameters(const Document& document);

/// A suggestion that is not accepted yet.
struct Suggestion {
  SuggestRest command;   ///< accepts it
  rig::Pose pose;        ///< after it
  std::size_t keys = 0;  ///< distinct keys it was learned from
  double shrinkage = 0;  ///< of their covariance, 0..1
};

/// The suggestion from keyed poses of the document's rig with these parameters held. `strength`: none takes the one at
/// which suggestions of this kind come nearest to the keys themselves, each left out in turn (prior::trust). A key
/// equal to the current pose is not learned from: it adds no information. Errors: those of the command.
[[nodiscard]] base::Result<Suggestion> suggest_rest(const Document& document, std::span<const PoseKey> keys,
                                                    std::vector<std::string> held,
                                                    std::optional<double> strength = std::nullopt);

/// The same with the keys of the document's own timeline and its posed parameters: the window's offer.
[[nodiscard]] base::Result<Suggestion> suggest_rest(const Document& document);

/// Why the timeline allows no suggestion for any pose; nothing where it does.
[[nodiscard]] std::optional<base::Error> no_suggestion(const Document& document);

}  // namespace penpose::document
