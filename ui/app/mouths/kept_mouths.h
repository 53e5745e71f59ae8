#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/document/commands/command.h"
#include "ui/app/controls/control_parts.h"
#include "ui/app/notices.h"
#include "ui/app/playback/playback.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// The controls of the mouth, of `parts` (parts_by_effect) and those that kept mouths move; where there are none, those
/// of no part. By their numbers, ascending.
[[nodiscard]] std::vector<std::size_t> mouth_controls(const document::Document& document,
                                                      const std::vector<FacePart>& parts);
/// The mouth as it is now, under a name.
[[nodiscard]] document::SetMouth present_mouth(const document::Document& document,
                                               const std::vector<std::size_t>& controls, const std::string& name);
/// What makes the present mouth that one. Empty: it is.
[[nodiscard]] document::SetParameters values_of_mouth(const document::Document& document,
                                                      const std::vector<std::size_t>& controls,
                                                      const document::Mouth& mouth);

/// The mouths that the artist keeps: taken from the face, drawn again, deleted.
class KeptMouths {
 public:
  KeptMouths(EditingSession& editing, Notices& notices, Playback& playback);

  /// The present mouth becomes the one of that name, and its keys follow.
  void keep(const std::string& name);
  /// Takes the pose of a kept mouth, so that it is drawn from there until it is kept again.
  void redraw(const std::string& name);
  /// The one that is being drawn again.
  [[nodiscard]] const std::string* redrawn() const { return redrawn_ ? &*redrawn_ : nullptr; }
  void remove(const std::string& name);
  /// Another document was opened: none is being drawn again.
  void forget() { redrawn_.reset(); }
  /// Keeps those that the model's own controls make and that are not there yet (speech::usual_mouths), in one step.
  void keep_usual();
  /// Some of them are not there yet.
  [[nodiscard]] bool offers_usual();

  /// The pose of a mouth on the face at rest.
  [[nodiscard]] rig::Pose pose_of(const document::Mouth& mouth) const;
  /// How many keys speak it.
  [[nodiscard]] std::size_t keys_of(const std::string& name) const;

 private:
  [[nodiscard]] std::vector<std::size_t> controls();
  [[nodiscard]] const std::vector<document::Mouth>& usual();

  EditingSession& editing_;
  Notices& notices_;
  Playback& playback_;
  ControlParts parts_;
  std::optional<std::string> redrawn_;
  std::shared_ptr<const document::Model> usual_of_;
  std::vector<document::Mouth> usual_;
};

}  // namespace penpose::app
