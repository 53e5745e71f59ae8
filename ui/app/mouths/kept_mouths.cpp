#include "ui/app/mouths/kept_mouths.h"

#include <algorithm>
#include <utility>

#include "core/speech/usual_mouths.h"

namespace penpose::app {
namespace {

std::string keys_follow(std::size_t keys) {
  if (keys == 0) return {};
  return keys == 1 ? "; its key follows" : "; its " + std::to_string(keys) + " keys follow";
}

}  // namespace

std::vector<std::size_t> mouth_controls(const document::Document& document, const std::vector<FacePart>& parts) {
  const auto parameters = document.model->rig->parameters();
  std::vector<bool> of_mouth(parameters.size());
  for (std::size_t i = 0; i < parameters.size(); ++i) of_mouth[i] = i < parts.size() && parts[i] == FacePart::mouth;
  for (const auto& mouth : document.mouths) {
    for (const auto& one : mouth->values) {
      if (const auto number = rig::find_parameter(parameters, one.name)) of_mouth[*number] = true;
    }
  }
  const bool any = std::find(of_mouth.begin(), of_mouth.end(), true) != of_mouth.end();
  std::vector<std::size_t> controls;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (of_mouth[i] || (!any && (i >= parts.size() || parts[i] == FacePart::all))) controls.push_back(i);
  }
  return controls;
}

document::SetMouth present_mouth(const document::Document& document, const std::vector<std::size_t>& controls,
                                 const std::string& name) {
  const auto parameters = document.model->rig->parameters();
  document::SetMouth command{name, {}};
  for (const std::size_t i : controls) {
    if (document.pose[i] != parameters[i].rest) command.values.push_back({parameters[i].name, document.pose[i]});
  }
  return command;
}

document::SetParameters values_of_mouth(const document::Document& document, const std::vector<std::size_t>& controls,
                                        const document::Mouth& mouth) {
  const auto parameters = document.model->rig->parameters();
  const auto values = document::values_of(mouth, controls, parameters);
  document::SetParameters command;
  for (std::size_t i = 0; i < controls.size(); ++i) {
    if (document.pose[controls[i]] != values[i]) command.values.push_back({parameters[controls[i]].name, values[i]});
  }
  return command;
}

KeptMouths::KeptMouths(EditingSession& editing, Notices& notices, Playback& playback)
    : editing_(editing), notices_(notices), playback_(playback) {}

std::vector<std::size_t> KeptMouths::controls() {
  const auto features = editing_.features();
  return mouth_controls(editing_.document(), parts_.of(editing_.document(), features));
}

void KeptMouths::keep(const std::string& name) {
  const auto command = present_mouth(editing_.document(), controls(), name);
  if (!editing_.perform(command)) return;
  const std::size_t keys = keys_of(name);
  notices_.tell("the mouth \"" + name + "\" is kept" + keys_follow(keys));
  const bool again = redrawn_ == name;
  redrawn_.reset();
  // What was spoken before goes on where it was.
  if (again && editing_.document().spoken) editing_.perform_with(document::GoToTime{playback_.time_s()});
}

void KeptMouths::redraw(const std::string& name) {
  const document::Mouth* mouth = document::find_mouth(editing_.document().mouths, name);
  if (mouth == nullptr) return;
  const auto command = values_of_mouth(editing_.document(), controls(), *mouth);
  if (!command.values.empty() && !editing_.perform(command)) return;
  redrawn_ = name;
}

void KeptMouths::remove(const std::string& name) {
  if (redrawn_ == name) redrawn_.reset();
  editing_.perform(document::DeleteMouth{{name}});
}

const std::vector<document::Mouth>& KeptMouths::usual() {
  const auto& model = editing_.document().model;
  if (usual_of_ != model) {
    usual_of_ = model;
    usual_ = speech::usual_mouths(*model);
  }
  return usual_;
}

bool KeptMouths::offers_usual() {
  const auto& all = usual();
  return std::any_of(all.begin(), all.end(), [&](const document::Mouth& one) {
    return document::find_mouth(editing_.document().mouths, one.name) == nullptr;
  });
}

void KeptMouths::keep_usual() {
  bool first = true;
  std::size_t kept = 0;
  for (const document::Mouth& one : usual()) {
    if (document::find_mouth(editing_.document().mouths, one.name) != nullptr) continue;
    const document::SetMouth command{one.name, one.values};
    if (!(std::exchange(first, false) ? editing_.perform(command) : editing_.perform_with(command))) return;
    ++kept;
  }
  notices_.tell(std::to_string(kept) +
                " mouths are kept, made by the model's own controls: redraw those you want other");
}

rig::Pose KeptMouths::pose_of(const document::Mouth& mouth) const {
  const rig::Rig& rig = *editing_.document().model->rig;
  rig::Pose pose = rig::rest_pose(rig);
  for (const auto& one : mouth.values) {
    if (const auto number = rig::find_parameter(rig.parameters(), one.name)) pose[*number] = one.value;
  }
  return pose;
}

std::size_t KeptMouths::keys_of(const std::string& name) const {
  const auto& spoken = editing_.document().spoken;
  if (!spoken) return 0;
  return static_cast<std::size_t>(
      std::count_if(spoken->begin(), spoken->end(), [&](const auto& one) { return one.mouth == name; }));
}

}  // namespace penpose::app
