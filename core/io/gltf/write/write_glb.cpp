// One file above the usual size: the parts of a glTF file refer to each other by number and are written in one order.

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

#include "core/animation/track.h"
#include "core/geometry/rotation.h"
#include "core/io/gltf/internal/gltf_extras.h"
#include "core/io/gltf/write/dense_keys.h"
#include "core/io/gltf/write/glb_targets.h"
#include "core/io/gltf/write/internal/gltf_builder.h"
#include "core/io/gltf/write/one_way_targets.h"
#include "core/io/model/write_model.h"
#include "core/io/project/internal/project_json.h"
#include "core/io/project/write_document.h"
#include "core/io/surface/normals.h"

namespace penpose::io {
namespace {

constexpr std::size_t k_none = static_cast<std::size_t>(-1);

template <typename V>
std::vector<float> flatten(std::span<const V> vectors) {
  std::vector<float> numbers;
  numbers.reserve(vectors.size() * 3);
  for (const V& v : vectors) {
    for (int axis = 0; axis < 3; ++axis) numbers.push_back(static_cast<float>(v[axis]));
  }
  return numbers;
}

json::Json to_json(const glm::dvec3& v) { return json::Json::array({v.x, v.y, v.z}); }
json::Json numbers_of(const glm::dmat4& m) { return std::vector<double>(&m[0][0], &m[0][0] + 16); }
json::Json to_json(const glm::dquat& q) { return json::Json::array({q.x, q.y, q.z, q.w}); }

/// How the vertices of a part are carried.
enum class Carriage : std::uint8_t { free, rigid, skinned };

class GlbWriter {
 public:
  GlbWriter(const document::Model& model, const GlbOptions& options, json::Json project)
      : model_(model), project_(std::move(project)), morphs_(model, options.bake_tolerance) {
    find_keys();
    find_one_way_targets();
  }

  base::Result<std::vector<std::uint8_t>> write() {
    builder_.root["asset"] = {{"version", "2.0"}, {"generator", "penpose"}};
    builder_.root["extras"] = write_root_extras(model_, morphs_.baked_names(), one_way_names(), project_);
    find_carriage();
    write_joints();
    write_skin();
    compute_normals();
    for (std::size_t i = 0; i < model_.mesh->parts().size(); ++i) write_part(i);
    // The parts have set meshes and children on the nodes.
    for (json::Json& node : nodes_) builder_.add("nodes", std::move(node));
    builder_.root["scenes"] = json::Json::array({{{"nodes", scene_}}});
    builder_.root["scene"] = 0;
    write_animations();
    const double size = morphs_.size();
    report = {targets_.size(), morphs_.all().size() - morphs_.own_count(),
              morphs_.bake_error() + (size > 0 ? between_error_ / size : 0.0)};
    return builder_.finish();
  }

  GlbReport report;

 private:
  [[nodiscard]] std::span<const rig::Joint> joints() const {
    return model_.skeleton ? model_.skeleton->joints() : std::span<const rig::Joint>();
  }

  [[nodiscard]] bool is_weight_channel(const document::Channel& channel) const {
    const std::size_t rows = channel.interpolation == document::Interpolation::cubic_spline ? 3 : 1;
    return channel.target == document::ChannelTarget::weights && !channel.times_s.empty() && morphs_.own_count() > 0 &&
           channel.values.size() == channel.times_s.size() * rows * morphs_.own_count();
  }

  /// The keys of all weights, before the targets are written, which depend on them.
  void find_keys() {
    for (const document::Animation& animation : model_.animations) {
      for (const document::Channel& channel : animation.channels) {
        if (!is_weight_channel(channel)) continue;
        keys_.push_back({&channel, dense_keys(channel, morphs_, morphs_.between_tolerance())});
      }
    }
  }

  void find_one_way_targets() {
    pose_weights_ = morphs_.weights(model_.pose);
    std::vector<double> low = pose_weights_;
    std::vector<double> high = pose_weights_;
    for (const auto& [channel, keys] : keys_) {
      const bool cubic = is_cubic(*channel, keys);
      for (std::size_t row = 0; row < keys.rows.size(); ++row) {
        if (cubic && row % 3 != 1) continue;
        for (std::size_t t = 0; t < low.size(); ++t) {
          low[t] = std::min(low[t], keys.rows[row][t]);
          high[t] = std::max(high[t], keys.rows[row][t]);
        }
      }
    }
    one_way_ = one_way_targets(morphs_.all(), low, high);
    targets_.assign(morphs_.all().begin(), morphs_.all().end());
    helped_.assign(targets_.size(), false);
    for (const OneWayTarget& one : one_way_) {
      targets_.push_back(&one.shape);
      helped_[one.of] = true;
    }
  }

  static bool is_cubic(const document::Channel& channel, const DenseKeys& keys) {
    return channel.interpolation == document::Interpolation::cubic_spline && !keys.straightened;
  }

  [[nodiscard]] std::vector<OneWayName> one_way_names() const {
    std::vector<OneWayName> names;
    for (const OneWayTarget& one : one_way_) {
      names.push_back({targets_[one.of]->parameter.name, one.shape.parameter.name, one.turned ? -1.0 : 1.0});
    }
    return names;
  }

  /// The weight of a target where the targets' weights, before some were parted, are these.
  [[nodiscard]] double weight_of(std::size_t target, const std::vector<double>& weights) const {
    if (target >= weights.size()) {
      const OneWayTarget& one = one_way_[target - weights.size()];
      return one.part(weights[one.of]);
    }
    return helped_[target] ? std::clamp(weights[target], 0.0, 1.0) : weights[target];
  }

  /// The same of a tangent: all of it is that of the part in which the weight is.
  [[nodiscard]] double tangent_of(std::size_t target, const std::vector<double>& tangents,
                                  const std::vector<double>& weights) const {
    if (target >= weights.size()) {
      const OneWayTarget& one = one_way_[target - weights.size()];
      const double part = one.part(weights[one.of]);
      return part > 0 && (part < 1 || is_last(one, weights[one.of])) ? (one.turned ? -1 : 1) * tangents[one.of] : 0.0;
    }
    return !helped_[target] || (weights[target] >= 0 && weights[target] <= 1) ? tangents[target] : 0.0;
  }
  static bool is_last(const OneWayTarget& one, double weight) {
    return (one.turned ? -weight : weight) <= one.from + 1;
  }

  void find_carriage() {
    in_skin_.assign(joints().size(), false);
    for (std::size_t j = 0; j < joints().size(); ++j) in_skin_[j] = joints()[j].inverse_bind != glm::dmat4(1);
    for (const mesh::Part& part : model_.mesh->parts()) {
      carriage_.push_back(carriage_of(part));
      if (carriage_.back() != Carriage::skinned) continue;
      for (std::uint32_t v = part.first_vertex; v < part.first_vertex + part.vertex_count; ++v) {
        const auto influences = model_.skeleton->influences_of(v);
        for (const rig::Influence& influence : influences) in_skin_[influence.joint] = true;
        has_still_ = has_still_ || influences.empty();
      }
    }
  }

  [[nodiscard]] Carriage carriage_of(const mesh::Part& part) const {
    if (!model_.skeleton) return Carriage::free;
    bool none = true;
    bool rigid = true;
    const auto first = model_.skeleton->influences_of(part.first_vertex);
    for (std::uint32_t v = part.first_vertex; v < part.first_vertex + part.vertex_count; ++v) {
      const auto influences = model_.skeleton->influences_of(v);
      none = none && influences.empty();
      rigid = rigid && influences.size() == 1 && influences[0].weight == 1.0 && influences[0].joint == first[0].joint &&
              joints()[influences[0].joint].inverse_bind == glm::dmat4(1);
    }
    return none ? Carriage::free : rigid ? Carriage::rigid : Carriage::skinned;
  }

  /// Joints are the first nodes, in their order, so that they come back in it.
  void write_joints() {
    std::size_t parameter = document::weight_count(model_);
    for (const rig::Joint& joint : joints()) {
      json::Json own = {{"joint", true}, {"posable", joint.posable}};
      glm::dvec3 angles(0);
      if (joint.posable) {
        for (int axis = 0; axis < 3; ++axis) angles[axis] = model_.pose[parameter++];
        own["minimum"] = to_json(joint.minimum);
        own["maximum"] = to_json(joint.maximum);
        if (angles != glm::dvec3(0)) own["values"] = to_json(angles);
      }
      glm::dquat rotation = joint.rest_rotation;
      if (angles != glm::dvec3(0)) rotation = rotation * geometry::quaternion_from_xyz(angles);
      const double length = std::sqrt(glm::dot(rotation, rotation));
      if (std::abs(length - 1.0) > 1e-12) rotation = rotation / length;
      if (rotation != joint.rest_rotation) own["rest_rotation"] = to_json(joint.rest_rotation);
      if (glm::dmat4(glm::mat4(joint.inverse_bind)) != joint.inverse_bind)
        own["inverse_bind"] = numbers_of(joint.inverse_bind);
      json::Json node = json::Json::object();
      if (!joint.name.empty()) node["name"] = joint.name;
      if (joint.translation != glm::dvec3(0)) node["translation"] = to_json(joint.translation);
      if (rotation != glm::dquat(1, 0, 0, 0)) node["rotation"] = to_json(rotation);
      if (joint.scale != glm::dvec3(1)) node["scale"] = to_json(joint.scale);
      node["extras"] = {{k_extras_key, std::move(own)}};
      nodes_.push_back(std::move(node));
      if (joint.parent >= 0) {
        nodes_[static_cast<std::size_t>(joint.parent)]["children"].push_back(nodes_.size() - 1);
      } else {
        scene_.push_back(nodes_.size() - 1);
      }
    }
  }

  /// One skin serves all parts. Its joints need a common root (glTF 2.0, section 5.28), so roots are gathered below a
  /// node that is no joint where there are several.
  void write_skin() {
    if (std::find(in_skin_.begin(), in_skin_.end(), true) == in_skin_.end()) return;
    json::Json members = json::Json::array();
    std::vector<float> binds;
    skin_place_.assign(in_skin_.size(), k_none);
    for (std::size_t j = 0; j < in_skin_.size(); ++j) {
      if (!in_skin_[j]) continue;
      skin_place_[j] = members.size();
      members.push_back(j);
      add_bind(joints()[j].inverse_bind, binds);
    }
    if (has_still_) {
      still_place_ = members.size();
      members.push_back(nodes_.size());
      add_bind(glm::dmat4(1), binds);
      scene_.push_back(nodes_.size());
      nodes_.push_back({{"name", "still"}, {"extras", {{k_extras_key, {{"still", true}}}}}});
    }
    if (scene_.size() > 1) {
      nodes_.push_back({{"name", "joints"}, {"children", scene_}, {"extras", {{k_extras_key, {{"group", true}}}}}});
      scene_ = json::Json::array({nodes_.size() - 1});
    }
    builder_.add("skins", {{"joints", std::move(members)},
                           {"inverseBindMatrices", builder_.add_floats(binds, "MAT4", BufferUse::plain, false)}});
  }

  static void add_bind(const glm::dmat4& matrix, std::vector<float>& numbers) {
    for (int c = 0; c < 4; ++c) {
      for (int r = 0; r < 4; ++r) numbers.push_back(static_cast<float>(matrix[c][r]));
    }
  }

  void compute_normals() {
    const mesh::TriangleMesh& mesh = *model_.mesh;
    normals_.assign(mesh.file_normals().begin(), mesh.file_normals().end());
    const bool missing = normals_.empty();
    if (missing) normals_ = smooth_normals(mesh.positions(), mesh.triangles(), mesh.smoothing());
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
    if (carriage_[index] == Carriage::skinned) write_weights(part, attributes);
    std::vector<std::uint32_t> corners;
    for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
      for (const std::uint32_t v : model_.mesh->triangles()[t]) corners.push_back(v - part.first_vertex);
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
    if (carriage_[index] != Carriage::rigid) {
      if (carriage_[index] == Carriage::skinned) node["skin"] = 0;
      scene_.push_back(nodes_.size());
    } else {
      const std::size_t joint = model_.skeleton->influences_of(part.first_vertex)[0].joint;
      if (!nodes_[joint].contains("mesh")) {
        nodes_[joint]["mesh"] = mesh;
        node_of_part_[index] = joint;
        return;
      }
      node["extras"] = {{k_extras_key, {{"carried_by_parent", true}}}};
      nodes_[joint]["children"].push_back(nodes_.size());
    }
    node_of_part_[index] = nodes_.size();
    nodes_.push_back(std::move(node));
  }

  void write_weights(const mesh::Part& part, json::Json& attributes) {
    std::size_t most = 1;
    for (std::uint32_t v = part.first_vertex; v < part.first_vertex + part.vertex_count; ++v) {
      most = std::max(most, model_.skeleton->influences_of(v).size());
    }
    for (std::size_t set = 0; 4 * set < most; ++set) {
      std::vector<std::uint32_t> joint_numbers;
      std::vector<float> weights;
      for (std::uint32_t v = part.first_vertex; v < part.first_vertex + part.vertex_count; ++v) {
        const auto influences = model_.skeleton->influences_of(v);
        const double scale = weight_scale(influences);
        for (std::size_t i = 4 * set; i < 4 * set + 4; ++i) {
          const bool still = influences.empty() && i == 0;
          joint_numbers.push_back(still                   ? static_cast<std::uint32_t>(still_place_)
                                  : i < influences.size() ? static_cast<std::uint32_t>(skin_place_[influences[i].joint])
                                                          : 0U);
          weights.push_back(still                   ? 1.0F
                            : i < influences.size() ? static_cast<float>(influences[i].weight * scale)
                                                    : 0.0F);
        }
      }
      const std::string suffix = std::to_string(set);
      attributes["JOINTS_" + suffix] = builder_.add_joints(joint_numbers);
      attributes["WEIGHTS_" + suffix] = builder_.add_floats(weights, "VEC4", BufferUse::vertices, false);
    }
  }

  /// 1 where the weights sum to one within their float precision, so that they are written as they are.
  static double weight_scale(std::span<const rig::Influence> influences) {
    double sum = 0;
    for (const rig::Influence& influence : influences) sum += influence.weight;
    return std::abs(sum - 1.0) < 2e-7 || !(sum > 0.0) ? 1.0 : 1.0 / sum;
  }

  /// The entries of a shape that lie in a part, as first and one past the last.
  static std::pair<std::size_t, std::size_t> entries_in(const rig::BlendShape& shape, const mesh::Part& part) {
    const auto begin = shape.vertices.begin();
    const auto first = std::lower_bound(begin, shape.vertices.end(), part.first_vertex);
    const auto last = std::lower_bound(first, shape.vertices.end(), part.first_vertex + part.vertex_count);
    return {static_cast<std::size_t>(first - begin), static_cast<std::size_t>(last - begin)};
  }

  void write_targets(std::size_t index, json::Json& primitive, json::Json& mesh) {
    const mesh::Part& part = model_.mesh->parts()[index];
    bool normals = false;
    for (std::size_t s = 0; s < targets_.size(); ++s) {
      const rig::BlendShape& shape = *targets_[s];
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
      const rig::BlendShape& shape = *targets_[s];
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
      weights.push_back(weight_of(s, pose_weights_));
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

  /// The rate of which all keys are whole frames, or 0. glTF itself knows seconds alone.
  static double rate_of(const document::Animation& animation) {
    std::vector<double> times_s;
    for (const document::Channel& channel : animation.channels) {
      times_s.insert(times_s.end(), channel.times_s.begin(), channel.times_s.end());
    }
    std::stable_sort(times_s.begin(), times_s.end());
    times_s.erase(std::unique(times_s.begin(), times_s.end()), times_s.end());
    constexpr double k_whole = 1e-3;  // of a frame
    return animation::whole_frame_rate(times_s, k_whole);
  }

  void write_animations() {
    for (const document::Animation& animation : model_.animations) {
      json::Json channels = json::Json::array();
      json::Json samplers = json::Json::array();
      for (const document::Channel& channel : animation.channels) write_channel(channel, channels, samplers);
      if (channels.empty()) continue;
      json::Json object = {{"channels", std::move(channels)}, {"samplers", std::move(samplers)}};
      if (!animation.name.empty()) object["name"] = animation.name;
      const double fps = rate_of(animation);
      if (fps > 0) object["extras"] = {{k_extras_key, {{"fps", fps}}}};
      builder_.add("animations", std::move(object));
    }
  }

  /// Samplers of one channel share its times.
  struct Times {
    std::size_t input = k_none;
    document::Interpolation interpolation = document::Interpolation::linear;
    std::vector<std::size_t> added;  ///< keys that are there for other programs alone
    json::Json spline;               ///< what the keys are straight lines of, or null
  };
  Times write_times(std::vector<float> times_s, const document::Channel& channel) {
    // Moments that are too close for floats must still ascend (glTF 2.0, section 3.11).
    for (std::size_t i = 1; i < times_s.size(); ++i) {
      if (!(times_s[i] > times_s[i - 1]))
        times_s[i] = std::nextafter(times_s[i - 1], std::numeric_limits<float>::infinity());
    }
    return {builder_.add_floats(times_s, "SCALAR", BufferUse::plain, true), channel.interpolation, {}, {}};
  }
  void write_sampler(const Times& times, std::size_t node, const char* path, std::span<const float> values,
                     const char* type, json::Json& channels, json::Json& samplers) {
    constexpr std::array<const char*, 3> k_interpolations = {"STEP", "LINEAR", "CUBICSPLINE"};
    json::Json sampler = {{"input", times.input},
                          {"interpolation", k_interpolations[static_cast<std::size_t>(times.interpolation)]},
                          {"output", builder_.add_floats(values, type, BufferUse::plain, false)}};
    if (!times.spline.is_null()) {
      sampler["extras"] = {{k_extras_key, {{"spline", times.spline}}}};
    } else if (!times.added.empty()) {
      sampler["extras"] = {{k_extras_key, {{"added", times.added}}}};
    }
    samplers.push_back(std::move(sampler));
    channels.push_back({{"sampler", samplers.size() - 1}, {"target", {{"node", node}, {"path", path}}}});
  }

  void write_channel(const document::Channel& channel, json::Json& channels, json::Json& samplers) {
    if (channel.times_s.empty()) return;
    if (channel.target == document::ChannelTarget::weights) {
      if (is_weight_channel(channel)) write_weight_keys(channel, channels, samplers);
      return;
    }
    if (channel.joint >= joints().size()) return;
    const Times times = write_times({channel.times_s.begin(), channel.times_s.end()}, channel);
    const std::vector<float> values(channel.values.begin(), channel.values.end());
    const bool rotation = channel.target == document::ChannelTarget::rotation;
    const bool translation = channel.target == document::ChannelTarget::translation;
    write_sampler(times, channel.joint,
                  rotation      ? "rotation"
                  : translation ? "translation"
                                : "scale",
                  values, rotation ? "VEC4" : "VEC3", channels, samplers);
  }

  /// Rows of weights of all targets, or of those and their tangents, as a sampler of some of the targets has them.
  [[nodiscard]] std::vector<float> values_of(const std::vector<std::vector<double>>& rows, bool cubic,
                                             std::span<const std::size_t> shapes) const {
    std::vector<float> values;
    for (std::size_t row = 0; row < rows.size(); ++row) {
      for (const std::size_t s : shapes) {
        const bool tangent = cubic && row % 3 != 1;
        values.push_back(
            static_cast<float>(tangent ? tangent_of(s, rows[row], rows[row - row % 3 + 1]) : weight_of(s, rows[row])));
      }
    }
    return values;
  }

  void write_weight_keys(const document::Channel& channel, json::Json& channels, json::Json& samplers) {
    const auto found =
        std::find_if(keys_.begin(), keys_.end(), [&](const auto& one) { return one.channel == &channel; });
    const DenseKeys& keys = found->keys;
    between_error_ = std::max(between_error_, keys.error);
    std::optional<Times> times;
    for (std::size_t i = 0; i < shapes_of_part_.size(); ++i) {
      if (shapes_of_part_[i].empty()) continue;
      if (!times) {
        times = write_times(keys.times_s, channel);
        times->added = keys.added;
        if (keys.straightened) times->interpolation = document::Interpolation::linear;
      }
      const std::vector<float> values = values_of(keys.rows, is_cubic(channel, keys), shapes_of_part_[i]);
      if (keys.straightened) {
        times->spline = {{"times", keys.spline.times_s},
                         {"values", values_of(keys.spline.rows, true, shapes_of_part_[i])}};
      }
      write_sampler(*times, node_of_part_[i], "weights", values, "SCALAR", channels, samplers);
    }
  }

  const document::Model& model_;
  json::Json project_;  ///< null: the file is a model and no project
  GlbTargets morphs_;
  /// A channel of weights and its keys in the file.
  struct KeysOf {
    const document::Channel* channel;
    DenseKeys keys;
  };
  std::vector<KeysOf> keys_;
  std::vector<double> pose_weights_;   ///< of the targets of morphs_
  std::vector<OneWayTarget> one_way_;  ///< behind those
  std::vector<bool> helped_;           ///< one a target of morphs_: some of one_way_ are for it
  std::vector<const rig::BlendShape*> targets_;
  GltfBuilder builder_;
  std::vector<json::Json> nodes_;
  json::Json scene_ = json::Json::array();  ///< nodes at the root
  std::vector<Carriage> carriage_;
  std::vector<bool> in_skin_;
  std::vector<std::size_t> skin_place_;
  std::size_t still_place_ = 0;
  bool has_still_ = false;
  std::vector<glm::vec3> normals_;
  std::vector<std::vector<std::size_t>> shapes_of_part_;
  std::vector<std::size_t> node_of_part_;
  double between_error_ = 0;  ///< of keys, model units
};

}  // namespace

base::Result<std::vector<std::uint8_t>> write_glb(const document::Model& model, const GlbOptions& options,
                                                  GlbReport* report) {
  GlbWriter writer(model, options, nullptr);
  auto bytes = writer.write();
  if (report != nullptr) *report = writer.report;
  return bytes;
}

base::Result<std::vector<std::uint8_t>> write_project(const document::Document& document, const GlbOptions& options,
                                                      GlbReport* report) {
  const document::Model model = document::model_of(document);
  GlbWriter writer(model, options, project_to_json(document));
  auto bytes = writer.write();
  if (report != nullptr) *report = writer.report;
  return bytes;
}

}  // namespace penpose::io
