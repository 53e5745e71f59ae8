#include "ui/app/controls/control_groups.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/base/text/letters.h"
#include "core/document/words/face_deeds.h"

namespace penpose::app {
namespace {

using enum ControlGroup;

struct GroupWord {
  std::string_view word;
  ControlGroup group;
};
constexpr std::array k_group_words{GroupWord{"brow", brows},
                                   GroupWord{"forehead", brows},
                                   GroupWord{"eye", eyes},
                                   GroupWord{"lid", eyes},
                                   GroupWord{"lash", eyes},
                                   GroupWord{"blink", eyes},
                                   GroupWord{"squint", eyes},
                                   GroupWord{"gaze", eyes},
                                   GroupWord{"look", eyes},
                                   GroupWord{"pupil", eyes},
                                   GroupWord{"iris", eyes},
                                   GroupWord{"wink", eyes},
                                   GroupWord{"mouth", mouth},
                                   GroupWord{"lip", mouth},
                                   GroupWord{"smile", mouth},
                                   GroupWord{"frown", mouth},
                                   GroupWord{"dimple", mouth},
                                   GroupWord{"tongue", mouth},
                                   GroupWord{"teeth", mouth},
                                   GroupWord{"tooth", mouth},
                                   GroupWord{"pucker", mouth},
                                   GroupWord{"funnel", mouth},
                                   GroupWord{"corner", mouth},
                                   GroupWord{"cheek", cheeks_and_nose},
                                   GroupWord{"nose", cheeks_and_nose},
                                   GroupWord{"nostril", cheeks_and_nose},
                                   GroupWord{"sneer", cheeks_and_nose},
                                   GroupWord{"jaw", jaw},
                                   GroupWord{"chin", jaw},
                                   GroupWord{"head", head},
                                   GroupWord{"neck", head},
                                   GroupWord{"ear", head},
                                   GroupWord{"hair", head},
                                   GroupWord{"shoulder", body},
                                   GroupWord{"arm", body},
                                   GroupWord{"elbow", body},
                                   GroupWord{"hand", body},
                                   GroupWord{"wrist", body},
                                   GroupWord{"finger", body},
                                   GroupWord{"thumb", body},
                                   GroupWord{"chest", body},
                                   GroupWord{"spine", body},
                                   GroupWord{"hip", body},
                                   GroupWord{"pelvis", body},
                                   GroupWord{"waist", body},
                                   GroupWord{"torso", body},
                                   GroupWord{"leg", body},
                                   GroupWord{"knee", body},
                                   GroupWord{"foot", body},
                                   GroupWord{"feet", body},
                                   GroupWord{"toe", body},
                                   GroupWord{"tail", body},
                                   GroupWord{"body", body}};

bool is_letter_of_word(char c) { return base::lower(c) >= 'a' && base::lower(c) <= 'z'; }

/// A word as it is, of several of its kind, or of what does it: "lips", "looks".
bool says_word(std::string_view said, std::string_view word) {
  if (said.size() < word.size() || said.size() > word.size() + 1) return false;
  const bool same =
      std::equal(word.begin(), word.end(), said.begin(), [](char a, char b) { return a == base::lower(b); });
  return same && (said.size() == word.size() || base::lower(said.back()) == 's');
}

}  // namespace

std::string_view name_of(ControlGroup group) {
  constexpr std::array<std::string_view, k_control_groups> k_names{
      "Brows", "Eyes", "Mouth", "Cheeks and nose", "Jaw", "Head", "Body", "Others", "Mouth shapes", "Expressions"};
  return k_names[static_cast<std::size_t>(group)];
}

ControlGroup group_of_words(std::string_view words, std::string_view name) {
  if (const std::string said = document::expression_named(name); !said.empty())
    return said.starts_with("mouth: ") ? mouth_shapes : expressions;
  while (!words.empty()) {
    const auto begin =
        static_cast<std::size_t>(std::find_if(words.begin(), words.end(), is_letter_of_word) - words.begin());
    words.remove_prefix(begin);
    const auto end =
        static_cast<std::size_t>(std::find_if_not(words.begin(), words.end(), is_letter_of_word) - words.begin());
    const std::string_view said = words.substr(0, end);
    words.remove_prefix(end);
    const auto found = std::find_if(k_group_words.begin(), k_group_words.end(),
                                    [&](const GroupWord& one) { return says_word(said, one.word); });
    if (found != k_group_words.end()) return found->group;
  }
  return others;
}

std::vector<ControlGroup> control_groups(const document::Document& document,
                                         std::span<const document::ControlWords> words,
                                         std::span<const FacePart> parts) {
  constexpr std::array k_of_part{others, brows, eyes, mouth};
  const auto parameters = document.model->rig->parameters();
  const std::size_t shapes = document::weight_count(*document.model);
  std::vector<ControlGroup> groups;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    ControlGroup group = group_of_words(words[i].what, parameters[i].name);
    if (group == others) group = k_of_part[static_cast<std::size_t>(parts[i])];
    if (group == others && i >= shapes) group = body;
    groups.push_back(group);
  }
  return groups;
}

const std::vector<ControlGroup>& ControlGroups::of(const document::Document& document,
                                                   std::span<const document::ControlWords> words,
                                                   std::span<const portrait::FeatureCurve> features) {
  if (rig_ != document.model->rig || features_ != features.size()) {
    rig_ = document.model->rig;
    features_ = features.size();
    groups_ = control_groups(document, words, parts_by_effect(document, features));
  }
  return groups_;
}

}  // namespace penpose::app
