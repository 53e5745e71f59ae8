#pragma once

#include <array>
#include <string>
#include <vector>

#include "tests/support/models/bounded_points.h"
#include "tests/support/models/gltf_sample.h"
#include "tests/support/models/sketched_models.h"

namespace penpose::tests {

struct AvatarBone {
  const char* bone;
  int parent;  ///< number in the list; -1: none
  std::array<double, 3> place;
};

/// All bones that VRM 0.x and 1.0 require, eyes and a jaw, and two of hair.
inline const std::vector<AvatarBone>& whole_bones() {
  static const std::vector<AvatarBone> bones{{"hips", -1, {0, 1, 0}},
                                             {"spine", 0, {0, 0.1, 0}},
                                             {"chest", 1, {0, 0.15, 0}},
                                             {"neck", 2, {0, 0.2, 0}},
                                             {"head", 3, {0, 0.1, 0}},
                                             {"leftEye", 4, {0.03, 0.06, 0.05}},
                                             {"rightEye", 4, {-0.03, 0.06, 0.05}},
                                             {"jaw", 4, {0, 0.02, 0.03}},
                                             {"leftUpperLeg", 0, {0.1, -0.05, 0}},
                                             {"leftLowerLeg", 8, {0, -0.4, 0}},
                                             {"leftFoot", 9, {0, -0.4, 0}},
                                             {"rightUpperLeg", 0, {-0.1, -0.05, 0}},
                                             {"rightLowerLeg", 11, {0, -0.4, 0}},
                                             {"rightFoot", 12, {0, -0.4, 0}},
                                             {"leftUpperArm", 2, {0.2, 0.15, 0}},
                                             {"leftLowerArm", 14, {0.25, 0, 0}},
                                             {"leftHand", 15, {0.25, 0, 0}},
                                             {"rightUpperArm", 2, {-0.2, 0.15, 0}},
                                             {"rightLowerArm", 17, {-0.25, 0, 0}},
                                             {"rightHand", 18, {-0.25, 0, 0}},
                                             {"hair", 4, {0, 0.2, -0.1}},
                                             {"hairTip", 20, {0, -0.2, 0}}};
  return bones;
}
inline constexpr std::size_t k_hair_bones = 2;  ///< at the end, no bones of a human figure
inline constexpr std::size_t k_head_bone = 4;

namespace avatar {

using Json = nlohmann::json;

/// What an avatar of VRM 1.0 says. Nodes of bones follow each other from `first`.
inline void add_vrm1(Json& json, std::size_t face, std::size_t first) {
  const auto& bones = whole_bones();
  Json human = Json::object();
  for (std::size_t b = 0; b + k_hair_bones < bones.size(); ++b) human[bones[b].bone] = {{"node", first + b}};
  const Json range = {{"inputMaxValue", 90}, {"outputScale", 10}};
  const Json smile = {{"node", face}, {"index", 0}, {"weight", 0.5}};
  const std::size_t hair = first + bones.size() - k_hair_bones;
  json["extensionsUsed"] = {"VRMC_vrm", "VRMC_springBone"};
  json["extensions"]["VRMC_vrm"] = {
      {"specVersion", "1.0"},
      {"meta", {{"name", "trunk"}, {"authors", {"nobody"}}, {"licenseUrl", "https://vrm.dev/licenses/1.0/"}}},
      {"humanoid", {{"humanBones", human}}},
      {"firstPerson", {{"meshAnnotations", {{{"node", face}, {"type", "auto"}}}}}},
      {"lookAt",
       {{"type", "bone"},
        {"offsetFromHeadBone", {0, 0.06, 0}},
        {"rangeMapHorizontalInner", range},
        {"rangeMapHorizontalOuter", range},
        {"rangeMapVerticalDown", range},
        {"rangeMapVerticalUp", range}}},
      {"expressions",
       {{"preset",
         {{"happy", {{"morphTargetBinds", {smile}}, {"overrideBlink", "block"}}},
          {"aa", {{"morphTargetBinds", {smile}}, {"isBinary", true}}}}},
        {"custom", {{"up", {{"morphTargetBinds", {smile}}}}}}}}};
  json["extensions"]["VRMC_springBone"] = {
      {"specVersion", "1.0"},
      {"colliders",
       {{{"node", first + k_head_bone}, {"shape", {{"sphere", {{"offset", {0, 0, 0}}, {"radius", 0.1}}}}}}}},
      {"colliderGroups", {{{"colliders", {0}}}}},
      {"springs", {{{"joints", {{{"node", hair}}, {{"node", hair + 1}}}}, {"colliderGroups", {0}}}}}};
}

/// The same of VRM 0.x.
inline void add_vrm0(Json& json, std::size_t first) {
  const auto& bones = whole_bones();
  Json human = Json::array();
  for (std::size_t b = 0; b + k_hair_bones < bones.size(); ++b)
    human.push_back({{"bone", bones[b].bone}, {"node", first + b}, {"useDefaultValues", true}});
  const std::size_t hair = first + bones.size() - k_hair_bones;
  json["extensionsUsed"] = {"VRM"};
  json["extensions"]["VRM"] = {
      {"exporterVersion", "tests"},
      {"specVersion", "0.0"},
      {"meta", {{"title", "trunk"}, {"author", "nobody"}, {"allowedUserName", "Everyone"}, {"licenseName", "CC0"}}},
      {"humanoid", {{"humanBones", human}}},
      {"firstPerson",
       {{"firstPersonBone", first + k_head_bone},
        {"meshAnnotations", {{{"mesh", 0}, {"firstPersonFlag", "Auto"}}}},
        {"lookAtTypeName", "Bone"}}},
      {"blendShapeMaster",
       {{"blendShapeGroups",
         {{{"name", "Joy"},
           {"presetName", "joy"},
           {"binds", {{{"mesh", 0}, {"index", 0}, {"weight", 50}}}},
           {"materialValues", Json::array()}}}}}},
      {"secondaryAnimation",
       {{"boneGroups", {{{"bones", {hair}}, {"colliderGroups", {0}}, {"stiffiness", 1}}}},
        {"colliderGroups",
         {{{"node", first + k_head_bone},
           {"colliders", {{{"offset", {{"x", 0}, {"y", 0}, {"z", 0}}}, {"radius", 0.1}}}}}}}}},
      {"materialProperties", {{{"name", "skin"}, {"shader", "VRM_USE_GLTFSHADER"}}}}};
}

}  // namespace avatar

/// The trunk as the face of a whole avatar that follows the rules of its version, 0 or 1; its target is "lift".
inline GltfSample whole_avatar(int version) {
  GltfSample sample;
  const Trunk trunk = make_trunk();
  const std::size_t count = trunk.canvas->positions().size();
  std::vector<float> positions;
  for (const auto& p : trunk.canvas->positions()) {
    for (int axis = 0; axis < 3; ++axis) positions.push_back(static_cast<float>(p[axis]));
  }
  std::vector<std::uint16_t> corners;
  for (const auto& t : trunk.canvas->mesh().triangles()) {
    for (const std::uint32_t v : t) corners.push_back(static_cast<std::uint16_t>(v));
  }
  std::vector<float> lift(3 * count, 0.0F);
  lift[2] = 0.5F;
  std::vector<std::uint8_t> joints(4 * count, 0);
  std::vector<float> weights(4 * count, 0.0F);
  for (std::size_t v = 0; v < count; ++v) {
    joints[4 * v] = k_head_bone;
    weights[4 * v] = 1;
  }
  const auto& bones = whole_bones();
  std::vector<std::array<double, 3>> places;
  std::vector<float> binds;
  nlohmann::json listed = nlohmann::json::array();
  const std::size_t face = sample.add("nodes", {{"name", "face"}, {"mesh", 0}, {"skin", 0}});
  for (std::size_t b = 0; b < bones.size(); ++b) {
    listed.push_back(sample.add("nodes", {{"name", "bone " + std::to_string(b)}, {"translation", bones[b].place}}));
    places.push_back(bones[b].place);
    if (bones[b].parent >= 0) {
      const auto parent = static_cast<std::size_t>(bones[b].parent);
      for (std::size_t axis = 0; axis < 3; ++axis) places[b][axis] += places[parent][axis];
      sample.json["nodes"][face + 1 + parent]["children"].push_back(face + 1 + b);
    }
    std::vector<float> bind{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    for (std::size_t axis = 0; axis < 3; ++axis) bind[12 + axis] = static_cast<float>(-places[b][axis]);
    binds.insert(binds.end(), bind.begin(), bind.end());
  }
  sample.add("meshes", {{"name", "face"},
                        {"primitives",
                         {{{"attributes",
                            {{"POSITION", add_points(sample, positions)},
                             {"JOINTS_0", sample.add_accessor(joints, "VEC4", 4, 5121)},
                             {"WEIGHTS_0", sample.add_accessor(weights, "VEC4", 4, 5126)}}},
                           {"indices", sample.add_corners(corners)},
                           {"material", 0},
                           {"targets", {{{"POSITION", add_points(sample, lift)}}}}}}},
                        {"extras", {{"targetNames", {"lift"}}}}});
  sample.add("materials", {{"name", "skin"}});
  sample.add("skins", {{"joints", listed}, {"inverseBindMatrices", sample.add_accessor(binds, "MAT4", 16, 5126)}});
  sample.add("scenes", {{"nodes", {face, face + 1}}});
  sample.json["scene"] = 0;
  if (version == 0) {
    avatar::add_vrm0(sample.json, face + 1);
  } else {
    avatar::add_vrm1(sample.json, face, face + 1);
  }
  return sample;
}

}  // namespace penpose::tests
