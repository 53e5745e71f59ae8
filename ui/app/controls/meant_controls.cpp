#include "ui/app/controls/meant_controls.h"

#include <set>

namespace penpose::app {
namespace {

/// "smile, left", "smile, left and jaw opens", "smile, left and 3 more".
std::string words_of_some(EditingSession& editing, const std::vector<std::string>& names) {
  if (names.empty()) return {};
  std::string words = editing.words_of(names.front());
  if (names.size() == 2) words += " and " + editing.words_of(names.back());
  if (names.size() > 2) words += " and " + std::to_string(names.size() - 1) + " more";
  return words;
}

}  // namespace

MeantControls meant_controls(EditingSession& editing, Keys& keys, const Controls& controls) {
  MeantControls meant;
  const auto parameters = editing.document().model->rig->parameters();
  std::set<std::size_t> selected;
  for (const KeySelection::Key& key : keys.selected().keys()) selected.insert(key.second);
  for (const std::size_t number : selected) meant.names.push_back(parameters[number].name);
  if (meant.names.empty() && !controls.shown().empty()) meant.names = {controls.shown()};
  if (meant.names.empty()) {
    for (const Movement& one : editing.last_stroke().movements()) meant.names.push_back(one.name);
  }
  meant.words = words_of_some(editing, meant.names);
  return meant;
}

MeantControls controls_of_part(EditingSession& editing, ControlParts& parts, FacePart part) {
  MeantControls meant{{}, words_of_part(part)};
  const document::Document& document = editing.document();
  const auto& all = parts.of(document, editing.features());
  const auto parameters = document.model->rig->parameters();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (all[i] == part) meant.names.push_back(parameters[i].name);
  }
  return meant;
}

std::string words_of_part(FacePart part) {
  switch (part) {
    case FacePart::brows:
      return "the brows";
    case FacePart::eyes:
      return "the eyes";
    case FacePart::mouth:
      return "the mouth";
    default:
      return {};
  }
}

}  // namespace penpose::app
