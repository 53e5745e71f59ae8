#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/document/words/control_words.h"

namespace penpose::app {

/// What the controls of a document do, in words, measured once for its shapes, joints and names.
class KnownWords {
 public:
  using Features = std::function<std::span<const portrait::FeatureCurve>()>;
  /// One a parameter. `whole` and `features` are asked for where they are not known.
  [[nodiscard]] const std::vector<document::ControlWords>& of(const document::Model& model,
                                                              const std::function<const intent::WholeModel&()>& whole,
                                                              const Features& features);

 private:
  [[nodiscard]] bool are_of(const document::Model& model);

  std::shared_ptr<const rig::CharacterRig> rig_;
  std::shared_ptr<const mesh::TriangleMesh> mesh_;
  std::shared_ptr<const rig::BlendShapes> shapes_;
  std::shared_ptr<const rig::Skeleton> skeleton_;
  std::vector<std::string> names_;
  std::vector<document::ControlWords> words_;
};

/// Of two that are a pair: what both do, without sides; "jaw left / jaw right" where they do not do the same.
[[nodiscard]] std::string words_of_pair(const document::ControlWords& left, const document::ControlWords& right);
/// What else there is to say of a control: its name in files, and what it does below its rest.
[[nodiscard]] std::string tip_of_control(const document::ControlWords& words, const std::string& name);

}  // namespace penpose::app
