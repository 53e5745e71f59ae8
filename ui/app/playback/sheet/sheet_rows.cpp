#include "ui/app/playback/sheet/sheet_rows.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/document/words/readable_name.h"

namespace penpose::app {
namespace {

/// For each joint, the one that its run begins with: where more than one child that has children of its own hangs on a
/// joint, each begins a run. A limb, the spine or a finger is one.
std::vector<std::size_t> runs_of(const rig::Skeleton& skeleton) {
  const auto joints = skeleton.joints();
  std::vector<bool> inner(joints.size());
  std::vector<std::size_t> inner_children(joints.size());
  for (std::size_t j = joints.size(); j-- > 0;) {
    if (joints[j].parent < 0) continue;
    const auto parent = static_cast<std::size_t>(joints[j].parent);
    inner[parent] = true;
    inner_children[parent] += inner[j] ? 1 : 0;
  }
  std::vector<std::size_t> runs(joints.size());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const std::int32_t parent = joints[j].parent;
    const bool begins = parent < 0 || (inner[j] && inner_children[static_cast<std::size_t>(parent)] > 1);
    runs[j] = begins ? j : runs[static_cast<std::size_t>(parent)];
  }
  return runs;
}

}  // namespace

std::vector<SheetRow> sheet_rows(const document::Document& document, std::span<const FacePart> parts,
                                 std::span<const document::ControlWords> words, const std::set<std::string>& folded,
                                 bool all) {
  const auto parameters = document.model->rig->parameters();
  const auto& keys = document.timeline->keys;
  const auto listed = [&](std::size_t control) {
    return std::any_of(keys.begin(), keys.end(), [&](const document::PoseKey& key) {
      return key.controls.has(control) && (all || key.pose[control] != parameters[control].rest);
    });
  };
  constexpr std::array<std::pair<FacePart, const char*>, 4> k_groups{
      {{FacePart::brows, "Brows"}, {FacePart::eyes, "Eyes"}, {FacePart::mouth, "Mouth"}, {FacePart::all, "Others"}}};
  std::vector<SheetRow> groups;
  for (const auto& [part, name] : k_groups) groups.push_back({name, name, true, false, {}});
  std::vector<std::size_t> joint_groups;  // by the first joint of a run; 0: none yet
  std::vector<std::size_t> runs;
  const auto& skeleton = document.model->skeleton;
  const std::size_t turns = skeleton ? document::weight_count(*document.model) : parameters.size();
  if (skeleton) {
    runs = runs_of(*skeleton);
    joint_groups.resize(runs.size());
  }
  for (std::size_t i = 0; i < parameters.size() && i < parts.size(); ++i) {
    if (!listed(i)) continue;
    std::size_t group = 0;
    while (k_groups[group].first != parts[i]) ++group;
    if (parts[i] == FacePart::all && i >= turns) {
      const std::size_t first = runs[skeleton->joint_of(i - turns)];
      if (joint_groups[first] == 0) {
        joint_groups[first] = groups.size();
        const std::string& name = skeleton->joints()[first].name;
        groups.push_back({name, document::readable_name(name).text(), true, false, {}});
      }
      group = joint_groups[first];
    }
    groups[group].controls.push_back(i);
  }
  std::vector<SheetRow> rows;
  for (SheetRow& group : groups) {
    if (group.controls.empty()) continue;
    group.folded = folded.count(group.name) > 0;
    rows.push_back(group);
    if (group.folded) continue;
    for (const std::size_t control : group.controls)
      rows.push_back({parameters[control].name, words[control].text(), false, false, {control}});
  }
  return rows;
}

}  // namespace penpose::app
