#include "core/io/gltf/write/patch/patch_columns.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/io/gltf/internal/gltf_extras.h"
#include "core/io/gltf/read/internal/gltf_accessor.h"
#include "core/io/gltf/read/internal/gltf_meshes.h"
#include "core/io/gltf/write/patch/plain_primitives.h"
#include "core/io/gltf/write/patch/target_writer.h"

namespace penpose::io {
namespace {

/// The old entries of a list and others where there are new columns.
json::Json with_columns(const json::Json& list, const MeshTargets& mesh, const json::Json& fresh) {
  json::Json result = json::Json::array();
  for (const TargetColumn& column : mesh.columns) {
    result.push_back(column.old && *column.old < list.size() ? list[*column.old] : fresh);
  }
  return result;
}

template <typename Value>
std::vector<Value> fit_rows(const MeshTargets& mesh, const std::vector<Value>& old) {
  std::vector<Value> values;
  for (std::size_t row = 0; row + mesh.old_count <= old.size(); row += mesh.old_count) {
    for (const TargetColumn& column : mesh.columns) values.push_back(column.old ? old[row + *column.old] : Value{});
  }
  return values;
}

}  // namespace

void PatchColumns::write() {
  const std::size_t shapes = state_.model.shapes ? state_.model.shapes->shapes().size() : 0;
  TargetWriter writer(state_.model, state_.document, state_.builder);
  PlainPrimitives plain(state_);
  for (MeshTargets& mesh : state_.targets.meshes()) {
    if (mesh.same()) continue;
    state_.changed = true;
    give_own_mesh(mesh);
    json::Json& object = state_.builder.root["meshes"][mesh.written];
    const std::size_t count = object["primitives"].size();
    std::vector<std::optional<std::size_t>> part_of(count);
    for (const std::size_t part : mesh.parts) {
      for (const std::size_t primitive : state_.source.parts[part].primitives) part_of[primitive] = part;
    }
    std::vector<json::Json> lists(count, json::Json::array());
    for (const TargetColumn& column : mesh.columns) {
      std::map<std::size_t, json::Json> of_part;
      for (std::size_t p = 0; p < count; ++p) {
        if (!column.fresh) {
          const json::Json* old = json::find(object["primitives"][p], "targets");
          if (old != nullptr && *column.old < old->size()) lists[p].push_back((*old)[*column.old]);
          continue;
        }
        if (!part_of[p]) {
          lists[p].push_back(still_target(object["primitives"][p]));
          continue;
        }
        const auto [at, is_new] = of_part.try_emplace(*part_of[p]);
        if (is_new) {
          at->second =
              writer.write(*state_.weights->targets()[column.target], is_made(column.target, shapes), *part_of[p]);
        }
        lists[p].push_back(at->second);
      }
    }
    for (std::size_t p = 0; p < count; ++p) {
      json::Json& primitive = object["primitives"][p];
      plain.write(mesh.mesh, p, primitive);
      if (!lists[p].empty()) {
        primitive["targets"] = std::move(lists[p]);
      } else if (primitive.contains("targets")) {
        primitive.erase("targets");
      }
    }
    name_targets(mesh, object);
    if (mesh.same_columns()) continue;
    fit_weights(mesh, object);
    fit_samplers(mesh);
  }
  plain.forget_unused();
}

/// A node that shares its mesh with others gets a copy of it, whose accessors are the same.
void PatchColumns::give_own_mesh(MeshTargets& mesh) {
  if (state_.users_of(mesh.mesh) < 2) return;
  json::Json copy = state_.builder.root["meshes"][mesh.mesh];
  own_extras_of(copy)["copy_of"] = place_of_mesh(state_.document, mesh.mesh);
  mesh.written = state_.builder.add("meshes", std::move(copy));
  state_.builder.root["nodes"][mesh.node]["mesh"] = mesh.written;
}

/// Whether a target was made for a sketched control, so that its normals follow from its positions.
bool PatchColumns::is_made(std::size_t target, std::size_t shapes) const {
  return target >= shapes && target < state_.morphs.all().size();
}

/// The target of lines and points, which follow no control.
json::Json PatchColumns::still_target(const json::Json& primitive) {
  const json::Json* position = json::find(primitive["attributes"], "POSITION");
  if (position == nullptr) return json::Json::object();
  const auto count = state_.builder.root["accessors"][position->get<std::size_t>()]["count"].get<std::size_t>();
  return {{"POSITION", state_.builder.add_zeros(count, "VEC3", true)}};
}

/// Names stand where the file has them, in the extras of the mesh or of its primitives.
void PatchColumns::name_targets(const MeshTargets& mesh, json::Json& object) {
  const auto names_of = [](const json::Json& of) -> const json::Json* {
    const json::Json* extras = json::find(of, "extras");
    const json::Json* names = extras == nullptr ? nullptr : json::find(*extras, "targetNames");
    return names != nullptr && names->is_array() ? names : nullptr;
  };
  const auto renamed = [&](const json::Json& old) {
    json::Json names = json::Json::array();
    for (const TargetColumn& column : mesh.columns) {
      const bool has = column.old && *column.old < old.size();
      names.push_back(has ? old[*column.old] : json::Json(column.name));
    }
    return names;
  };
  bool in_primitives = false;
  for (std::size_t p = 0; p < object["primitives"].size(); ++p) {
    json::Json& primitive = object["primitives"][p];
    const json::Json* names = names_of(primitive);
    if (names == nullptr) continue;
    in_primitives = true;
    primitive["extras"]["targetNames"] = renamed(*names);
  }
  const json::Json* names = names_of(object);
  if (names == nullptr && in_primitives) return;
  json::Json made = renamed(names == nullptr ? json::Json::array() : *names);
  const json::Json* extras = json::find(object, "extras");
  if (extras == nullptr || !extras->is_object()) object["extras"] = json::Json::object();
  object["extras"]["targetNames"] = std::move(made);
}

/// Weights of meshes and nodes are as many as the targets.
void PatchColumns::fit_weights(const MeshTargets& mesh, json::Json& object) {
  const auto fit = [&](json::Json& holder) {
    if (!holder.contains("weights") || holder["weights"].empty()) return;
    json::Json weights = with_columns(holder["weights"], mesh, 0);
    if (weights.empty()) {
      holder.erase("weights");
    } else {
      holder["weights"] = std::move(weights);
    }
  };
  fit(object);
  fit(state_.builder.root["nodes"][mesh.node]);
}

/// Keys of weights get the columns of the targets; samplers that serve other nodes, too, are copied.
void PatchColumns::fit_samplers(const MeshTargets& mesh) {
  if (mesh.old_count == 0 || !state_.builder.root.contains("animations")) return;
  std::map<std::size_t, std::size_t> outputs;  // accessor of the file and what it has become
  json::Json& animations = state_.builder.root["animations"];
  for (std::size_t a = 0; a < animations.size(); ++a) {
    json::Json& channels = animations[a]["channels"];
    json::Json& samplers = animations[a]["samplers"];
    std::map<std::size_t, std::size_t> fitted;  // samplers, and those that they have become
    for (std::size_t c = 0; c < channels.size(); ++c) {
      if (!moves_weights_of(channels[c], mesh.node)) continue;
      const auto sampler = channels[c]["sampler"].get<std::size_t>();
      const auto [now, is_new] = fitted.try_emplace(sampler, sampler);
      if (is_new) {
        const bool shared = std::any_of(channels.begin(), channels.end(), [&](const json::Json& other) {
          return !moves_weights_of(other, mesh.node) && other["sampler"].get<std::size_t>() == sampler;
        });
        if (shared) {
          samplers.push_back(json::Json(samplers[sampler]));
          now->second = samplers.size() - 1;
        }
        fit_sampler(mesh, samplers[now->second], outputs);
      }
      channels[c]["sampler"] = now->second;
    }
  }
}

void PatchColumns::fit_sampler(const MeshTargets& mesh, json::Json& sampler,
                               std::map<std::size_t, std::size_t>& outputs) {
  const auto output = sampler["output"].get<std::size_t>();
  const auto found = outputs.find(output);
  if (found == outputs.end()) {
    const auto elements = read_elements(state_.document, static_cast<int>(output), {.type = TINYGLTF_TYPE_SCALAR});
    if (!elements || elements->count == 0 || elements->count % mesh.old_count != 0) return;
    outputs[output] = state_.builder.add_floats(fit_rows(mesh, elements->dense()), "SCALAR", BufferUse::plain, false);
  }
  sampler["output"] = outputs[output];
  const json::Json* extras = json::find(sampler, "extras");
  const json::Json* own = extras == nullptr ? nullptr : json::find(*extras, k_extras_key);
  const json::Json* spline = own == nullptr ? nullptr : json::find(*own, "spline");
  const json::Json* values = spline == nullptr ? nullptr : json::find(*spline, "values");
  if (values == nullptr || !values->is_array()) return;
  std::vector<json::Json> old;
  for (const json::Json& value : *values) old.push_back(value);
  json::Json fitted = json::Json::array();
  for (json::Json& value : fit_rows(mesh, old)) fitted.push_back(value.is_null() ? json::Json(0) : std::move(value));
  sampler["extras"][k_extras_key]["spline"]["values"] = std::move(fitted);
}

}  // namespace penpose::io
