#pragma once

#include <initializer_list>

#include "core/portrait/sketch/face_layout.h"

namespace penpose::portrait {

/// Labels a mark with the likeliest part that is none of `without`, on a face that is `scale` times as large as usual
/// around its eyes.
void label(FaceMark& mark, double scale, std::initializer_list<FacePart> without = {});

/// Makes the labels of a layout agree: what is outside of the head is no part of it, one outline and one mouth stay,
/// and a whole face has a mouth.
void settle_labels(FaceLayout& layout, bool whole_face);

[[nodiscard]] bool is_of_eye(const FaceMark& mark);

/// Returns how much a mark counts among the lines of a face: the root of its length.
[[nodiscard]] double weight_of(const FaceMark& mark);

}  // namespace penpose::portrait
