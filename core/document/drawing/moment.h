#pragma once

#include "core/document/document.h"

// Lines that are read together (Moment).

namespace penpose::document {

/// Whether a reference that has this share of its points drawn anew is drawn anew as a whole.
inline constexpr double k_drawn_anew = 0.8;

/// The moment in which a target was just drawn for a reference of the document, whose line comes last: the one that
/// goes on, with what was set since in its base; or a new one that begins with the pose as it is, where time, rig or
/// curves have changed. Then what is left of the lines of the same time is held where it stands. Points of earlier
/// lines that the reference covers in about the same view ask for nothing any more. Precondition: the curve is a
/// reference of the document and has a target.
[[nodiscard]] Moment moment_of(const Document& document, CurveId drawn);

/// A moment with nothing but this line, from the pose as it is.
[[nodiscard]] Moment lone_moment(const Document& document, CurveId drawn);

/// The moment of all lines at once, which were solved for from the document's pose and came to `posed`; null: no lines.
[[nodiscard]] std::shared_ptr<const Moment> moment_of_all(const Document& document, rig::Pose posed);

/// References of which later lines have covered as much as k_drawn_anew: they are drawn anew.
[[nodiscard]] std::vector<CurveId> drawn_anew(const Moment& moment);

}  // namespace penpose::document
