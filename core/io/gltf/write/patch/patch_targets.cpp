#include "core/io/gltf/write/patch/patch_targets.h"

#include <algorithm>
#include <set>

#include "core/io/gltf/read/internal/gltf_accessor.h"
#include "core/io/gltf/write/shape_entries.h"

namespace penpose::io {

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
    auto found = std::find_if(meshes_.begin(), meshes_.end(),
                              [&](const auto& one) { return one.mesh == part.mesh && one.node == part.node; });
    if (found == meshes_.end()) {
      meshes_.push_back({part.mesh, part.node, part.node, {}, part.targets.size(), {}, part.mesh});
      found = meshes_.end() - 1;
    }
    found->parts.push_back(p);
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

}  // namespace penpose::io
