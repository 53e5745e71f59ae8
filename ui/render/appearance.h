#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "core/document/model.h"
#include "ui/render/face_parts.h"
#include "ui/render/scene.h"

namespace penpose::render {

/// What may be said in place of what the shapes tell.
struct AppearanceOptions {
  bool recognise = true;  ///< false: every component in its part's material, as the file has it
  std::vector<std::pair<std::uint32_t, PartKind>> kinds;  ///< component number and what it is
};

/// How the model looks: the file's materials, and eyes, covers, lashes, teeth and gums (recognise_face_parts) in
/// colours of their own where the file gives them the body's colour. A part with another colour than the body's keeps
/// it, but its eyeballs get an iris. Metals are drawn half as metallic, because there is no room that they could
/// mirror. Where the model has a look (pictures, colours of vertices, several materials on shared vertices), its
/// triangles are drawn as that has them.
[[nodiscard]] Appearance make_appearance(const document::Model& model, const AppearanceOptions& options = {});

/// Positions and normals of the model at its pose, ready for one scene. For a pose that changes keep a
/// rig::SurfacePoser instead; its revision is a scene's pose number.
struct PosedMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
};
[[nodiscard]] PosedMesh posed_mesh(const document::Model& model);
/// The model as it is posed, with nothing beside it. All three outlive the scene.
[[nodiscard]] Scene scene_of(const document::Model& model, const PosedMesh& posed, const Appearance& appearance);

}  // namespace penpose::render
