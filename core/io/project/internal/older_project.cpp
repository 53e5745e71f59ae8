#include "core/io/project/internal/older_project.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/base/json/json_value.h"

namespace penpose::io {
namespace {

/// Where the parameters of the model are among those of the file, and the other way round; nothing: nowhere.
using Places = std::vector<std::optional<std::size_t>>;

struct Order {
  Places from;  ///< one a parameter of the model
  Places to;    ///< one a parameter of the file
  std::span<const rig::Parameter> parameters;
};

Order order_of(const std::vector<std::string>& of_file, std::span<const rig::Parameter> parameters) {
  Order order{Places(parameters.size()), Places(of_file.size()), parameters};
  for (std::size_t i = 0; i < of_file.size(); ++i) {
    const auto found = rig::find_parameter(parameters, of_file[i]);
    if (!found || order.from[*found]) continue;
    order.from[*found] = i;
    order.to[i] = found;
  }
  return order;
}

json::Json reordered_pose(const json::Json& pose, const Order& order) {
  if (!pose.is_array() || pose.size() != order.to.size()) return pose;
  json::Json out = json::Json::array();
  for (std::size_t p = 0; p < order.from.size(); ++p) {
    if (const auto from = order.from[p]) {
      out.push_back(pose[*from]);
    } else {
      out.push_back(order.parameters[p].rest);
    }
  }
  return out;
}

json::Json reordered_controls(const json::Json& controls, const Order& order) {
  if (!controls.is_array()) return controls;
  json::Json out = json::Json::array();
  for (std::size_t i = 0; i < controls.size(); ++i) {
    const json::Json& one = controls[i];
    const auto number = one.is_array() && one.size() > 0
                            ? json::whole_number(one[0], 0, static_cast<std::int64_t>(order.to.size()) - 1)
                            : std::nullopt;
    if (!number) return controls;
    const auto to = order.to[static_cast<std::size_t>(*number)];
    if (!to) continue;
    json::Json moved = json::Json::array();
    moved.push_back(*to);
    for (std::size_t k = 1; k < one.size(); ++k) moved.push_back(one[k]);
    out.push_back(std::move(moved));
  }
  return out;
}

/// Every control of a key is of that kind.
json::Json all_of(const json::Json& kind, std::size_t controls) {
  json::Json out = json::Json::array();
  for (std::size_t i = 0; i < controls; ++i) {
    json::Json one = json::Json::array();
    one.push_back(i);
    one.push_back(kind);
    out.push_back(std::move(one));
  }
  return out;
}

json::Json todays_timeline(const json::Json& timeline, const std::vector<std::string>& of_file, const Order& order) {
  const json::Json* keys = json::find(timeline, "keys");
  if (keys == nullptr || !keys->is_array()) return timeline;
  const json::Json* kind = json::find(timeline, "interpolation");
  json::Json out = json::Json::array();
  for (std::size_t i = 0; i < keys->size(); ++i) {
    json::Json key = (*keys)[i];
    const json::Json* pose = json::find((*keys)[i], "pose");
    const json::Json* controls = json::find((*keys)[i], "controls");
    const bool of_kind = kind != nullptr && *kind == "linear" && pose != nullptr && pose->is_array();
    if (of_kind && controls == nullptr) key["controls"] = all_of(*kind, pose->size());
    if (!of_file.empty() && pose != nullptr) key["pose"] = reordered_pose(*pose, order);
    if (!of_file.empty() && json::find(key, "controls") != nullptr)
      key["controls"] = reordered_controls(*json::find(key, "controls"), order);
    out.push_back(std::move(key));
  }
  json::Json made = timeline;
  made["keys"] = std::move(out);
  return made;
}

}  // namespace

json::Json todays_project(const json::Json& project, const std::vector<std::string>& of_file,
                          std::span<const rig::Parameter> parameters) {
  const json::Json* timeline = json::find(project, "timeline");
  const bool one_kind = timeline != nullptr && json::find(*timeline, "interpolation") != nullptr;
  if (of_file.empty() && !one_kind) return project;
  const Order order = order_of(of_file, parameters);
  json::Json made = project;
  if (timeline != nullptr) made["timeline"] = todays_timeline(*timeline, of_file, order);
  const json::Json* clips = json::find(project, "clips");
  if (clips == nullptr || !clips->is_array()) return made;
  json::Json list = json::Json::array();
  for (std::size_t i = 0; i < clips->size(); ++i) {
    json::Json clip = (*clips)[i];
    if (const json::Json* keys = json::find((*clips)[i], "timeline"))
      clip["timeline"] = todays_timeline(*keys, of_file, order);
    list.push_back(std::move(clip));
  }
  made["clips"] = std::move(list);
  return made;
}

}  // namespace penpose::io
