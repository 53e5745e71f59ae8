#include "core/io/tracks/arkit/write_arkit.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/math.h"
#include "core/base/numbers.h"
#include "core/document/time/animation_sampling.h"
#include "core/document/time/head_joints.h"
#include "core/geometry/rotation.h"
#include "core/io/model/model_formats.h"
#include "core/io/tracks/arkit/arkit_names.h"
#include "core/io/tracks/arkit/timecode.h"
#include "core/rig/control_names.h"

namespace penpose::io {
namespace {

/// The controls that a column is the mean of, and how far they were from it at most.
struct ArkitColumn {
  std::vector<std::size_t> controls;
  double apart = 0;
};

std::vector<ArkitColumn> find_columns(std::span<const rig::Parameter> parameters) {
  std::vector<ArkitColumn> columns;
  for (const char* name : k_arkit_shapes) columns.push_back({rig::controls_named(parameters, name)});
  return columns;
}

double value_of(ArkitColumn& column, const std::vector<double>& weights) {
  if (column.controls.empty()) return 0;
  double sum = 0;
  for (const std::size_t i : column.controls) sum += weights[i];
  const double mean = sum / static_cast<double>(column.controls.size());
  for (const std::size_t i : column.controls) column.apart = std::max(column.apart, std::abs(weights[i] - mean));
  return mean;
}

/// The joint that carries the head, or else the first root.
std::optional<std::uint32_t> head_joint(const document::Model& model) {
  if (!model.skeleton || model.skeleton->joints().empty()) return std::nullopt;
  if (const auto found = document::head_joints(model)) return found->head;
  const auto joints = model.skeleton->joints();
  const auto named = [](const rig::Joint& joint) { return rig::folded_name(joint.name) == "head"; };
  const auto found = std::find_if(joints.begin(), joints.end(), named);
  return found != joints.end() ? static_cast<std::uint32_t>(found - joints.begin()) : 0U;
}

/// Joints as the model's pose turns them.
std::vector<document::JointTransform> posed_joints(const document::Model& model) {
  std::vector<document::JointTransform> joints;
  std::size_t parameter = document::weight_count(model);
  for (const rig::Joint& joint : model.skeleton->joints()) {
    glm::dquat rotation = joint.rest_rotation;
    if (joint.posable) {
      const double* angles = &model.pose[parameter];
      rotation = rotation * geometry::quaternion_from_xyz({angles[0], angles[1], angles[2]});
      parameter += 3;
    }
    joints.push_back({joint.translation, rotation, joint.scale});
  }
  return joints;
}

/// About the axes of a face that looks along +z.
glm::dvec3 turn_of(const document::Model& model, std::uint32_t head, std::span<const document::JointTransform> joints) {
  glm::dquat turn = document::turn_from_rest(model, head, joints);
  if (model.front_yaw_degrees != 0) {
    const glm::dquat front = geometry::quaternion_from_xyz({0, base::radians(model.front_yaw_degrees), 0});
    turn = glm::conjugate(front) * turn * front;
  }
  return geometry::xyz_from_quaternion(turn);
}

std::string list_of(const std::vector<std::string>& names) {
  constexpr std::size_t k_most = 20;
  std::string text;
  for (std::size_t i = 0; i < std::min(k_most, names.size()); ++i) {
    if (i > 0) text += ", ";
    text += names[i];
  }
  if (names.size() > k_most) text += " and " + std::to_string(names.size() - k_most) + " more";
  return text;
}

std::vector<std::string> notes_on(std::span<const rig::Parameter> parameters, const std::vector<ArkitColumn>& columns) {
  std::vector<bool> written(parameters.size());
  std::vector<std::string> notes;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    std::vector<std::string> names;
    for (const std::size_t i : columns[c].controls) {
      written[i] = true;
      names.push_back(parameters[i].name);
    }
    if (columns[c].apart < 0.01) continue;
    notes.push_back(std::string(k_arkit_shapes[c]) + " is the mean of " + list_of(names) + ", which are up to " +
                    base::format_fixed(columns[c].apart, 2) + " off it");
  }
  std::vector<std::string> left_out;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!written[i]) left_out.push_back(parameters[i].name);
  }
  if (!left_out.empty()) notes.push_back("ARKit has no shape for " + list_of(left_out) + "; left out");
  return notes;
}

}  // namespace

base::Result<ArkitText> write_arkit(const document::Model& model, double fps) {
  const std::size_t weights = document::weight_count(model);
  const auto parameters = std::span(model.rig->parameters()).first(weights);
  auto columns = find_columns(parameters);
  if (weights == 0) {
    return base::Error{"the model has no blend shape or deformer", "", "give a model with ARKit's blend shapes"};
  }
  const auto has_control = [](const ArkitColumn& column) { return !column.controls.empty(); };
  if (std::none_of(columns.begin(), columns.end(), has_control)) {
    return base::Error{
        "none of the model's " + std::to_string(weights) + " blend shapes and deformers has a name of ARKit", "",
        "name them as ARKit does, such as jawOpen, or write .glb to keep the animation"};
  }
  const bool moves = !model.animations.empty();
  const double last = moves ? std::round(document::duration_s(model.animations.front()) * fps) : 0;
  if (!(last < 1e6)) return base::Error{"the animation has over 1,000,000 frames", "", "choose a lower frame rate"};
  ArkitText result;
  std::string& text = result.text;
  text = "Timecode,BlendShapeCount";
  for (const char* name : k_arkit_shapes) text.append(",").append(name);
  for (const char* name : k_arkit_turns) text.append(",").append(name);
  text += '\n';
  const std::string count = std::to_string(k_arkit_shapes.size() + k_arkit_turns.size());
  const auto head = head_joint(model);
  for (std::size_t f = 0; f <= static_cast<std::size_t>(last); ++f) {
    const double time = static_cast<double>(f) / fps;
    std::vector<double> values(model.pose.begin(), model.pose.begin() + static_cast<std::ptrdiff_t>(weights));
    glm::dvec3 turn = head && !moves ? turn_of(model, *head, posed_joints(model)) : glm::dvec3(0);
    if (moves) {
      const auto moment = document::sample(model, model.animations.front(), time);
      if (moment.weights.size() == weights) values = moment.weights;
      if (head) turn = turn_of(model, *head, moment.joints);
    }
    text += format_timecode(time, timecode_count(fps));
    text += ',';
    text += count;
    for (ArkitColumn& column : columns) {
      text += ',';
      text += base::format_double(value_of(column, values));
    }
    // Yaw is about y, pitch about x, roll about z.
    for (const double angle : {turn.y, turn.x, turn.z}) {
      text += ',';
      text += base::format_float(static_cast<float>(angle));
    }
    text += ",0,0,0,0,0,0\n";
  }
  result.notes = notes_on(parameters, columns);
  return result;
}

ModelFormat arkit_format_of_models() {
  return {.name = "ARKit CSV",
          .extension = ".csv",
          .write = [](const document::Model& model, const WriteOptions& options,
                      WriteReport& report) -> ModelFormat::Written {
            auto take = write_arkit(model, options.fps);
            if (!take) return take.error();
            report.notes = std::move(take->notes);
            return std::vector<std::uint8_t>(take->text.begin(), take->text.end());
          },
          .holds = "Blend shapes over time",
          .detail = "As Live Link Face writes them, for programs that play such takes"};
}

}  // namespace penpose::io
