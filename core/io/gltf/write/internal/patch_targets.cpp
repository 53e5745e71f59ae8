#include "core/io/gltf/write/internal/patch_targets.h"

#include <algorithm>
#include <set>

#include "core/geometry/rotation.h"
#include "core/io/gltf/read/internal/gltf_accessor.h"
#include "core/io/surface/normals.h"

namespace penpose::io {
namespace {

std::vector<float> flatten(std::span<const glm::vec3> vectors) {
  std::vector<float> numbers;
  numbers.reserve(vectors.size() * 3);
  for (const glm::vec3& v : vectors) {
    for (int axis = 0; axis < 3; ++axis) numbers.push_back(v[axis]);
  }
  return numbers;
}

}  // namespace

std::pair<std::size_t, std::size_t> entries_in(const rig::BlendShape& shape, const mesh::Part& part) {
  const auto begin = shape.vertices.begin();
  const auto first = std::lower_bound(begin, shape.vertices.end(), part.first_vertex);
  const auto last = std::lower_bound(first, shape.vertices.end(), part.first_vertex + part.vertex_count);
  return {static_cast<std::size_t>(first - begin), static_cast<std::size_t>(last - begin)};
}

bool MeshTargets::same_columns() const {
  if (columns.size() != old_count) return false;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (columns[c].old != c) return false;
  }
  return true;
}

bool MeshTargets::same() const {
  return same_columns() && std::none_of(columns.begin(), columns.end(), [](const auto& one) { return one.fresh; });
}

PatchTargets::PatchTargets(const document::Model& model, const GlbTargets& morphs, GltfDocument& document,
                           const RootExtras& root)
    : model_(model), source_(*model.source), morphs_(morphs), document_(document), root_(root) {
  for (std::size_t t = 0; t < morphs.all().size(); ++t) wanted_.emplace(morphs.all()[t]->parameter.name, t);
  for (std::size_t s = 0; source_.shapes && s < source_.shapes->shapes().size(); ++s) {
    source_shapes_.emplace(source_.shapes->shapes()[s].parameter.name, s);
  }
  for (const OneWayName& one : root_.one_way) helpers_.emplace(one.target, &one);
  for (std::size_t d = 0; d < root_.baked.size() && d < root_.deformers.size(); ++d) {
    for (const std::string& name : root_.baked[d]) owners_.emplace(name, root_.deformers[d].name);
  }
  for (const OneWayName& one : root_.one_way) owners_.emplace(one.target, one.name);
  reshaped_.assign(document::weight_count(model), false);
  find_meshes();
  for (MeshTargets& mesh : meshes_) match(mesh);
  // Targets that baking makes now and did not make then.
  const auto& baked = morphs.baked_names();
  for (std::size_t d = 0; d < baked.size(); ++d) {
    const std::string& control = model.deformers->deformers()[d]->sketch().name;
    if (!source_.pose.contains(control)) continue;
    for (const std::string& name : baked[d]) {
      if (!owners_.contains(name)) mark_reshaped(control);
    }
  }
}

/// The control that a target belongs to moves otherwise than in the file.
void PatchTargets::mark_reshaped(const std::string& target) {
  const auto owner = owners_.find(target);
  const auto wanted = wanted_.find(owner == owners_.end() ? target : owner->second);
  if (wanted != wanted_.end() && wanted->second < reshaped_.size()) reshaped_[wanted->second] = true;
}

void PatchTargets::find_meshes() {
  for (std::size_t p = 0; p < source_.parts.size(); ++p) {
    const document::SourceFile::Part& part = source_.parts[p];
    auto found =
        std::find_if(meshes_.begin(), meshes_.end(), [&](const MeshTargets& one) { return one.mesh == part.mesh; });
    if (found == meshes_.end()) {
      meshes_.push_back({part.mesh, {}, {}, part.targets.size(), {}});
      found = meshes_.end() - 1;
    }
    found->parts.push_back(p);
    if (std::find(found->nodes.begin(), found->nodes.end(), part.node) == found->nodes.end()) {
      found->nodes.push_back(part.node);
    }
  }
}

bool PatchTargets::is_same_shape(const rig::BlendShape& shape) const {
  const auto found = source_shapes_.find(shape.parameter.name);
  if (found == source_shapes_.end()) return false;
  if (model_.shapes == source_.shapes) return true;
  const rig::BlendShape& was = source_.shapes->shapes()[found->second];
  return was.vertices == shape.vertices && was.deltas == shape.deltas && was.normal_deltas == shape.normal_deltas;
}

bool PatchTargets::is_posed(std::size_t weight) const {
  const auto found = source_.pose.find(morphs_.all()[weight]->parameter.name);
  return found == source_.pose.end() || found->second != model_.pose[weight];
}

/// Whether a target of the file moves the vertices of its mesh as a shape of the model does.
bool PatchTargets::says_the_same(const MeshTargets& mesh, std::size_t column, const rig::BlendShape& shape) {
  for (const std::size_t p : mesh.parts) {
    const document::SourceFile::Part& from = source_.parts[p];
    const mesh::Part& part = model_.mesh->parts()[p];
    const auto& target = document_.model.meshes[from.mesh].primitives[from.primitives.front()].targets[column];
    const auto position = target.find("POSITION");
    std::vector<float> has(std::size_t{3} * part.vertex_count, 0.0F);
    if (position != target.end()) {
      const auto elements = read_elements(document_, position->second, {.count = part.vertex_count});
      if (!elements) return false;
      has = elements->dense();
    }
    const auto [first, last] = entries_in(shape, part);
    std::vector<float> wanted(has.size(), 0.0F);
    for (std::size_t i = first; i < last; ++i) {
      const std::size_t v = shape.vertices[i] - part.first_vertex;
      for (int axis = 0; axis < 3; ++axis) wanted[3 * v + static_cast<std::size_t>(axis)] = shape.deltas[i][axis];
    }
    if (has != wanted) return false;
  }
  return true;
}

void PatchTargets::match(MeshTargets& mesh) {
  const std::vector<std::string>& names = source_.parts[mesh.parts.front()].targets;
  std::set<std::string> shapes_there;
  for (std::size_t c = 0; c < names.size(); ++c) {
    TargetColumn column{names[c], c, k_no_target, false};
    const auto wanted = wanted_.find(names[c]);
    if (wanted != wanted_.end()) {
      const rig::BlendShape& shape = *morphs_.all()[wanted->second];
      column.target = wanted->second;
      column.fresh = source_shapes_.contains(names[c]) ? !is_same_shape(shape) : !says_the_same(mesh, c, shape);
      if (column.fresh) mark_reshaped(names[c]);
    } else if (const auto helper = helpers_.find(names[c]); helper != helpers_.end()) {
      const auto base = wanted_.find(helper->second->name);
      const bool stays = base != wanted_.end() &&
                         (source_shapes_.contains(helper->second->name)
                              ? is_same_shape(*morphs_.all()[base->second])
                              : std::none_of(mesh.columns.begin(), mesh.columns.end(), [&](const TargetColumn& one) {
                                  return one.name == helper->second->name && one.fresh;
                                }));
      if (!stays) {
        mark_reshaped(names[c]);
        continue;
      }
    } else if (mesh.nodes.size() > 1 || source_.parts[mesh.parts.front()].targets.empty()) {
      // Instances name targets that have no name after themselves; they stay as they are.
    } else {
      mark_reshaped(names[c]);
      continue;
    }
    mesh.columns.push_back(std::move(column));
  }
}

bool PatchTargets::moves(const MeshTargets& mesh, const rig::BlendShape& shape) const {
  return std::any_of(mesh.parts.begin(), mesh.parts.end(), [&](std::size_t p) {
    const auto [first, last] = entries_in(shape, model_.mesh->parts()[p]);
    return first != last;
  });
}

void PatchTargets::add_new(const GlbWeights& weights, const std::vector<bool>& used) {
  std::set<std::string> in_file;
  for (const auto& part : source_.parts) in_file.insert(part.targets.begin(), part.targets.end());
  for (std::size_t t = 0; t < weights.targets().size(); ++t) {
    const rig::BlendShape& shape = *weights.targets()[t];
    const std::string& name = shape.parameter.name;
    bool there = false;
    for (MeshTargets& mesh : meshes_) {
      for (TargetColumn& column : mesh.columns) {
        if (column.name != name) continue;
        column.target = t;
        there = true;
      }
    }
    const bool was_read = t < used.size() && source_shapes_.contains(name) && is_same_shape(shape);
    if (was_read && (in_file.contains(name) || !used[t])) continue;
    bool added = false;
    for (MeshTargets& mesh : meshes_) {
      const bool has = std::any_of(mesh.columns.begin(), mesh.columns.end(),
                                   [&](const TargetColumn& one) { return one.name == name; });
      const bool first_of_nothing = shape.vertices.empty() && !there && !added;
      if (has || !(moves(mesh, shape) || first_of_nothing)) continue;
      mesh.columns.push_back({name, std::nullopt, t, true});
      added = true;
    }
  }
  for (const MeshTargets& mesh : meshes_) {
    if (mesh.same()) continue;
    const std::string name = "mesh " + std::to_string(mesh.mesh);
    if (mesh.nodes.size() > 1) cannot_ = "nodes share " + name + ", which was changed for one of them";
    for (const std::size_t p : mesh.parts) {
      const auto& primitive = document_.model.meshes[mesh.mesh].primitives[source_.parts[p].primitives.front()];
      const auto position = primitive.attributes.find("POSITION");
      const bool fits = position != primitive.attributes.end() &&
                        document_.model.accessors[static_cast<std::size_t>(position->second)].count ==
                            model_.mesh->parts()[p].vertex_count;
      if (!fits) cannot_ = name + " has other vertices than the model";
    }
  }
}

std::vector<OneWayName> PatchTargets::one_way_names(const GlbWeights& weights) const {
  std::vector<OneWayName> names = weights.one_way_names();
  std::set<std::string> known;
  for (const OneWayName& one : names) known.insert(one.target);
  for (const MeshTargets& mesh : meshes_) {
    for (const TargetColumn& column : mesh.columns) {
      const auto helper = helpers_.find(column.name);
      if (helper != helpers_.end() && known.insert(column.name).second) names.push_back(*helper->second);
    }
  }
  return names;
}

const TargetWriter::Turned& TargetWriter::turned_by(const rig::BlendShape& shape) {
  if (shape_ == &shape) return turned_;
  const mesh::TriangleMesh& mesh = *model_.mesh;
  if (at_rest_.empty()) at_rest_ = smooth_normals(mesh.positions(), mesh.triangles(), mesh.smoothing());
  std::vector<mesh::ModelPoint> moved(mesh.positions().begin(), mesh.positions().end());
  for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
    moved[shape.vertices[i]] += geometry::ModelVector(shape.deltas[i]);
  }
  const auto now = smooth_normals(moved, mesh.triangles(), mesh.smoothing());
  turned_ = {};
  for (std::uint32_t v = 0; v < now.size(); ++v) {
    if (now[v] == at_rest_[v]) continue;
    turned_.vertices.push_back(v);
    const geometry::Turn turn =
        geometry::turn_between(geometry::ModelVector(at_rest_[v]), geometry::ModelVector(now[v]));
    turned_.turns.push_back(geometry::rotation_about(turn.axis, turn.angle));
  }
  shape_ = &shape;
  return turned_;
}

json::Json TargetWriter::write(const rig::BlendShape& shape, bool made, std::size_t index) {
  const mesh::Part& part = model_.mesh->parts()[index];
  const auto [first, last] = entries_in(shape, part);
  std::vector<std::uint32_t> elements;
  for (std::size_t i = first; i < last; ++i) elements.push_back(shape.vertices[i] - part.first_vertex);
  const auto deltas = std::span(shape.deltas).subspan(first, last - first);
  const bool keep_zeros =
      !made && std::any_of(deltas.begin(), deltas.end(), [](const glm::vec3& v) { return v == glm::vec3(0); });
  json::Json target = {
      {"POSITION", builder_.add_displacements(part.vertex_count, elements, flatten(deltas), keep_zeros, true)}};
  const document::SourceFile::Part& from = model_.source->parts[index];
  const auto& attributes = document_.model.meshes[from.mesh].primitives[from.primitives.front()].attributes;
  const bool normals = attributes.contains("NORMAL");
  if (!made) {
    if (!normals || shape.normal_deltas.empty()) return target;
    const auto own = std::span(shape.normal_deltas).subspan(first, last - first);
    target["NORMAL"] = builder_.add_displacements(part.vertex_count, elements, flatten(own), keep_zeros, false);
    return target;
  }
  const auto tangent = attributes.find("TANGENT");
  if (!normals && tangent == attributes.end()) return target;
  const Turned& turned = turned_by(shape);
  const auto begin = std::lower_bound(turned.vertices.begin(), turned.vertices.end(), part.first_vertex);
  const auto end = std::lower_bound(begin, turned.vertices.end(), part.first_vertex + part.vertex_count);
  std::vector<std::uint32_t> changed;
  for (auto v = begin; v != end; ++v) changed.push_back(*v - part.first_vertex);
  const auto turn_of = [&](std::size_t i) {
    return turned.turns[static_cast<std::size_t>(begin - turned.vertices.begin()) + i];
  };
  std::vector<float> moves;
  const auto add = [&](std::size_t i, const glm::dvec3& direction) {
    const glm::dvec3 move = turn_of(i) * direction - direction;
    for (int axis = 0; axis < 3; ++axis) moves.push_back(static_cast<float>(move[axis]));
  };
  if (normals && !model_.mesh->file_normals().empty()) {
    for (std::size_t i = 0; i < changed.size(); ++i) {
      add(i, glm::dvec3(model_.mesh->file_normals()[part.first_vertex + changed[i]]));
    }
    target["NORMAL"] = builder_.add_displacements(part.vertex_count, changed, moves, false, false);
  }
  if (tangent != attributes.end()) {
    const auto tangents =
        read_elements(document_, tangent->second, {.type = TINYGLTF_TYPE_VEC4, .count = part.vertex_count});
    if (!tangents) return target;
    const std::vector<float> numbers = tangents->dense();
    moves.clear();
    for (std::size_t i = 0; i < changed.size(); ++i) {
      const float* t = &numbers[std::size_t{4} * changed[i]];
      add(i, glm::dvec3(t[0], t[1], t[2]));
    }
    target["TANGENT"] = builder_.add_displacements(part.vertex_count, changed, moves, false, false);
  }
  return target;
}

}  // namespace penpose::io
