#include "core/io/gltf/internal/gltf_source.h"

#include <algorithm>
#include <numeric>

#include "core/io/gltf/internal/animation_hash.h"
#include "core/io/gltf/read/uri/uri.h"

namespace penpose::io {
namespace {

// Pictures beside a model are held as long as it is open.
constexpr std::size_t k_most_pictures = 1024;
constexpr std::uint64_t k_most_bytes = std::uint64_t{1} << 30;

void read_pictures(const GltfDocument& document, ReadBeside& beside) {
  const FileResolver resolve = beside.resolver();
  const json::Json* images = json::find(document.json, "images");
  if (!resolve || images == nullptr || !images->is_array()) return;
  std::uint64_t held = 0;
  for (std::size_t i = 0; i < std::min(images->size(), k_most_pictures) && held < k_most_bytes; ++i) {
    const json::Json* uri = json::find((*images)[i], "uri");
    const auto path = uri != nullptr && uri->is_string() ? path_of_uri(uri->get<std::string>()) : std::nullopt;
    if (!path || beside.files().contains(*path)) continue;
    const auto bytes = resolve(*path);
    if (bytes) held += bytes->size();
  }
}

}  // namespace

GltfOrigins origins_of(const GltfMeshes& meshes, const GltfShapes& shapes) {
  GltfOrigins origins;
  for (std::size_t i = 0; i < meshes.origins.size(); ++i) {
    const PartOrigin& from = meshes.origins[i];
    document::SourceFile::Part& part = origins.parts.emplace_back();
    part = {from.node, from.mesh, from.primitives, {}};
    for (const std::size_t shape : shapes.of_target[i]) part.targets.push_back(shapes.shapes[shape].parameter.name);
  }
  return origins;
}

void put_in_order(const RootExtras& root, std::vector<document::Animation>& animations,
                  std::vector<std::size_t>& from) {
  if (root.animation_order.empty()) return;
  std::map<std::size_t, std::size_t> rank;
  for (const std::size_t index : root.animation_order) rank.emplace(index, rank.size());
  const auto rank_of = [&](std::size_t i) {
    const auto found = rank.find(from[i]);
    return found == rank.end() ? rank.size() : found->second;
  };
  std::vector<std::size_t> order(animations.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank_of(a) < rank_of(b); });
  std::vector<document::Animation> sorted;
  std::vector<std::size_t> sorted_from;
  for (const std::size_t i : order) {
    sorted.push_back(std::move(animations[i]));
    sorted_from.push_back(from[i]);
  }
  animations = std::move(sorted);
  from = std::move(sorted_from);
}

FileResolver ReadBeside::resolver() {
  if (!resolve_) return {};
  return [this](const std::string& path) -> base::Result<std::vector<std::uint8_t>> {
    const auto found = files_.find(path);
    if (found != files_.end()) return found->second;
    auto bytes = resolve_(path);
    if (bytes) files_.emplace(path, *bytes);
    return bytes;
  };
}

std::shared_ptr<const document::SourceFile> keep_source(ReadBeside& beside, const GltfDocument& document,
                                                        GltfOrigins origins, const document::Model& model) {
  read_pictures(document, beside);
  auto source = std::make_shared<document::SourceFile>();
  source->bytes = document.file;
  source->files = std::move(beside.files());
  source->parts = std::move(origins.parts);
  if (model.skeleton) source->nodes.resize(model.skeleton->joints().size());
  for (std::size_t n = 0; n < origins.joint_of_node.size(); ++n) {
    const std::int32_t joint = origins.joint_of_node[n];
    if (joint >= 0) source->nodes[static_cast<std::size_t>(joint)] = n;
  }
  const std::size_t weights = document::weight_count(model);
  for (std::size_t p = 0; p < model.pose.size(); ++p) {
    const std::string& name = model.rig->parameters()[p].name;
    source->pose.emplace(name, model.pose[p]);
    if (p < weights) source->weights.push_back(name);
  }
  for (std::size_t a = 0; a < model.animations.size(); ++a) {
    source->animations.push_back(
        {origins.animations[a], model.animations[a].name, hash_animation(model.animations[a], source->weights)});
  }
  source->mesh = model.mesh;
  source->shapes = model.shapes;
  source->skeleton = model.skeleton;
  source->deformers = model.deformers;
  source->corrections = model.corrections;
  return source;
}

}  // namespace penpose::io
