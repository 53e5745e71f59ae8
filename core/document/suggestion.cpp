#include "core/document/suggestion.h"

#include <algorithm>
#include <cmath>

#include "core/document/commands/apply.h"
#include "core/prior/leave_one_out.h"

namespace penpose::document {
namespace {

constexpr double k_same_share = 1e-9;

/// The keys that can be learned from: a pose as it stands says nothing new about itself, though it may be keyed.
std::vector<rig::Pose> other_keys(const Document& document, std::span<const PoseKey> keys) {
  std::vector<rig::Pose> poses;
  for (const PoseKey& key : keys) {
    if (key.pose != SharedPose(document.pose)) poses.push_back(key.pose);
  }
  return poses;
}

base::Result<prior::PosePrior> learned(const Document& document, const std::vector<rig::Pose>& poses, std::size_t all) {
  auto prior = prior::learn(document.model->rig->parameters(), poses);
  if (prior || poses.size() == all) return prior;
  base::Error error = prior.error();
  error.what += ", beside the pose as it stands";
  return error;
}

/// How far each parameter can move the points of a curve: the farthest that one goes between the ends of the range.
std::vector<double> says_in(const Document& document, const PoseCurve& curve) {
  const auto triangles = document.model->mesh->triangles();
  std::vector<std::uint32_t> vertices;
  for (const mesh::MeshPoint& point : curve.points) {
    const mesh::Triangle& corners = triangles[point.triangle];
    vertices.insert(vertices.end(), corners.begin(), corners.end());
  }
  const auto parameters = document.model->rig->parameters();
  const auto bound = document.model->rig->bind(vertices);
  std::vector<geometry::ModelPoint> least(vertices.size());
  std::vector<geometry::ModelPoint> most(vertices.size());
  std::vector<double> says(parameters.size(), 0.0);
  rig::Pose pose = document.pose;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!bound->moves(i)) continue;
    pose[i] = parameters[i].minimum;
    bound->evaluate(pose, least);
    pose[i] = parameters[i].maximum;
    bound->evaluate(pose, most);
    pose[i] = document.pose[i];
    for (std::size_t v = 0; v < vertices.size(); ++v)
      says[i] = std::max(says[i], geometry::distance(least[v], most[v]));
  }
  return says;
}

/// The numbers of the parameters that the command holds, and of those that are locked, ascending.
base::Result<std::vector<std::size_t>> held_by(const Document& document, const std::vector<std::string>& names) {
  const auto parameters = document.model->rig->parameters();
  std::vector<std::size_t> held;
  for (const std::string& name : names) {
    const auto number = rig::find_parameter(parameters, name);
    if (!number) {
      return base::Error{"the model has no parameter \"" + name + "\"", "held", "look at the names in the model"};
    }
    held.push_back(*number);
  }
  if (held.empty()) {
    return base::Error{"nothing is posed yet, so that there is nothing to suggest the rest of", "held",
                       "draw or set a part of the pose first"};
  }
  for (const std::string& name : document.locked) {
    if (const auto number = rig::find_parameter(parameters, name)) held.push_back(*number);
  }
  std::stable_sort(held.begin(), held.end());
  held.erase(std::unique(held.begin(), held.end()), held.end());
  return held;
}

}  // namespace

std::vector<std::string> posed_parameters(const Document& document) {
  const auto parameters = document.model->rig->parameters();
  std::vector<bool> posed(parameters.size(), false);
  const rig::Pose rest = rig::rest_pose(*document.model->rig);
  rig::Pose before = sample(*document.timeline, document.time_s, rest);
  // A pose that was keyed as it stands is as posed as before.
  if (before == document.pose) before = rest;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double hair = k_same_share * (parameters[i].maximum - parameters[i].minimum);
    const auto away = [&](const rig::Pose& from) { return std::abs(document.pose[i] - from[i]) > hair; };
    posed[i] = (away(before) && away(rest)) ||
               std::binary_search(document.locked.begin(), document.locked.end(), parameters[i].name);
  }
  for (const auto& curve : document.curves) {
    if (curve->role == PoseCurveRole::reference && !curve->target) continue;
    const std::vector<double> says = says_in(document, *curve);
    const double most = says.empty() ? 0 : *std::max_element(says.begin(), says.end());
    for (std::size_t i = 0; i < says.size(); ++i) posed[i] = posed[i] || (says[i] > 0 && says[i] >= k_least_say * most);
  }
  std::vector<std::string> names;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (posed[i]) names.push_back(parameters[i].name);
  }
  return names;
}

base::Result<Suggestion> suggest_rest(const Document& document, std::span<const PoseKey> keys,
                                      std::vector<std::string> held, std::optional<double> strength) {
  if (strength && !(*strength >= 0 && *strength <= 1)) {
    return base::Error{"the strength is out of range", "strength", "use 0 to 1"};
  }
  const auto numbers = held_by(document, held);
  if (!numbers) return numbers.error();
  const auto parameters = document.model->rig->parameters();
  const std::vector<rig::Pose> poses = other_keys(document, keys);
  const auto prior = learned(document, poses, keys.size());
  if (!prior) return prior.error();
  if (!strength) strength = prior::trust(*document.model->rig, poses, [&](const rig::Pose&) { return *numbers; });
  auto pose = prior::suggest(*prior, parameters, document.pose, *numbers, *strength);
  if (!pose) return pose.error();
  return Suggestion{{std::move(held), *strength}, std::move(pose).value(), prior->keys, prior->shrinkage};
}

base::Result<Suggestion> suggest_rest(const Document& document) {
  // Asked first: without keys it matters little what is posed.
  if (auto error = no_suggestion(document)) return *error;
  return suggest_rest(document, document.timeline->keys, posed_parameters(document));
}

std::optional<base::Error> no_suggestion(const Document& document) {
  const auto& keys = document.timeline->keys;
  const auto prior = learned(document, other_keys(document, keys), keys.size());
  if (prior) return std::nullopt;
  return prior.error();
}

}  // namespace penpose::document
