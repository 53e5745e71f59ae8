#pragma once

#include <array>
#include <string>
#include <vector>

#include "tests/support/models/gltf_sample.h"

namespace penpose::tests {

/// A node of a figure: its bone, its place in its parent and its rotation at rest.
struct FigureBone {
  const char* bone;
  int parent;  ///< number in the list; -1: below the node "armature"
  std::array<double, 3> place;
  std::array<double, 4> rotation;
};

/// Half turns and the like, so that a rest pose of one figure is not that of another.
inline const std::vector<FigureBone>& upright_bones() {
  static const std::vector<FigureBone> bones{{"hips", -1, {0, 1, 0}, {0, 0, 0, 1}},
                                             {"spine", 0, {0, 0.2, 0}, {0, 0, 0, 1}},
                                             {"head", 1, {0, 0.4, 0}, {0, 0, 0, 1}},
                                             {"leftUpperArm", 1, {0.2, 0.3, 0}, {0, 0, 0, 1}}};
  return bones;
}
inline const std::vector<FigureBone>& turned_bones() {
  static const std::vector<FigureBone> bones{{"hips", -1, {0, 2, 0}, {0.5, 0.5, 0.5, 0.5}},
                                             {"spine", 0, {0.1, 0, 0.4}, {0, 0.6, 0, 0.8}},
                                             {"head", 1, {0, 0.8, 0}, {0, 0, -0.8, 0.6}},
                                             {"leftUpperArm", 1, {0.4, 0.6, 0}, {0.28, 0, 0, 0.96}}};
  return bones;
}

/// Adds the nodes of a figure below a node "armature" that is turned and half as large again; returns the first one's
/// number.
inline std::size_t add_figure(GltfSample& sample, const std::vector<FigureBone>& bones) {
  const std::size_t armature =
      sample.add("nodes", {{"name", "armature"}, {"rotation", {0, 0.6, 0, 0.8}}, {"scale", {1.5, 1.5, 1.5}}});
  for (const FigureBone& bone : bones) {
    // Names that say nothing: the extension tells the bones.
    const std::size_t node = sample.add("nodes", {{"name", "joint " + std::to_string(sample.json["nodes"].size())},
                                                  {"translation", bone.place},
                                                  {"rotation", bone.rotation}});
    const std::size_t parent = bone.parent < 0 ? armature : armature + 1 + static_cast<std::size_t>(bone.parent);
    sample.json["nodes"][parent]["children"].push_back(node);
  }
  return armature + 1;
}

inline nlohmann::json human_bones(const std::vector<FigureBone>& bones, std::size_t first) {
  nlohmann::json listed = nlohmann::json::object();
  for (std::size_t i = 0; i < bones.size(); ++i) listed[bones[i].bone] = {{"node", first + i}};
  return listed;
}

/// The square with the target "lift" as a VRM 1.0 avatar whose skin is a figure; the expression "happy" is a half of
/// the target.
inline GltfSample avatar_sample(const std::vector<FigureBone>& bones) {
  GltfSample sample = morph_sample();
  const std::size_t first = add_figure(sample, bones);
  nlohmann::json joints = nlohmann::json::array();
  for (std::size_t i = 0; i < bones.size(); ++i) joints.push_back(first + i);
  auto& attributes = sample.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] =
      sample.add_accessor(std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0}, "VEC4", 4, 5121);
  attributes["WEIGHTS_0"] =
      sample.add_accessor(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 4, 5126);
  sample.add("skins", {{"joints", joints}});
  sample.json["nodes"][0]["skin"] = 0;
  sample.json["scenes"][0]["nodes"] = {0, first - 1};
  sample.json["extensionsUsed"] = {"VRMC_vrm"};
  sample.json["extensions"]["VRMC_vrm"] = {
      {"specVersion", "1.0"},
      {"humanoid", {{"humanBones", human_bones(bones, first)}}},
      {"expressions",
       {{"preset", {{"happy", {{"morphTargetBinds", {{{"node", 0}, {"index", 0}, {"weight", 0.5}}}}}}}}}}};
  return sample;
}

/// A VRM animation of two keys, at 0 and 1 s: every bone turns, the hips move, "happy" goes from 0 to 1.
inline GltfSample motion_sample(const std::vector<FigureBone>& bones) {
  GltfSample sample;
  const std::size_t first = add_figure(sample, bones);
  const std::size_t happy = sample.add("nodes", {{"name", "happy"}});
  sample.add("scenes", {{"nodes", {first - 1, happy}}});
  const std::size_t times = sample.add_accessor(std::vector<float>{0, 1}, "SCALAR", 1, 5126);
  sample.json["accessors"][times]["min"] = {0};
  sample.json["accessors"][times]["max"] = {1};
  nlohmann::json samplers = nlohmann::json::array();
  nlohmann::json channels = nlohmann::json::array();
  const auto add = [&](std::size_t node, const char* path, std::size_t output) {
    samplers.push_back({{"input", times}, {"output", output}});
    channels.push_back({{"sampler", samplers.size() - 1}, {"target", {{"node", node}, {"path", path}}}});
  };
  for (std::size_t i = 0; i < bones.size(); ++i) {
    const auto& r = bones[i].rotation;
    const float sign = i % 2 == 0 ? 1.0F : -1.0F;
    std::vector<float> keys(r.begin(), r.end());
    const std::vector<float> turned{sign * 0.36F, 0.48F, sign * 0.0F, 0.8F};
    keys.insert(keys.end(), turned.begin(), turned.end());
    add(first + i, "rotation", sample.add_accessor(keys, "VEC4", 4, 5126));
  }
  const auto& p = bones[0].place;
  const std::vector<float> shifts{
      static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]), 0.3F, 0.5F, -0.2F};
  add(first, "translation", sample.add_vec3(shifts));
  add(happy, "translation", sample.add_vec3({0, 0, 0, 1, 0, 0}));
  sample.json["animations"] = {{{"channels", channels}, {"samplers", samplers}}};
  sample.json["extensionsUsed"] = {"VRMC_vrm_animation"};
  sample.json["extensions"]["VRMC_vrm_animation"] = {{"specVersion", "1.0"},
                                                     {"humanoid", {{"humanBones", human_bones(bones, first)}}},
                                                     {"expressions", {{"preset", {{"happy", {{"node", happy}}}}}}}};
  return sample;
}

}  // namespace penpose::tests
