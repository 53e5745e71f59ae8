#include "ui/app/canvas/undrawn_textures.h"

#include <algorithm>

#include "core/document/look.h"

namespace penpose::app {

void UndrawnTextures::begin(const document::Model& model) {
  look_ = model.look;
  names_ = look_ ? look_->undrawn : std::vector<std::string>();
  tell();
}

void UndrawnTextures::add(const std::shared_ptr<const document::Look>& look, const std::vector<std::string>& names) {
  if (names.empty() || look != look_) return;
  names_.insert(names_.end(), names.begin(), names.end());
  tell();
}

void UndrawnTextures::tell() {
  notices_.take_away([&](const Notice& one) { return one.text == told_; });
  told_ = document::undrawn_note(names_);
  if (!told_.empty()) notices_.tell(told_);
}

std::vector<std::string> notes_of(const document::Model& model, const UndrawnTextures& undrawn) {
  std::vector<std::string> notes;
  for (const std::string& name : undrawn.names()) notes.push_back("this texture cannot be drawn: " + name);
  const std::string together = model.look ? document::undrawn_note(model.look->undrawn) : std::string();
  for (const std::string& note : model.notes) {
    if (note != together && std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
  }
  return notes;
}

}  // namespace penpose::app
