#include "core/io/fbx/read_fbx.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/io/fbx/fbx_meshes.h"
#include "core/io/fbx/fbx_notes.h"
#include "core/io/fbx/fbx_scene.h"
#include "core/io/fbx/motion/fbx_animations.h"
#include "core/io/fbx/tree/fbx_tree.h"
#include "core/io/fbx/write/write_fbx.h"
#include "core/io/model/model_formats.h"
#include "core/rig/mirrored_triangles.h"

namespace penpose::io {
namespace {

/// The reader unfolds at most this many numbers plus 2.5 for each byte of the file, as the glTF reader does.
constexpr std::size_t k_least_numbers = 2'400'000;

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

std::set<std::int64_t> scaled_by_keys(const FbxScene& scene, const FbxTakes& takes) {
  std::set<std::int64_t> out;
  for (const auto& [name, take] : takes) {
    for (const std::int64_t id : take.objects()) {
      const FbxObject* object = scene.object(id);
      if (object != nullptr && object->kind == "Model" &&
          take.moves(id, "Lcl Scaling", FbxNodeTransform(*object).still().scaling))
        out.insert(id);
    }
  }
  return out;
}

/// Shapes take the values that the file and its keys give them, beyond 0 to 1 as well.
void widen_ranges(const std::vector<document::Animation>& animations, FbxMeshes& meshes) {
  const auto take = [&](std::size_t shape, double value) {
    rig::Parameter& parameter = meshes.shapes[shape].parameter;
    parameter.minimum = std::min(parameter.minimum, value);
    parameter.maximum = std::max(parameter.maximum, value);
  };
  for (std::size_t i = 0; i < meshes.values.size(); ++i) take(i, meshes.values[i]);
  for (const document::Animation& animation : animations) {
    for (const document::Channel& channel : animation.channels) {
      if (channel.target != document::ChannelTarget::weights) continue;
      for (std::size_t i = 0; i < channel.values.size(); ++i) take(i % meshes.shapes.size(), channel.values[i]);
    }
  }
}

}  // namespace

base::Result<document::Model> read_fbx(base::Bytes bytes, const FileResolver&) {
  const auto tree = read_fbx_tree(bytes);
  if (!tree) return tree.error();
  const auto scene = FbxScene::make(*tree);
  if (!scene) return scene.error();
  std::vector<std::string> notes;
  const FbxTakes takes = fbx_takes(*scene);
  FbxPlaces places(*scene, scaled_by_keys(*scene, takes));
  auto joints = read_fbx_joints(*scene, places, takes);
  if (!joints) return joints.error();
  auto meshes = read_fbx_meshes(*scene, places, *joints, notes);
  if (!meshes) return meshes.error();
  auto animations =
      read_fbx_animations(*scene, takes, places, *joints, *meshes, k_least_numbers + bytes.size() / 2 * 5, notes);
  widen_ranges(animations, *meshes);
  add_fbx_notes(*scene, notes);
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
          .read = read_fbx,
          .write = write_fbx,
          .holds = "Meshes, shapes, joints, animations",
          .detail = "For engines and other programs; pictures lie beside it"};
}

}  // namespace penpose::io
