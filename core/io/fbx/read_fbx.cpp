#include "core/io/fbx/read_fbx.h"

#include <utility>

#include "core/io/fbx/fbx_animations.h"
#include "core/io/fbx/fbx_meshes.h"
#include "core/io/fbx/fbx_scene.h"
#include "core/io/fbx/fbx_tree.h"
#include "core/io/model/model_formats.h"
#include "core/rig/mirrored_triangles.h"

namespace penpose::io {
namespace {

base::Result<std::shared_ptr<const rig::Skeleton>> skeleton_of(FbxJoints& joints, const FbxMeshes& meshes) {
  if (joints.joints.empty()) return std::shared_ptr<const rig::Skeleton>();
  std::vector<std::uint32_t> first{0};
  std::vector<rig::Influence> all;
  for (const auto& one : meshes.influences) {
    all.insert(all.end(), one.begin(), one.end());
    first.push_back(static_cast<std::uint32_t>(all.size()));
  }
  return rig::Skeleton::make(std::move(joints.joints), std::move(first), std::move(all));
}

}  // namespace

base::Result<document::Model> read_fbx(base::Bytes bytes, const FileResolver&) {
  const auto tree = read_fbx_tree(bytes);
  if (!tree) return tree.error();
  const auto scene = FbxScene::make(*tree);
  if (!scene) return scene.error();
  auto joints = read_fbx_joints(*scene);
  if (!joints) return joints.error();
  std::vector<std::string> notes;
  auto meshes = read_fbx_meshes(*scene, *joints, notes);
  if (!meshes) return meshes.error();
  auto animations = read_fbx_animations(*scene, *joints, meshes->shapes);
  const std::size_t vertices = meshes->source.positions.size();
  auto skeleton = skeleton_of(*joints, *meshes);
  if (!skeleton) return skeleton.error();
  if (*skeleton) rig::turn_mirrored(**skeleton, meshes->source.triangles);
  auto mesh = mesh::TriangleMesh::build(std::move(meshes->source));
  if (!mesh) return mesh.error();
  std::shared_ptr<const rig::BlendShapes> shapes;
  if (!meshes->shapes.empty()) {
    auto made = rig::BlendShapes::make(std::move(meshes->shapes), vertices);
    if (!made) return made.error();
    shapes = std::move(made).value();
  }
  auto model = document::make_model(*mesh, std::move(shapes), std::move(skeleton).value());
  if (!model) return model;
  std::copy(meshes->values.begin(), meshes->values.end(), model->pose.begin());
  model->materials = std::move(meshes->materials);
  model->animations = std::move(animations);
  model->notes = std::move(notes);
  if ((*mesh)->dropped_triangles() > 0)
    model->notes.push_back(std::to_string((*mesh)->dropped_triangles()) + " triangles without area were left out");
  return model;
}

ModelFormat fbx_format() {
  return {.name = "FBX",
          .extension = ".fbx",
          .looks_like = [](base::Bytes bytes) { return is_binary_fbx(bytes) || is_text_fbx(bytes); },
          .read = read_fbx};
}

}  // namespace penpose::io
