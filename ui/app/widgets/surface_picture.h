#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/triangle_mesh.h"
#include "ui/app/widgets/picture_frame.h"

namespace penpose::app {

/// Draws a posed surface from the front, lit from above the eye, into a square of `px` by `px` pixels, RGBA.
[[nodiscard]] std::vector<std::uint8_t> surface_picture(std::span<const geometry::ModelPoint> positions,
                                                        std::span<const mesh::Triangle> triangles,
                                                        const PictureFrame& frame, int px);

/// The same of a pose, from the model's own front.
[[nodiscard]] std::vector<std::uint8_t> pose_pixels(const document::Model& model, const rig::Pose& pose,
                                                    const PictureFrame& frame, int px);

}  // namespace penpose::app
