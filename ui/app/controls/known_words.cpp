#include "ui/app/controls/known_words.h"

#include <algorithm>

namespace penpose::app {

bool KnownWords::are_of(const document::Model& model) {
  if (rig_ == model.rig) return true;
  const auto parameters = model.rig->parameters();
  // What a sketched control does is said by its name.
  const bool same = rig_ && mesh_ == model.mesh && shapes_ == model.shapes && skeleton_ == model.skeleton &&
                    std::equal(parameters.begin(), parameters.end(), names_.begin(), names_.end(),
                               [](const rig::Parameter& one, const std::string& name) { return one.name == name; });
  if (same) rig_ = model.rig;
  return same;
}

const std::vector<document::ControlWords>& KnownWords::of(const document::Model& model,
                                                          const std::function<const intent::WholeModel&()>& whole,
                                                          const Features& features) {
  if (are_of(model)) return words_;
  words_ = document::control_words(model, whole(), features());
  rig_ = model.rig;
  mesh_ = model.mesh;
  shapes_ = model.shapes;
  skeleton_ = model.skeleton;
  names_.clear();
  for (const rig::Parameter& one : rig_->parameters()) names_.push_back(one.name);
  return words_;
}

std::string words_of_pair(const document::ControlWords& left, const document::ControlWords& right) {
  return left.what == right.what ? left.what : left.text() + " / " + right.text();
}

std::string tip_of_control(const document::ControlWords& words, const std::string& name) {
  return words.below.empty() ? name : name + "; below rest: " + words.below;
}

}  // namespace penpose::app
