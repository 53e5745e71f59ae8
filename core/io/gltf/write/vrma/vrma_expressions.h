#pragma once

#include "core/base/result.h"
#include "core/document/model.h"
#include "core/io/gltf/write/vrma/vrma_builder.h"

namespace penpose::io {

/// Weights become those of the model's expressions, 0..1, whose sum is nearest to them (least squares); controls in
/// none of these become custom expressions of their names. `animation`: null: the pose is written. Errors: more keys
/// than can be written.
[[nodiscard]] base::Status write_vrma_expressions(const document::Model& model, const document::Animation* animation,
                                                  VrmaBuilder& file);

}  // namespace penpose::io
