#pragma once

#include <optional>
#include <string>

#include "core/articulation/edit.h"
#include "core/document/commands/apply_parts.h"

// What the commands of deformers and corrections have in common.

namespace penpose::document {

/// The set that edits start from; the one without deformers where there is none.
[[nodiscard]] articulation::SketchedDeformers::Shared deformers_of(const Document& document);

/// The number of the deformer of that name. Error (place "deformer"): there is none.
[[nodiscard]] base::Result<std::size_t> deformer_number(const Document& document, const std::string& name);

/// The document with deformer `number` built again from another sketch.
[[nodiscard]] Changed with_deformer_from(const Document& document, std::size_t number,
                                         const articulation::Sketch& sketch, Parts& work);

/// The document with another sketch in the making.
[[nodiscard]] Document with_pending(const Document& document, PendingSketch pending);

/// What the deformer or correction in the making is drawn on.
[[nodiscard]] base::Result<std::shared_ptr<const articulation::Canvas>> pending_canvas(const Document& document,
                                                                                       Parts& work);

/// Error: a correction is drawn at another pose than the model stands in.
[[nodiscard]] base::Status check_pending_pose(const Document& document);

/// The number of the correction of that name.
[[nodiscard]] std::optional<std::size_t> correction_number(const Document& document, const std::string& name);
/// A correction with one curve drawn anew, under another name, or with its mirror image beside it, which follows the
/// controls of the other side (those without a side stay). Errors: those of the sketch (without a place of a list), no
/// symmetry, and a name that is taken.
[[nodiscard]] Changed with_redrawn_correction(const Document& document, std::size_t number, const RedrawCurve& command);
[[nodiscard]] Changed with_renamed_correction(const Document& document, std::size_t number, const std::string& to);
[[nodiscard]] Changed with_mirrored_correction(const Document& document, std::size_t number, const std::string& to,
                                               Parts& work);

/// The correction that was begun, with its last curve drawn.
[[nodiscard]] Changed with_correction(const Document& document, const articulation::Sketch& sketch);

}  // namespace penpose::document
