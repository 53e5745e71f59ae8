#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "core/document/words/control_words.h"
#include "ui/app/controls/control_parts.h"

namespace penpose::app {

/// Under what a control is listed, in the order of the list: parts of the figure, and then what is a sum of many.
enum class ControlGroup : std::uint8_t {
  brows,
  eyes,
  mouth,
  cheeks_and_nose,
  jaw,
  head,
  body,
  others,
  mouth_shapes,  ///< the mouth as it makes a sound
  expressions,   ///< a feeling on all of the face
};
inline constexpr std::size_t k_control_groups = 10;

/// "Brows", "Cheeks and nose".
[[nodiscard]] std::string_view name_of(ControlGroup group);

/// The group that the words of a control say, the earliest word first: "cheek raised and eye narrows" is of the cheeks.
/// `name`: in files, which tells sounds and feelings. Others: they say none.
[[nodiscard]] ControlGroup group_of_words(std::string_view words, std::string_view name);

/// One a parameter: by its words, else by the features that it moves (parts_by_effect); a joint of neither is of the
/// body.
[[nodiscard]] std::vector<ControlGroup> control_groups(const document::Document& document,
                                                       std::span<const document::ControlWords> words,
                                                       std::span<const FacePart> parts);

/// Those of a document, found once for each model.
class ControlGroups {
 public:
  [[nodiscard]] const std::vector<ControlGroup>& of(const document::Document& document,
                                                    std::span<const document::ControlWords> words,
                                                    std::span<const portrait::FeatureCurve> features);

 private:
  std::shared_ptr<const rig::CharacterRig> rig_;
  std::size_t features_ = 0;
  std::vector<ControlGroup> groups_;
};

}  // namespace penpose::app
