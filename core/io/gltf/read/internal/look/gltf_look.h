#pragma once

#include <memory>

#include "core/document/look.h"
#include "core/io/gltf/read/internal/gltf_document.h"
#include "core/io/gltf/read/internal/gltf_meshes.h"
#include "core/io/model/read_model.h"

namespace penpose::io {

/// Px of the largest picture that is shown: 8192 x 8192.
inline constexpr std::uint64_t k_most_picture_px = std::uint64_t{1} << 26;

/// What the meshes look like: base colours with their pictures (glTF 2.0, sections 3.8 and 3.9; KHR_texture_transform,
/// KHR_materials_unlit, KHR_materials_pbrSpecularGlossiness, EXT_texture_webp; VRM 0.x materialProperties), texture
/// coordinates, vertex colours. Triangles that repeat a vertex are left out, as mesh::TriangleMesh leaves them out.
/// Pictures are copied as they are, not unpacked. Null: there is nothing that document::Material does not say. What
/// cannot be shown (a picture that is missing, cut off, too large or of an unknown kind) is noted, in one line, and is
/// grey; nothing of it is an error. `meshes` is as read_meshes gives it.
[[nodiscard]] std::shared_ptr<const document::Look> read_look(GltfDocument& document, const GltfMeshes& meshes,
                                                              const FileResolver& resolve);

/// The look, if it is one of this mesh; else null and a note: a mesh may have been cut into other vertices.
[[nodiscard]] std::shared_ptr<const document::Look> fitting_look(std::shared_ptr<const document::Look> look,
                                                                 const mesh::TriangleMesh& mesh,
                                                                 std::vector<std::string>& notes);

}  // namespace penpose::io
