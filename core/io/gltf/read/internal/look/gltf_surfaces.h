#pragma once

#include <cstddef>

#include "core/document/look.h"
#include "core/io/gltf/read/internal/gltf_document.h"
#include "core/io/gltf/read/internal/look/gltf_pictures.h"

namespace penpose::io {

/// The surface of a material of the file: base colour with its picture, alpha, sides, unlit (glTF 2.0, section 3.9;
/// KHR_texture_transform, KHR_materials_unlit, KHR_materials_pbrSpecularGlossiness, EXT_texture_webp; VRM 0.x
/// materialProperties, VRMC_materials_mtoon). Where its picture cannot be drawn it is grey.
[[nodiscard]] document::Surface read_surface(const GltfDocument& document, std::size_t material,
                                             GltfPictures& pictures);

}  // namespace penpose::io
