#include "core/tracking/driven_controls.h"

#include <algorithm>

#include "core/document/expressions.h"
#include "core/rig/control_names.h"

namespace penpose::tracking {
namespace {

/// Sets of controls separated by "|", each "name" or "name*gain" separated by blanks. "-" is a set without any: the
/// name means that nothing moves. A set that starts with "all:" counts only where the model has all that it names.
struct Synonym {
  const char* name;
  const char* sets;
};

constexpr Synonym k_synonyms[] = {
    // Action units.
    {"AU01", "innerBrowRaiser|browInnerUp"},
    {"AU02", "outerBrowRaiser|browOuterUp"},
    {"AU04", "browLowerer|browDown"},
    {"AU05", "upperLidRaiser|eyeWide"},
    {"AU06", "cheekRaiser|cheekSquint"},
    {"AU07", "lidTightener|eyeSquint"},
    {"AU09", "noseWrinkler|noseSneer"},
    {"AU10", "upperLipRaiser|mouthUpperUp"},
    {"AU12", "lipCornerPuller|mouthSmile|mouthCornerPull|smile"},
    {"AU13", "sharpLipPuller|cheekPuff*0.5 mouthSmile*0.5"},
    {"AU14", "dimpler|mouthDimple"},
    {"AU15", "lipCornerDepressor|mouthFrown"},
    {"AU16", "lowerLipDepressor|mouthLowerDown"},
    {"AU17", "chinRaiser|mouthShrugLower"},
    {"AU18", "lipPucker|mouthPucker"},
    {"AU19", "tongueShow|tongueOut"},
    {"AU20", "lipStretcher|mouthStretch"},
    {"AU22", "lipFunneler|mouthFunnel"},
    {"AU23", "lipTightener|mouthPress*0.5"},
    {"AU24", "lipPressor|mouthPress"},
    {"AU25", "lipsPart|mouthLowerDown*0.3"},
    {"AU26", "jawDrop|jawOpen|jaw|Fcl_MTH_A|aa"},
    {"AU27", "mouthStretchOpen|jawOpen|jaw|Fcl_MTH_A|aa"},
    {"AU28", "lipSuck|mouthRollLower mouthRollUpper"},
    {"AU29", "jawThrust|jawForward"},
    {"AU34", "cheekPuff|puff"},
    {"AU43", "eyeClosure|eyesClosed|eyeBlink|Fcl_EYE_Close|blink"},
    {"AU45", "eyeBlink|blink|Fcl_EYE_Close|eyesClosed"},
    // Mouth shapes of Rhubarb Lip Sync; X is the mouth at rest.
    {"mouth cue A", "all:A B C D E F|viseme_PP|mouthPress*0.4|-"},
    {"mouth cue B",
     "all:B A C D E F|viseme_SS|ih*0.6|Fcl_MTH_I*0.6|all:I*0.6 A*0 U*0 E*0 O*0|jawOpen*0.06 mouthStretch*0.3 "
     "mouthLowerDown*0.25"},
    {"mouth cue C",
     "all:C A B D E F|viseme_E|ee|Fcl_MTH_E|all:E A*0 I*0 U*0 O*0|jawOpen*0.25 mouthStretch*0.15|jaw*0.3"},
    {"mouth cue D", "all:D A B C E F|viseme_aa|aa|Fcl_MTH_A|all:A I*0 U*0 E*0 O*0|jawOpen*0.6|jaw*0.6"},
    {"mouth cue E", "all:E A B C D F|viseme_O|oh|Fcl_MTH_O|all:O A*0 I*0 U*0 E*0|jawOpen*0.3 mouthFunnel*0.5|jaw*0.3"},
    {"mouth cue F", "all:F A B C D E|viseme_U|ou|Fcl_MTH_U|all:U A*0 I*0 E*0 O*0|jawOpen*0.1 mouthPucker*0.8|jaw*0.1"},
    {"mouth cue G",
     "all:G A B C D E F|viseme_FF|jawOpen*0.05 mouthRollLower*0.5 mouthUpperUp*0.2|ih*0.2|Fcl_MTH_I*0.2|-"},
    {"mouth cue H",
     "all:H A B C D E F|viseme_nn|ee*0.6|Fcl_MTH_E*0.6|all:E*0.6 A*0 I*0 U*0 O*0|jawOpen*0.2 tongueOut*0.1|"
     "jaw*0.2"},
    {"mouth cue X", "all:X A B C D E F|viseme_sil|-"},
    // Preston Blair's, as Papagayo writes them. "=" is another name's sets.
    {"mouth cue MBP", "all:MBP FV etc|=mouth cue A"},
    {"mouth cue etc", "all:etc MBP FV|=mouth cue B"},
    {"mouth cue E.", "all:E MBP FV|=mouth cue C"},
    {"mouth cue AI", "all:AI MBP FV|=mouth cue D"},
    {"mouth cue O", "all:O MBP FV|=mouth cue E"},
    {"mouth cue U", "all:U MBP FV|=mouth cue F"},
    {"mouth cue WQ", "all:WQ MBP FV|=mouth cue F"},
    {"mouth cue FV", "all:FV MBP|=mouth cue G"},
    {"mouth cue L", "all:L MBP FV|=mouth cue H"},
    {"mouth cue rest", "all:rest MBP FV|=mouth cue X"},
    // Morphs of MikuMikuDance.
    {"まばたき", "eyeBlink|blink|Fcl_EYE_Close|eyesClosed"},
    {"笑い", "Fcl_EYE_Joy|eyeBlink*0.8 cheekSquint*0.6|blink"},
    {"ウィンク", "Fcl_EYE_Joy_L|eyeBlinkLeft|blinkLeft|blink_L|Fcl_EYE_Close_L"},
    {"ウィンク右", "Fcl_EYE_Joy_R|eyeBlinkRight|blinkRight|blink_R|Fcl_EYE_Close_R"},
    {"ウィンク２", "Fcl_EYE_Close_L|eyeBlinkLeft|blinkLeft|blink_L"},
    {"ｳｨﾝｸ２右", "Fcl_EYE_Close_R|eyeBlinkRight|blinkRight|blink_R"},
    {"じと目", "eyeSquint|Fcl_EYE_Fun"},
    {"びっくり", "eyeWide|Fcl_EYE_Surprised|surprised"},
    {"あ", "aa|Fcl_MTH_A|all:A I*0 U*0 E*0 O*0|viseme_aa|jawOpen*0.6|jaw*0.6"},
    {"い", "ih|Fcl_MTH_I|all:I A*0 U*0 E*0 O*0|viseme_I|jawOpen*0.08 mouthStretch*0.4"},
    {"う", "ou|Fcl_MTH_U|all:U A*0 I*0 E*0 O*0|viseme_U|jawOpen*0.1 mouthPucker*0.8"},
    {"え", "ee|Fcl_MTH_E|all:E A*0 I*0 U*0 O*0|viseme_E|jawOpen*0.25 mouthStretch*0.15"},
    {"お", "oh|Fcl_MTH_O|all:O A*0 I*0 U*0 E*0|viseme_O|jawOpen*0.3 mouthFunnel*0.5"},
    {"ん", "Fcl_MTH_Close|viseme_nn|mouthPress*0.3"},
    {"にやり", "Fcl_MTH_Fun|mouthSmile"},
    {"にやり２", "Fcl_MTH_Fun|mouthSmile"},
    {"にっこり", "Fcl_MTH_Joy|mouthSmile"},
    {"口角上げ", "Fcl_MTH_Up|mouthSmile"},
    {"口角下げ", "Fcl_MTH_Down|mouthFrown"},
    {"ぺろっ", "tongueOut"},
    {"真面目", "Fcl_BRW_Angry|browDown*0.6"},
    {"困る", "Fcl_BRW_Sorrow|browInnerUp"},
    {"にこり", "Fcl_BRW_Joy|browOuterUp*0.7"},
    {"怒り", "Fcl_BRW_Angry|browDown"},
    {"上", "browInnerUp browOuterUp|Fcl_BRW_Surprised"},
    {"下", "browDown"},
    {"瞳小", "Fcl_EYE_Iris_Hide*0.5"},
};

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> pieces;
  while (true) {
    const std::size_t end = std::min(text.find(at), text.size());
    if (end > 0) pieces.push_back(text.substr(0, end));
    if (end == text.size()) return pieces;
    text.remove_prefix(end + 1);
  }
}

/// "0.25" as a number; these tables have no other form.
double gain_of(std::string_view text) {
  double value = 0;
  double unit = 1;
  bool after = false;
  for (const char c : text) {
    if (c == '.') {
      after = true;
      continue;
    }
    if (after) unit /= 10;
    value = after ? value + unit * (c - '0') : value * 10 + (c - '0');
  }
  return value;
}

class Finder {
 public:
  explicit Finder(const document::Model& model) : model_(model) {}

  void add(std::size_t parameter, double gain) {
    const auto same = [&](const DrivenControl& one) { return one.parameter == parameter; };
    if (std::none_of(found_.begin(), found_.end(), same)) found_.push_back({parameter, gain});
  }

  /// By its own name: a control's, or an expression's.
  bool add_named(std::string_view name, double gain) {
    const auto own = rig::controls_named(model_.rig->parameters(), name);
    for (const std::size_t p : own) add(p, gain);
    if (!own.empty()) return true;
    const auto expression = document::expression_named(model_, name);
    if (!expression) return false;
    for (const auto& [p, value] : model_.expressions[*expression].values)
      add(p, gain * (value - model_.rig->parameters()[p].rest));
    return true;
  }

  /// Whether the sets of a name decide what it does, be it nothing.
  bool add_synonyms(std::string_view name, int depth) {
    const auto known = std::find_if(std::begin(k_synonyms), std::end(k_synonyms),
                                    [&](const Synonym& one) { return name == one.name; });
    if (known == std::end(k_synonyms) || depth > 2) return false;
    for (std::string_view set : split(known->sets, '|')) {
      if (set == "-") return true;
      if (set.starts_with('=')) {
        if (add_synonyms(set.substr(1), depth + 1)) return true;
        continue;
      }
      const bool all = set.starts_with("all:");
      if (all) set.remove_prefix(4);
      const auto names = split(set, ' ');
      if (all && !has_all(names)) continue;
      bool any = false;
      for (std::size_t i = 0; i < (all ? 1 : names.size()); ++i) {
        const auto parts = split(names[i], '*');
        any = add_named(parts[0], parts.size() > 1 ? gain_of(parts[1]) : 1.0) || any;
      }
      if (any) return true;
    }
    return false;
  }

  [[nodiscard]] std::vector<DrivenControl> take() {
    std::stable_sort(found_.begin(), found_.end(),
                     [](const DrivenControl& a, const DrivenControl& b) { return a.parameter < b.parameter; });
    return std::move(found_);
  }

 private:
  [[nodiscard]] bool has_all(const std::vector<std::string_view>& names) const {
    return std::all_of(names.begin(), names.end(), [&](std::string_view name) {
      Finder one(model_);
      return one.add_named(split(name, '*')[0], 1);
    });
  }

  const document::Model& model_;
  std::vector<DrivenControl> found_;
};

bool find(const document::Model& model, std::string_view name, std::vector<DrivenControl>& found) {
  Finder finder(model);
  const bool any = finder.add_named(name, 1) || finder.add_synonyms(name, 0);
  found = finder.take();
  return any;
}

}  // namespace

std::vector<DrivenControl> driven_controls(const document::Model& model, std::string_view name) {
  std::vector<DrivenControl> found;
  find(model, name, found);
  return found;
}

bool is_driven(const document::Model& model, std::string_view name) {
  std::vector<DrivenControl> found;
  return find(model, name, found);
}

}  // namespace penpose::tracking
