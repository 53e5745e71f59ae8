#include "core/io/fbx/fbx_notes.h"

namespace penpose::io {

void add_fbx_notes(const FbxScene& scene, std::vector<std::string>& notes) {
  std::size_t dual = 0;
  std::size_t caches = 0;
  std::size_t constraints = 0;
  std::size_t others = 0;
  std::size_t subdivided = 0;
  std::size_t old_shapes = 0;
  for (const FbxObject& object : scene.objects()) {
    if (object.kind == "Deformer" && object.use == "Skin") {
      const FbxRecord* type = object.record->find("SkinningType");
      dual += type != nullptr && (type->text(0) == "DualQuaternion" || type->text(0) == "Blend") ? 1U : 0U;
    }
    caches += object.kind == "Deformer" && object.use == "VertexCacheDeformer" ? 1U : 0U;
    constraints += object.kind == "Constraint" && object.use != "Character" ? 1U : 0U;
    if (object.kind != "Geometry") continue;
    const FbxRecord* smooth = object.record->find("Smoothness");
    const bool mesh = object.use == "Mesh";
    others += !mesh && object.use != "Shape" && object.use != "Line" ? 1U : 0U;
    subdivided += mesh && smooth != nullptr && smooth->whole(0) > 0 ? 1U : 0U;
    old_shapes += mesh && object.record->find("Shape") != nullptr ? 1U : 0U;
  }
  const auto add = [&](std::size_t count, const char* what) {
    if (count > 0) notes.push_back(std::to_string(count) + what);
  };
  add(dual, " skins of dual quaternions bend as linear ones do: around joints that twist, vertices lie elsewhere");
  add(caches, " meshes move by files of vertices (geometry caches), which are not read: they stand still");
  add(constraints, " constraints are left out: what they move has the keys that were baked, if any");
  add(others, " surfaces or curves that are no meshes are left out: make polygons of them and export again");
  add(subdivided, " meshes are subdivided where they were made, and are shown without that");
  add(old_shapes, " meshes keep their shapes in the way of FBX 7.1, which is not read: export as FBX 7.4 or later");
}

}  // namespace penpose::io
