#include <algorithm>
#include <optional>

#include "core/geometry/rotation.h"
#include "core/io/gltf/internal/gltf_extras.h"
#include "core/io/gltf/read/internal/gltf_document.h"
#include "core/io/gltf/write/glb_targets.h"
#include "core/io/gltf/write/internal/glb_animations.h"
#include "core/io/gltf/write/internal/glb_skin.h"
#include "core/io/gltf/write/internal/glb_weights.h"
#include "core/io/gltf/write/internal/gltf_builder.h"
#include "core/io/gltf/write/lost_content.h"
#include "core/io/gltf/write/patch_gltf.h"
#include "core/io/gltf/write/shape_entries.h"
#include "core/io/model/write_model.h"
#include "core/io/project/internal/project_json.h"
#include "core/io/project/write_document.h"
#include "core/io/surface/normals.h"
#include "core/rig/mirrored_triangles.h"

namespace penpose::io {
namespace {

constexpr std::size_t k_none = static_cast<std::size_t>(-1);

class GlbWriter {
 public:
  GlbWriter(const document::Model& model, const WriteOptions& options, json::Json project)
      : model_(model),
        project_(std::move(project)),
        morphs_(model, options.bake_tolerance),
        weights_(model, morphs_),
        skin_(model) {}

  base::Result<std::vector<std::uint8_t>> write() {
    builder_.root["asset"] = {{"version", "2.0"}, {"generator", "penpose"}};
    builder_.root["extras"] = write_root_extras(model_, morphs_.baked_names(), weights_.one_way_names(), project_);
    skin_.write_joints(out_);
    skin_.write_skin(builder_, out_);
    compute_normals();
    for (std::size_t i = 0; i < model_.mesh->parts().size(); ++i) write_part(i);
    // The parts have set meshes and children on the nodes.
    for (json::Json& node : out_.nodes) builder_.add("nodes", std::move(node));
    builder_.root["scenes"] = json::Json::array({{{"nodes", out_.scene}}});
    builder_.root["scene"] = 0;
    write_animations();
    const double size = morphs_.size();
    report = {weights_.targets().size(),
              morphs_.all().size() - morphs_.own_count(),
              morphs_.bake_error() + (size > 0 ? between_error_ / size : 0.0),
              {}};
    return builder_.finish();
  }

  WriteReport report;

 private:
  [[nodiscard]] std::span<const rig::Joint> joints() const {
    return model_.skeleton ? model_.skeleton->joints() : std::span<const rig::Joint>();
  }

  void compute_normals() {
    const mesh::TriangleMesh& mesh = *model_.mesh;
    normals_.assign(mesh.file_normals().begin(), mesh.file_normals().end());
    const bool missing = normals_.empty();
    triangles_.assign(mesh.triangles().begin(), mesh.triangles().end());
    if (model_.skeleton) rig::turn_mirrored(*model_.skeleton, triangles_);
    if (missing) normals_ = smooth_normals(mesh.positions(), triangles_, mesh.smoothing());
    for (glm::vec3& n : normals_) n = glm::vec3(geometry::normalized(geometry::ModelVector(n)));
  }

  void write_part(std::size_t index) {
    const mesh::Part& part = model_.mesh->parts()[index];
    shapes_of_part_.emplace_back();
    node_of_part_.push_back(k_none);
    if (part.vertex_count == 0) return;
    json::Json attributes = {
        {"POSITION",
         builder_.add_floats(flatten(model_.mesh->positions().subspan(part.first_vertex, part.vertex_count)), "VEC3",
                             BufferUse::vertices, true)},
        {"NORMAL", builder_.add_floats(
                       flatten(std::span<const glm::vec3>(normals_).subspan(part.first_vertex, part.vertex_count)),
                       "VEC3", BufferUse::vertices, false)}};
    if (skin_.binding(index) == Binding::skinned) skin_.write_weights(part, builder_, attributes);
    std::vector<std::uint32_t> corners;
    for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
      for (const std::uint32_t v : triangles_[t]) corners.push_back(v - part.first_vertex);
    }
    // A mesh without triangles cannot be said in glTF; a triangle without area is dropped again when it is read.
    if (corners.empty()) corners.assign(3, 0);
    json::Json primitive = {
        {"attributes", std::move(attributes)}, {"indices", builder_.add_indices(corners)}, {"mode", 4}};
    if (index < model_.materials.size()) primitive["material"] = material(model_.materials[index]);
    json::Json mesh = json::Json::object();
    if (!part.name.empty()) mesh["name"] = part.name;
    write_targets(index, primitive, mesh);
    mesh["primitives"] = json::Json::array({std::move(primitive)});
    place_mesh(index, builder_.add("meshes", std::move(mesh)));
  }

  /// The node that shows the mesh of a part: of its own, or the joint that carries it.
  void place_mesh(std::size_t index, std::size_t mesh) {
    const mesh::Part& part = model_.mesh->parts()[index];
    json::Json node = {{"mesh", mesh}};
    if (!part.name.empty()) node["name"] = part.name;
    if (skin_.binding(index) != Binding::rigid) {
      if (skin_.binding(index) == Binding::skinned) node["skin"] = 0;
      out_.scene.push_back(out_.nodes.size());
    } else {
      const std::size_t joint = model_.skeleton->influences_of(part.first_vertex)[0].joint;
      if (!out_.nodes[joint].contains("mesh")) {
        out_.nodes[joint]["mesh"] = mesh;
        node_of_part_[index] = joint;
        return;
      }
      node["extras"] = {{k_extras_key, {{"carried_by_parent", true}}}};
      out_.nodes[joint]["children"].push_back(out_.nodes.size());
    }
    node_of_part_[index] = out_.nodes.size();
    out_.nodes.push_back(std::move(node));
  }

  void write_targets(std::size_t index, json::Json& primitive, json::Json& mesh) {
    const mesh::Part& part = model_.mesh->parts()[index];
    bool normals = false;
    for (std::size_t s = 0; s < weights_.targets().size(); ++s) {
      const rig::BlendShape& shape = *weights_.targets()[s];
      const auto [first, last] = entries_in(shape, part);
      // A shape that moves nothing is kept by the first part.
      if (first == last && !(index == 0 && shape.vertices.empty())) continue;
      shapes_of_part_[index].push_back(s);
      for (std::size_t i = first; i < last && !shape.normal_deltas.empty(); ++i) {
        normals = normals || shape.normal_deltas[i] != glm::vec3(0);
      }
    }
    if (shapes_of_part_[index].empty()) return;
    json::Json names = json::Json::array();
    json::Json weights = json::Json::array();
    for (const std::size_t s : shapes_of_part_[index]) {
      const rig::BlendShape& shape = *weights_.targets()[s];
      const auto [first, last] = entries_in(shape, part);
      std::vector<std::uint32_t> elements;
      for (std::size_t i = first; i < last; ++i) elements.push_back(shape.vertices[i] - part.first_vertex);
      const auto deltas = std::span(shape.deltas).subspan(first, last - first);
      const auto is_zero = [](const glm::vec3& v) { return v == glm::vec3(0); };
      const bool keep_zeros = std::any_of(deltas.begin(), deltas.end(), is_zero);
      json::Json target = {
          {"POSITION", builder_.add_displacements(part.vertex_count, elements, flatten(deltas), keep_zeros, true)}};
      if (normals) {
        std::vector<glm::vec3> none(shape.normal_deltas.empty() ? elements.size() : 0, glm::vec3(0));
        const auto own = shape.normal_deltas.empty() ? std::span<const glm::vec3>(none)
                                                     : std::span(shape.normal_deltas).subspan(first, last - first);
        target["NORMAL"] = builder_.add_displacements(part.vertex_count, elements, flatten(own), keep_zeros, false);
      }
      primitive["targets"].push_back(std::move(target));
      names.push_back(shape.parameter.name);
      weights.push_back(weights_.posed(s));
    }
    mesh["weights"] = std::move(weights);
    mesh["extras"] = {{"targetNames", std::move(names)}};
  }

  std::size_t material(const document::Material& material) {
    json::Json object = {{"pbrMetallicRoughness",
                          {{"baseColorFactor", material.base_color},
                           {"metallicFactor", material.metallic},
                           {"roughnessFactor", material.roughness}}}};
    if (!material.name.empty()) object["name"] = material.name;
    if (material.base_color[3] < 1.0) object["alphaMode"] = "BLEND";
    json::Json& all = builder_.root["materials"];
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i] == object) return i;
    }
    return builder_.add("materials", std::move(object));
  }

  void write_animations() {
    std::vector<WeightNode> weight_nodes;
    for (std::size_t i = 0; i < shapes_of_part_.size(); ++i) {
      if (!shapes_of_part_[i].empty()) weight_nodes.push_back({node_of_part_[i], shapes_of_part_[i]});
    }
    const auto node_of_joint = [&](std::size_t joint) {
      return joint < joints().size() ? std::optional(joint) : std::nullopt;
    };
    GlbAnimations writer(weights_, weight_nodes, node_of_joint, builder_);
    for (const document::Animation& animation : model_.animations) {
      json::Json channels = json::Json::array();
      json::Json samplers = json::Json::array();
      writer.write(animation, channels, samplers);
      if (channels.empty()) continue;
      json::Json object = {{"channels", std::move(channels)}, {"samplers", std::move(samplers)}};
      if (!animation.name.empty()) object["name"] = animation.name;
      const double fps = GlbAnimations::rate_of(animation);
      if (fps > 0) object["extras"] = {{k_extras_key, {{"fps", fps}}}};
      builder_.add("animations", std::move(object));
    }
    between_error_ = writer.between_error();
  }

  const document::Model& model_;
  json::Json project_;  ///< null: the file is a model and no project
  GlbTargets morphs_;
  GlbWeights weights_;
  GlbSkin skin_;
  GltfBuilder builder_;
  GlbNodes out_;
  std::vector<glm::vec3> normals_;
  std::vector<mesh::Triangle> triangles_;  ///< as the file has them, before what carries them mirrors them
  std::vector<std::vector<std::size_t>> shapes_of_part_;
  std::vector<std::size_t> node_of_part_;
  double between_error_ = 0;  ///< of keys, model units
};

/// A .glb file as text, with its buffer beside it.
base::Result<std::vector<std::uint8_t>> as_text_file(const std::vector<std::uint8_t>& glb, const WriteOptions& options,
                                                     WriteReport& report) {
  auto opened = open_gltf(glb, {});
  if (!opened) return opened.error();
  if (!opened->buffers.empty()) {
    const std::string name = (options.stem.empty() ? "model" : options.stem) + ".bin";
    opened->json["buffers"][0]["uri"] = name;
    report.files[name].assign(opened->buffers[0].begin(), opened->buffers[0].end());
  }
  auto text = text_of(opened->json, TextOrder::as_made);
  if (!text) return text.error();
  return std::vector<std::uint8_t>(text->begin(), text->end());
}

base::Result<std::vector<std::uint8_t>> write(const document::Model& model, const WriteOptions& options,
                                              const json::Json& project, GltfContainer container, WriteReport* wanted) {
  WriteReport ignored;
  WriteReport& report = wanted == nullptr ? ignored : *wanted;
  std::string why;
  if (model.source && !options.bare) {
    auto patched = patch_gltf(model, options, project, container);
    if (!patched) return patched.error();
    if (patched->cannot.empty()) {
      report = std::move(patched->report);
      return std::move(patched->bytes);
    }
    why = patched->cannot;
  }
  GlbWriter writer(model, options, project);
  auto bytes = writer.write();
  report = std::move(writer.report);
  const std::string lost = model.source ? lost_without_source(model) : "";
  if (!lost.empty()) report.notes.push_back(lost + " were left out" + (why.empty() ? "" : ": " + why));
  if (!bytes || container == GltfContainer::binary) return bytes;
  return as_text_file(*bytes, options, report);
}

}  // namespace

base::Result<std::vector<std::uint8_t>> write_glb(const document::Model& model, const WriteOptions& options,
                                                  WriteReport* report) {
  return write(model, options, nullptr, GltfContainer::binary, report);
}

base::Result<std::vector<std::uint8_t>> write_gltf(const document::Model& model, const WriteOptions& options,
                                                   WriteReport* report) {
  return write(model, options, nullptr, GltfContainer::text, report);
}

base::Result<std::vector<std::uint8_t>> write_project(const document::Document& document, const WriteOptions& options,
                                                      WriteReport* report) {
  return write(document::model_of(document), options, project_to_json(document), GltfContainer::binary, report);
}

base::Result<std::vector<std::uint8_t>> write_gltf_project(const document::Document& document,
                                                           const WriteOptions& options, WriteReport* report) {
  return write(document::model_of(document), options, project_to_json(document), GltfContainer::text, report);
}

}  // namespace penpose::io
