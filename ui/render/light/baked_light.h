#pragma once

#include <atomic>
#include <memory>

#include "core/document/model.h"
#include "ui/render/scene.h"

namespace penpose::render {

/// Soft shadows of a model at rest by rays: how much of the sky each vertex sees, and the shade on the ground where it
/// stands (y points up). Takes up to 2 s for 30,000 vertices, so that whoever shows a model does it beside. What one
/// sees through casts none. Null: `stop` became true meanwhile, or the model has no size.
[[nodiscard]] std::shared_ptr<const BakedLight> bake_light(const document::Model& model, const Appearance& appearance,
                                                           const std::atomic<bool>* stop = nullptr);

/// How dark the shade on the ground is at most, 0..1.
inline constexpr float k_ground_opacity = 0.65F;

}  // namespace penpose::render
