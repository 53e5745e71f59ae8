#include "core/io/gltf/write/write_vrma.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "core/base/math.h"
#include "core/base/numbers.h"
#include "core/document/expressions.h"
#include "core/document/humanoid_rest.h"
#include "core/document/time/animation_sampling.h"
#include "core/geometry/rotation.h"
#include "core/io/gltf/write/internal/gltf_builder.h"
#include "core/io/model/model_formats.h"

namespace penpose::io {
namespace {

using document::Channel;
using document::ChannelTarget;
using document::HumanBone;
using document::Interpolation;

/// Numbers that the weights of expressions may be found from, all keys together.
constexpr std::size_t k_most_numbers = 36'000'000;
/// A weight below this is none.
constexpr double k_no_weight = 1e-4;

/// All times of some channels, and within splines seven more between two keys.
std::vector<double> key_times(const std::vector<const Channel*>& channels) {
  std::vector<double> times;
  for (const Channel* channel : channels) {
    const auto& keys = channel->times_s;
    for (std::size_t k = 0; k < keys.size(); ++k) {
      times.push_back(keys[k]);
      for (int i = 1; channel->interpolation == Interpolation::cubic_spline && k + 1 < keys.size() && i < 8; ++i)
        times.push_back(keys[k] + (keys[k + 1] - keys[k]) * i / 8.0);
    }
  }
  for (double& time : times) time = static_cast<double>(static_cast<float>(time));
  std::stable_sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

/// One control of expressions' weights: an expression, or a control that is in none.
struct Column {
  std::string name;
  std::vector<std::pair<std::size_t, double>> values;
  bool control = false;  ///< of that name, and no expression
  double square = 0;     ///< sum of the squares of the values
  std::vector<float> weights;
};

class VrmaWriter {
 public:
  VrmaWriter(const document::Model& model, const document::Humanoid& known)
      : model_(model),
        animation_(model.animations.empty() ? nullptr : &model.animations.front()),
        humanoid_(document::humanoid_of(model, known)),
        to_front_(geometry::quaternion_from_xyz({0, -base::radians(model.front_yaw_degrees), 0})) {
    if (!model.skeleton) return;
    rest_ = document::rest_joints(model.skeleton->joints());
    std::size_t parameter = document::weight_count(model);
    for (const rig::Joint& joint : model.skeleton->joints()) {
      pose_of_.push_back(joint.rest_rotation);
      if (!joint.posable) continue;
      const double* angles = &model.pose[parameter];
      pose_of_.back() = joint.rest_rotation * geometry::quaternion_from_xyz({angles[0], angles[1], angles[2]});
      parameter += 3;
    }
    turns_.resize(rest_.size());
    shifts_.resize(rest_.size());
    for (std::size_t c = 0; animation_ != nullptr && c < animation_->channels.size(); ++c) {
      const Channel& channel = animation_->channels[c];
      if (channel.joint >= rest_.size() || channel.times_s.empty()) continue;
      if (channel.target == ChannelTarget::rotation) turns_[channel.joint] = &channel;
      if (channel.target == ChannelTarget::translation) shifts_[channel.joint] = &channel;
    }
  }

  base::Result<VrmaFile> write() {
    builder_.root["asset"] = {{"version", "2.0"}, {"generator", "penpose"}};
    builder_.root["extensionsUsed"] = json::Json::array({"VRMC_vrm_animation"});
    own_ = {{"specVersion", "1.0"}};
    place_bones();
    for (std::size_t b = 0; b < document::k_human_bones; ++b) turn_bone(static_cast<HumanBone>(b));
    move_hips();
    turn_gaze();
    if (auto status = write_expressions(); !status) return status.error();
    if (channels_.empty()) {
      return base::Error{"the model has neither an animation nor a pose that a VRM animation holds", "",
                         "pose or animate bones of a human figure or blend shapes"};
    }
    note_left_out();
    for (json::Json& node : nodes_) builder_.add("nodes", std::move(node));
    builder_.root["scenes"] = json::Json::array({{{"nodes", scene_}}});
    builder_.root["scene"] = 0;
    json::Json object = {{"channels", std::move(channels_)}, {"samplers", std::move(samplers_)}};
    if (animation_ != nullptr && !animation_->name.empty()) object["name"] = animation_->name;
    builder_.add("animations", std::move(object));
    builder_.root["extensions"]["VRMC_vrm_animation"] = std::move(own_);
    auto bytes = builder_.finish();
    if (!bytes) return bytes.error();
    return VrmaFile{std::move(bytes).value(), std::move(notes_)};
  }

 private:
  /// The nearest bone above that the model has.
  [[nodiscard]] std::optional<HumanBone> above(HumanBone bone) const {
    auto up = document::parent_of(bone);
    while (up && !humanoid_.joint(*up)) up = document::parent_of(*up);
    return up;
  }

  static json::Json numbers(const glm::dvec3& v) {
    return {static_cast<double>(static_cast<float>(v.x)), static_cast<double>(static_cast<float>(v.y)),
            static_cast<double>(static_cast<float>(v.z))};
  }

  /// Whether the format has it at all: eyes are the gaze (VRMC_vrm_animation, schema of humanBones).
  static bool is_eye(HumanBone bone) { return bone == HumanBone::left_eye || bone == HumanBone::right_eye; }

  /// The format wants these (the same schema).
  static bool is_required(HumanBone bone) {
    using enum HumanBone;
    constexpr std::array k_required{hips,
                                    spine,
                                    head,
                                    left_upper_leg,
                                    left_lower_leg,
                                    left_foot,
                                    right_upper_leg,
                                    right_lower_leg,
                                    right_foot,
                                    left_upper_arm,
                                    left_lower_arm,
                                    left_hand,
                                    right_upper_arm,
                                    right_lower_arm,
                                    right_hand};
    return std::find(k_required.begin(), k_required.end(), bone) != k_required.end();
  }

  /// The figure in T-pose. Bones that the format wants and the model lacks stand still where the bone above them is.
  void place_bones() {
    node_of_.assign(document::k_human_bones, std::nullopt);
    if (humanoid_.empty()) return;
    std::vector<glm::dvec3> places(document::k_human_bones, glm::dvec3(0));
    json::Json bones = json::Json::object();
    for (std::size_t b = 0; b < document::k_human_bones; ++b) {
      const auto bone = static_cast<HumanBone>(b);
      const auto joint = humanoid_.joint(bone);
      if (is_eye(bone) || (!joint && !is_required(bone))) continue;
      auto parent = document::parent_of(bone);
      while (parent && !node_of_[static_cast<std::size_t>(*parent)]) parent = document::parent_of(*parent);
      const glm::dvec3 above = parent ? places[static_cast<std::size_t>(*parent)] : glm::dvec3(0);
      places[b] = joint ? to_front_ * rest_[*joint].position : above;
      node_of_[b] = add_node(std::string(document::name_of(bone)), places[b] - above,
                             parent ? node_of_[static_cast<std::size_t>(*parent)] : std::nullopt);
      bones[std::string(document::name_of(bone))] = {{"node", *node_of_[b]}};
    }
    own_["humanoid"]["humanBones"] = std::move(bones);
  }

  std::size_t add_node(std::string name, const glm::dvec3& place, std::optional<std::size_t> parent) {
    const std::size_t node = nodes_.size();
    json::Json object = {{"name", std::move(name)}};
    if (place != glm::dvec3(0)) object["translation"] = numbers(place);
    nodes_.push_back(std::move(object));
    if (parent) {
      nodes_[*parent]["children"].push_back(node);
    } else {
      scene_.push_back(node);
    }
    return node;
  }

  void add_keys(const std::vector<double>& times_s, Interpolation interpolation, const std::vector<float>& values,
                const char* type, std::size_t node, const char* path) {
    constexpr std::array<const char*, 3> k_interpolations = {"STEP", "LINEAR", "CUBICSPLINE"};
    const std::vector<float> times(times_s.begin(), times_s.end());
    auto [input, is_new] = inputs_.try_emplace(times, 0);
    if (is_new) input->second = builder_.add_floats(times, "SCALAR", BufferUse::plain, true);
    samplers_.push_back({{"input", input->second},
                         {"interpolation", k_interpolations[static_cast<std::size_t>(interpolation)]},
                         {"output", builder_.add_floats(values, type, BufferUse::plain, false)}});
    channels_.push_back({{"sampler", samplers_.size() - 1}, {"target", {{"node", node}, {"path", path}}}});
  }

  [[nodiscard]] glm::dquat local_rotation(std::size_t joint, double time_s) const {
    if (turns_[joint] != nullptr) {
      const auto v = document::sample_channel(*turns_[joint], 4, time_s);
      if (v.size() == 4) return {v[3], v[0], v[1], v[2]};
    }
    return pose_of_[joint];
  }

  /// The joints from a bone up to the bone above it, or to the root.
  [[nodiscard]] std::vector<std::size_t> path_of(HumanBone bone) const {
    const auto parent = above(bone);
    const std::int32_t end = parent ? static_cast<std::int32_t>(*humanoid_.joint(*parent)) : -1;
    std::vector<std::size_t> path;
    for (auto j = static_cast<std::int32_t>(*humanoid_.joint(bone)); j >= 0 && j != end;
         j = model_.skeleton->joints()[static_cast<std::size_t>(j)].parent)
      path.push_back(static_cast<std::size_t>(j));
    return path;
  }

  void add_quaternion(const glm::dquat& q, bool direction, std::vector<float>& values) const {
    glm::dquat turned = to_front_ * q * glm::conjugate(to_front_);
    // Neighbouring keys lie on the same side; tangents keep theirs.
    if (direction && values.size() >= 4) {
      const float* last = &values[values.size() - 4];
      const double dot = static_cast<double>(last[0]) * turned.x + static_cast<double>(last[1]) * turned.y +
                         static_cast<double>(last[2]) * turned.z + static_cast<double>(last[3]) * turned.w;
      if (dot < 0) turned = -turned;
    }
    for (const double part : {turned.x, turned.y, turned.z, turned.w}) values.push_back(static_cast<float>(part));
  }

  /// The normalised rotation of a bone at a time: N = P q inverse(W), where joints between it and the bone above turn
  /// too; P is the rotation of the bone above, or of the joint above the whole path, at rest.
  [[nodiscard]] glm::dquat normalised(const std::vector<std::size_t>& path, double time_s) const {
    glm::dquat turned = rest_[path.back()].parent_rotation;
    for (auto j = path.rbegin(); j != path.rend(); ++j) turned = turned * local_rotation(*j, time_s);
    return document::unit_rotation(turned * glm::conjugate(rest_[path.front()].rotation));
  }

  /// Keys of the normalised rotation; empty where the bone stays at rest.
  struct Turns {
    std::vector<double> times_s;
    Interpolation interpolation = Interpolation::linear;
    std::vector<float> values;
  };
  [[nodiscard]] Turns turns_of(HumanBone bone) {
    Turns turns;
    const std::vector<std::size_t> path = path_of(bone);
    std::vector<const Channel*> moved;
    bool posed = false;
    for (const std::size_t j : path) {
      used_.insert(j);
      if (turns_[j] != nullptr) moved.push_back(turns_[j]);
      posed = posed || (turns_[j] == nullptr && pose_of_[j] != model_.skeleton->joints()[j].rest_rotation);
    }
    if (moved.empty() && !posed) return turns;
    const bool alone = path.size() == 1 && moved.size() == 1;
    if (!alone) {
      turns.times_s = moved.empty() ? std::vector<double>{0.0} : key_times(moved);
      for (const double time : turns.times_s) add_quaternion(normalised(path, time), true, turns.values);
      return turns;
    }
    // Linear in the quaternion, so that keys and tangents stay keys and tangents.
    const Channel& from = *moved.front();
    const bool cubic = from.interpolation == Interpolation::cubic_spline;
    turns.interpolation = from.interpolation;
    turns.times_s = from.times_s;
    const document::RestJoint& rest = rest_[path.front()];
    for (std::size_t i = 0; i + 4 <= from.values.size(); i += 4) {
      const double* v = &from.values[i];
      add_quaternion(rest.parent_rotation * glm::dquat(v[3], v[0], v[1], v[2]) * glm::conjugate(rest.rotation), !cubic,
                     turns.values);
    }
    return turns;
  }

  void turn_bone(HumanBone bone) {
    if (!humanoid_.joint(bone) || is_eye(bone)) return;
    const Turns turns = turns_of(bone);
    if (turns.times_s.empty()) return;
    add_keys(turns.times_s, turns.interpolation, turns.values, "VEC4", *node_of_[static_cast<std::size_t>(bone)],
             "rotation");
  }

  void move_hips() {
    const auto joint = humanoid_.joint(HumanBone::hips);
    if (!joint) return;
    const std::vector<std::size_t> path = path_of(HumanBone::hips);
    std::vector<const Channel*> moved;
    for (const std::size_t j : path) {
      if (shifts_[j] != nullptr) moved.push_back(shifts_[j]);
      if (j != *joint && turns_[j] != nullptr) moved.push_back(turns_[j]);
    }
    if (moved.empty()) return;
    const std::vector<double> times = key_times(moved);
    std::vector<float> values;
    for (const double time : times) {
      glm::dvec3 place(0);
      for (const std::size_t j : path) {
        const rig::Joint& one = model_.skeleton->joints()[j];
        glm::dvec3 shift = one.translation;
        if (shifts_[j] != nullptr) {
          const auto v = document::sample_channel(*shifts_[j], 3, time);
          if (v.size() == 3) shift = {v[0], v[1], v[2]};
        }
        place = j == *joint ? shift : shift + local_rotation(j, time) * (one.scale * place);
      }
      place = to_front_ * place;
      for (int axis = 0; axis < 3; ++axis) values.push_back(static_cast<float>(place[axis]));
    }
    const bool steps = std::all_of(moved.begin(), moved.end(),
                                   [](const Channel* one) { return one->interpolation == Interpolation::step; });
    add_keys(times, steps ? Interpolation::step : Interpolation::linear, values, "VEC3",
             *node_of_[static_cast<std::size_t>(HumanBone::hips)], "translation");
  }

  void turn_gaze() {
    std::vector<HumanBone> eyes;
    std::vector<const Channel*> moved;
    bool posed = false;
    glm::dvec3 place(0);
    for (const HumanBone eye : {HumanBone::left_eye, HumanBone::right_eye}) {
      const auto joint = humanoid_.joint(eye);
      if (!joint) continue;
      eyes.push_back(eye);
      place += to_front_ * rest_[*joint].position;
      for (const std::size_t j : path_of(eye)) {
        used_.insert(j);
        if (turns_[j] != nullptr) moved.push_back(turns_[j]);
        posed = posed || (turns_[j] == nullptr && pose_of_[j] != model_.skeleton->joints()[j].rest_rotation);
      }
    }
    if (eyes.empty() || (moved.empty() && !posed)) return;
    const std::vector<double> times = moved.empty() ? std::vector<double>{0.0} : key_times(moved);
    std::vector<float> values;
    for (const double time : times) {
      glm::dquat mean(0, 0, 0, 0);
      for (const HumanBone eye : eyes) {
        const glm::dquat turn = normalised(path_of(eye), time);
        mean = mean + (turn.w < 0 ? -turn : turn);
      }
      add_quaternion(document::unit_rotation(mean), true, values);
    }
    place /= static_cast<double>(eyes.size());
    const auto head = humanoid_.joint(HumanBone::head);
    if (head) place -= to_front_ * rest_[*head].position;
    const std::size_t node = add_node("lookAt", {0, 0, 0}, std::nullopt);
    own_["lookAt"] = {{"node", node}, {"offsetFromHeadBone", numbers(place)}};
    add_keys(times, Interpolation::linear, values, "VEC4", node, "rotation");
  }

  [[nodiscard]] std::vector<Column> columns() const {
    const std::size_t weights = document::weight_count(model_);
    std::vector<Column> columns;
    std::vector<bool> covered(weights, false);
    for (const document::Expression& one : model_.expressions) {
      Column column{one.name, one.values, false, 0, {}};
      std::erase_if(column.values, [&](const auto& value) { return value.first >= weights; });
      // Where eyes look is the gaze.
      const std::string_view preset = document::preset_of(one.name);
      if (column.values.empty() || preset.starts_with("look")) continue;
      for (const auto& value : column.values) covered[value.first] = true;
      columns.push_back(std::move(column));
    }
    // Those of few targets come first: a blink of one eye before that of both.
    std::stable_sort(columns.begin(), columns.end(),
                     [](const Column& a, const Column& b) { return a.values.size() < b.values.size(); });
    for (std::size_t i = 0; i < weights; ++i) {
      if (!covered[i]) columns.push_back({model_.rig->parameters()[i].name, {{i, 1.0}}, true, 0, {}});
    }
    for (Column& column : columns) {
      for (const auto& value : column.values) column.square += value.second * value.second;
    }
    std::erase_if(columns, [](const Column& column) { return !(column.square > 1e-12); });
    return columns;
  }

  /// The weights within 0..1 whose sum of targets is nearest to what is left of it, by coordinate descent from 0.
  static void fit(std::vector<Column>& columns, std::vector<double>& left) {
    constexpr int k_rounds = 24;
    std::vector<double> weights(columns.size(), 0.0);
    for (int round = 0; round < k_rounds; ++round) {
      double moved = 0;
      for (std::size_t c = 0; c < columns.size(); ++c) {
        double product = 0;
        for (const auto& [target, value] : columns[c].values) product += value * left[target];
        const double next = std::clamp(weights[c] + product / columns[c].square, 0.0, 1.0);
        const double step = next - weights[c];
        if (step == 0) continue;
        for (const auto& [target, value] : columns[c].values) left[target] -= step * value;
        weights[c] = next;
        moved = std::max(moved, std::abs(step));
      }
      if (moved < 1e-7) break;
    }
    for (std::size_t c = 0; c < columns.size(); ++c) columns[c].weights.push_back(static_cast<float>(weights[c]));
  }

  base::Status write_expressions() {
    const std::size_t width = document::weight_count(model_);
    if (width == 0) return base::Done{};
    std::vector<const Channel*> moved;
    for (std::size_t c = 0; animation_ != nullptr && c < animation_->channels.size(); ++c) {
      const Channel& channel = animation_->channels[c];
      if (channel.target == ChannelTarget::weights && !channel.times_s.empty()) moved.push_back(&channel);
    }
    if (moved.size() > 1) moved.resize(1);
    const std::vector<double> times = moved.empty() ? std::vector<double>{0.0} : key_times(moved);
    std::vector<Column> all = columns();
    std::size_t cost = width;
    for (const Column& column : all) cost += column.values.size();
    if (times.size() > k_most_numbers / cost) {
      return base::Error{"the animation has more keys than a VRM animation can be made of", "",
                         "make it shorter, or its frame rate lower"};
    }
    std::vector<double> worst(width, 0.0);
    for (const double time : times) {
      std::vector<double> left;
      if (!moved.empty()) left = document::sample_channel(*moved.front(), width, time);
      if (left.size() != width)
        left.assign(model_.pose.begin(), model_.pose.begin() + static_cast<std::ptrdiff_t>(width));
      fit(all, left);
      for (std::size_t i = 0; i < width; ++i) worst[i] = std::max(worst[i], std::abs(left[i]));
    }
    note_worst(worst);
    const bool steps = !moved.empty() && moved.front()->interpolation == Interpolation::step;
    for (const Column& column : all) write_column(column, times, steps ? Interpolation::step : Interpolation::linear);
    return base::Done{};
  }

  void write_column(const Column& column, const std::vector<double>& times, Interpolation interpolation) {
    const bool shown = std::any_of(column.weights.begin(), column.weights.end(),
                                   [](float weight) { return static_cast<double>(weight) > k_no_weight; });
    if (!shown) return;
    std::string name(document::preset_of(column.name));
    // Controls keep their names, by which they are found again.
    if (column.control && name != column.name) name.clear();
    const char* group = name.empty() ? "custom" : "preset";
    if (name.empty()) name = column.name;
    json::Json& members = own_["expressions"][group];
    if (members.contains(name)) {
      notes_.push_back("expression " + column.name + " is left out: another is \"" + name + "\" in VRM");
      return;
    }
    const std::size_t node = add_node(name, {0, 0, 0}, std::nullopt);
    members[name] = {{"node", node}};
    std::vector<float> values;
    for (const float weight : column.weights) values.insert(values.end(), {weight, 0.0F, 0.0F});
    add_keys(times, interpolation, values, "VEC3", node, "translation");
  }

  void note_worst(const std::vector<double>& worst) {
    std::size_t count = 0;
    std::size_t most = 0;
    for (std::size_t i = 0; i < worst.size(); ++i) {
      count += worst[i] > 0.01 ? 1 : 0;
      if (worst[i] > worst[most]) most = i;
    }
    if (count == 0) return;
    notes_.push_back("the weights of " + std::to_string(count) +
                     " controls are no sum of expressions; the farthest off is " + model_.rig->parameters()[most].name +
                     ", by " + base::format_fixed(worst[most], 2));
  }

  void note_left_out() {
    std::size_t count = 0;
    for (std::size_t j = 0; j < turns_.size(); ++j) {
      if (turns_[j] != nullptr && !used_.contains(j)) ++count;
    }
    if (count > 0) {
      notes_.push_back(std::to_string(count) + " animated joints are no bones of a human figure and are left out");
    }
  }

  const document::Model& model_;
  const document::Animation* animation_;
  document::Humanoid humanoid_;
  glm::dquat to_front_;  ///< from where the model looks to +z
  std::vector<document::RestJoint> rest_;
  std::vector<glm::dquat> pose_of_;                  ///< local rotations in the model's pose
  std::vector<const Channel*> turns_;                ///< one a joint, or null
  std::vector<const Channel*> shifts_;               ///< the same
  std::set<std::size_t> used_;                       ///< joints whose turn is part of a bone's
  std::vector<std::optional<std::size_t>> node_of_;  ///< one a bone
  std::vector<json::Json> nodes_;
  std::vector<std::size_t> scene_;
  std::map<std::vector<float>, std::size_t> inputs_;
  json::Json own_;
  json::Json channels_ = json::Json::array();
  json::Json samplers_ = json::Json::array();
  std::vector<std::string> notes_;
  GltfBuilder builder_;
};

}  // namespace

base::Result<VrmaFile> write_vrma(const document::Model& model, const document::Humanoid& known) {
  return VrmaWriter(model, known).write();
}

ModelFormat vrma_format_of_models() {
  return {.name = "VRM animation",
          .extension = ".vrma",
          .write = [](const document::Model& model, const WriteOptions& options,
                      WriteReport& report) -> ModelFormat::Written {
            auto file = write_vrma(model, options.humanoid);
            if (!file) return file.error();
            report.notes = std::move(file->notes);
            return std::move(file->bytes);
          },
          .holds = "The motion alone",
          .detail = "Bones and expressions over time, for any VRM avatar"};
}

}  // namespace penpose::io
