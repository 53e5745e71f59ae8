#include "ui/app/dialogs/found_command.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"
#include "ui/app/playback/frames.h"

namespace penpose::app {
namespace {

using FoundKind = FoundCommand::Kind;

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : base::lower_case(text) + " ") {
    if (c != ' ') {
      word += c;
    } else if (!word.empty()) {
      words.push_back(std::exchange(word, {}));
    }
  }
  return words;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

/// How well a name says the words: 0 not at all; a name that begins with one is best, then a word in it that does.
int fits(std::string_view name, std::string_view besides, const std::vector<std::string>& words) {
  if (words.empty()) return 1;
  const std::string in_name = base::lower_case(name);
  const std::string in_rest = base::lower_case(besides);
  int total = 0;
  for (const std::string& word : words) {
    const std::size_t at = in_name.find(word);
    const bool begins =
        at != std::string::npos && at > 0 && (!is_letter(name[at - 1]) || (name[at] < 'a' && name[at - 1] >= 'a'));
    const int fit = at == 0                                   ? 4
                    : begins                                  ? 3
                    : at != std::string::npos                 ? 2
                    : in_rest.find(word) != std::string::npos ? 1
                                                              : 0;
    if (fit == 0) return 0;
    total += fit;
  }
  return total;
}

struct OtherWords {
  std::string_view label;
  std::string_view words;
};
/// What else people call it.
constexpr std::array k_other_words{OtherWords{"Sound", "audio music voice wav speech"},
                                   OtherWords{"Film", "video movie mp4 gif webm render"},
                                   OtherWords{"Playblast", "video movie preview render"},
                                   OtherWords{"Key", "keyframe"},
                                   OtherWords{"Curves", "easing interpolation graph editor f-curve"},
                                   OtherWords{"Sheet", "dope keyframes"},
                                   OtherWords{"Ease in", "easing interpolation"},
                                   OtherWords{"Ease out", "easing interpolation"},
                                   OtherWords{"Ease in and out", "easing interpolation"},
                                   OtherWords{"Smooth keys", "easing interpolation"},
                                   OtherWords{"Linear keys", "interpolation"},
                                   OtherWords{"Stepped keys", "interpolation constant hold"}};

std::string besides_of(const ActionInfo& action) {
  std::string besides(action.tip);
  for (const OtherWords& one : k_other_words) {
    if (one.label == action.label) besides += ' ' + std::string(one.words);
  }
  return besides;
}

}  // namespace

std::vector<FoundCommand> find_commands(const SearchedIn& in, std::string_view text) {
  const auto words = words_of(text);
  std::vector<std::pair<int, FoundCommand>> all;
  const auto add = [&](FoundCommand command, std::string_view besides) {
    if (const int fit = fits(command.text, besides, words); fit > 0) all.emplace_back(fit, std::move(command));
  };
  for (const ActionInfo& one : all_actions()) {
    if (one.action == Action::search) continue;
    add({FoundKind::action, std::string(one.label), in.keys.shortcut_of(one.action), one.action}, besides_of(one));
  }
  if (!words.empty()) {
    const document::Document& document = in.document;
    const auto parameters = document.model->rig->parameters();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const std::string& name = parameters[i].name;
      add({FoundKind::control, i < in.words.size() ? in.words[i].text() : name, base::format_fixed(document.pose[i], 2),
           Action::tool_pose, 0, name},
          "control " + name);
    }
    for (const auto& key : document.timeline->keys) {
      if (key.name.empty()) continue;
      add({FoundKind::pose, key.name, "frame " + frame_text(key.time_s, in.rate), {}, key.time_s}, "pose key");
    }
    for (const std::string& path : in.recent_files) {
      const std::filesystem::path file(path);
      add({FoundKind::file, file.filename().string(), path}, "file open");
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<FoundCommand> found;
  for (auto& [fit, command] : all) {
    if (found.size() < k_most_found) found.push_back(std::move(command));
  }
  return found;
}

}  // namespace penpose::app
