#pragma once

#include "core/document/document.h"

// Lines that are read together (Moment).

namespace penpose::document {

/// A reference with this share of its points redrawn counts as redrawn as a whole.
inline constexpr double k_drawn_anew = 0.8;

/// The moment after a target was drawn for a reference of the document; its line is the last. This is the current
/// moment, with values set since added to its base. If time, rig or curves have changed, it is a new one that begins
/// with the pose as it is, in which the remaining lines of the same time are constrained to where they are. Points of
/// earlier lines that the reference covers in about the same view are ignored from now on. Precondition: the curve is a
/// reference of the document and has a target.
[[nodiscard]] Moment moment_of(const Document& document, CurveId drawn);

/// A moment with only this line, from the pose as it is.
[[nodiscard]] Moment lone_moment(const Document& document, CurveId drawn);

/// The moment of all lines at once, solved from the document's pose with the result `posed`; null: no lines.
[[nodiscard]] std::shared_ptr<const Moment> moment_of_all(const Document& document, rig::Pose posed);

/// Whether the line of this curve is the last of the document's moment, with nothing but values set since.
[[nodiscard]] bool is_last_line(const Document& document, CurveId curve);

/// The document's pose with another reading of the last lines in place of the one taken. What was set since stays,
/// unless the readings differ in it. Precondition: the moment is of the document's rig and has such a reading.
[[nodiscard]] rig::Pose pose_of_reading(const Document& document, std::size_t which);

/// References that count as redrawn: later lines have covered k_drawn_anew of them.
[[nodiscard]] std::vector<CurveId> drawn_anew(const Moment& moment);

}  // namespace penpose::document
