#include "core/io/fbx/fbx_shapes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace penpose::io {
namespace {

/// Values of channels lie within this.
constexpr double k_farthest_value = 10.0;

double within_reach(double value) {
  return std::isfinite(value) ? std::clamp(value, -k_farthest_value, k_farthest_value) : 0.0;
}

double value_of(const FbxObject& channel) {
  const FbxRecord* plain = channel.record->find("DeformPercent");
  return within_reach(FbxScene::property(channel, "DeformPercent", plain != nullptr ? plain->number(0) : 0.0) / 100.0);
}

}  // namespace

void FbxChannel::spread(double channel, std::vector<double>& out) const {
  const double goal = within_reach(channel);
  for (const std::size_t shape : shapes) out[shape] = 0.0;
  if (shapes.empty()) return;
  // Two points around the value, or the last two on its side of nothing; -1 is nothing.
  const auto count = static_cast<std::ptrdiff_t>(knees.size());
  const std::ptrdiff_t first = std::upper_bound(knees.begin(), knees.end(), 0.0) - knees.begin();
  std::ptrdiff_t from = -1;
  std::ptrdiff_t to = -1;
  if (goal > 0.0) {
    for (std::ptrdiff_t i = first; i < count && (to < 0 || knees[static_cast<std::size_t>(to)] <= goal); ++i)
      from = std::exchange(to, i);
  } else {
    for (std::ptrdiff_t i = first - 1; i >= 0 && (to < 0 || knees[static_cast<std::size_t>(to)] >= goal); --i)
      from = std::exchange(to, i);
  }
  // Where its side has none, on beyond nothing from the first one of the other side.
  if (to < 0) to = goal > 0.0 ? first - 1 : first;
  const double begin = from < 0 ? 0.0 : knees[static_cast<std::size_t>(from)];
  const double length = knees[static_cast<std::size_t>(to)] - begin;
  if (length == 0.0) return;
  const double share = (goal - begin) / length;
  out[shapes[static_cast<std::size_t>(to)]] = within_reach(share);
  if (from >= 0) out[shapes[static_cast<std::size_t>(from)]] = within_reach(1.0 - share);
}

bool FbxShapes::same_keys(std::int64_t a, std::int64_t b) const {
  const auto curves_of = [&](std::int64_t id) {
    std::vector<const FbxObject*> curves;
    for (const FbxObject* node : scene_.parts_of(id, "AnimationCurveNode")) {
      if (const FbxObject* curve = scene_.part_at(node->id, "d|DeformPercent")) curves.push_back(curve);
    }
    return curves;
  };
  const auto one = curves_of(a);
  const auto two = curves_of(b);
  return one.size() == two.size() && std::equal(one.begin(), one.end(), two.begin(), [](const auto* x, const auto* y) {
           return x == y || (x->record->wholes("KeyTime") == y->record->wholes("KeyTime") &&
                             x->record->numbers("KeyValueFloat") == y->record->numbers("KeyValueFloat"));
         });
}

void FbxShapes::add_deltas(const FbxObject& shape, const std::vector<double>& mask, const Part& part,
                           rig::BlendShape& to) const {
  const std::vector<std::int64_t> indices = shape.record->wholes("Indexes");
  const std::vector<double> numbers = shape.record->numbers("Vertices");
  std::vector<std::pair<std::uint32_t, glm::vec3>> moves;
  for (std::size_t i = 0; i < std::min(indices.size(), numbers.size() / 3); ++i) {
    if (indices[i] < 0 || indices[i] >= static_cast<std::int64_t>(part.vertex_count)) continue;
    const auto vertex = static_cast<std::uint32_t>(indices[i]);
    const bool loose = part.loose != nullptr && vertex < part.loose->size() && (*part.loose)[vertex];
    const double share = i < mask.size() ? mask[i] / 100.0 : 1.0;
    const glm::dvec3 delta = (loose ? part.placed_loose : part.placed) *
                             (glm::dvec3(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]) * share);
    if (!std::isfinite(delta.x + delta.y + delta.z) || delta == glm::dvec3(0)) continue;
    moves.emplace_back(part.first_vertex + vertex, glm::vec3(delta));
  }
  std::stable_sort(moves.begin(), moves.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i < moves.size(); ++i) {
    // If a vertex appears twice, the later one counts.
    if (i + 1 < moves.size() && moves[i + 1].first == moves[i].first) continue;
    to.vertices.push_back(moves[i].first);
    to.deltas.push_back(moves[i].second);
  }
}

std::size_t FbxShapes::add(const FbxObject& channel, const Part& part) {
  auto targets = scene_.parts_of(channel.id, "Geometry", "Shape");
  if (targets.empty()) return 0;
  std::size_t looked_at = 0;
  for (const FbxObject* target : targets) looked_at += target->record->wholes("Indexes").size() + 1;
  std::vector<double> mask = channel.record->numbers("FullWeights");
  const std::size_t moved = targets.front()->record->wholes("Indexes").size();
  // One value a vertex of a single shape is the mask of a vertex group; otherwise it is one a shape.
  std::vector<std::pair<double, const FbxObject*>> knees;
  const bool masked = targets.size() == 1 && mask.size() == moved && (moved > 1 || scene_.of_blender());
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const double knee =
        masked || mask.size() != targets.size() ? (i + 1 == targets.size() ? 1.0 : 0.0) : mask[i] / 100.0;
    if (knee != 0.0 && std::isfinite(knee)) knees.emplace_back(knee, targets[i]);
  }
  if (!masked) mask.clear();
  std::stable_sort(knees.begin(), knees.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  knees.erase(std::unique(knees.begin(), knees.end(), [](const auto& a, const auto& b) { return a.first == b.first; }),
              knees.end());
  if (knees.empty()) return looked_at;

  FbxChannel read{channel.id, part.number, {}, {}, value_of(channel)};
  for (const auto& [knee, shape] : knees) read.knees.push_back(knee);
  const std::string& name = channel.name.empty() ? targets.back()->name : channel.name;
  FbxChannel* known = nullptr;
  std::vector<std::size_t>& namesakes = by_name_[name];
  const bool taken = !namesakes.empty();
  for (const std::size_t i : namesakes) {
    FbxChannel& one = channels[i];
    if (one.part != part.number && one.value == read.value && one.knees == read.knees && same_keys(one.id, channel.id))
      known = &one;
  }
  if (known == nullptr) {
    const std::string own = taken ? name + " " + part.name : name;
    // The last shape comes first: it has the channel's name.
    for (std::size_t i = knees.size(); i-- > 0;) {
      rig::BlendShape shape;
      shape.parameter = {own, 0.0, 0.0, 1.0};
      if (i + 1 < knees.size()) {
        shape.parameter.name += "_" + std::to_string(std::lround(within_reach(knees[i].first) * 100.0));
        between.push_back(shape.parameter.name);
      }
      read.shapes.insert(read.shapes.begin(), shapes.size());
      shapes.push_back(std::move(shape));
      values.push_back(0.0);
    }
    read.spread(read.value, values);
    namesakes.push_back(channels.size());
    channels.push_back(std::move(read));
    known = &channels.back();
  }
  known->part = part.number;
  for (std::size_t i = 0; i < knees.size(); ++i) add_deltas(*knees[i].second, mask, part, shapes[known->shapes[i]]);
  return looked_at;
}

}  // namespace penpose::io
