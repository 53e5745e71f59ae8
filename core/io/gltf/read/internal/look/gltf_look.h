#pragma once

#include <memory>

#include "core/document/look.h"
#include "core/io/gltf/read/internal/gltf_document.h"
#include "core/io/gltf/read/internal/gltf_meshes.h"
#include "core/io/model/read_model.h"

namespace penpose::io {

/// What the meshes look like: surfaces with their pictures (gltf_surfaces.h), texture coordinates, vertex colours.
/// Triangles that repeat a vertex are left out, as mesh::TriangleMesh leaves them out. Null: there is nothing that
/// document::Material does not say. What cannot be drawn (a picture that is missing, cut off, too large or of an
/// unknown kind) is in Look::undrawn and, in one line, in the notes, and is grey; nothing of it is an error.
/// `meshes` is as read_meshes gives it.
[[nodiscard]] std::shared_ptr<const document::Look> read_look(GltfDocument& document, const GltfMeshes& meshes,
                                                              const FileResolver& resolve);

/// The look, if it is one of this mesh; else null and a note: a mesh may have been cut into other vertices.
[[nodiscard]] std::shared_ptr<const document::Look> fitting_look(std::shared_ptr<const document::Look> look,
                                                                 const mesh::TriangleMesh& mesh,
                                                                 std::vector<std::string>& notes);

}  // namespace penpose::io
