#include "core/document/words/control_words.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/document/words/face_deeds.h"
#include "core/document/words/joint_words.h"
#include "core/document/words/readable_name.h"

namespace penpose::document {
namespace {

/// An effect of less, of the distance between the eyes, is none.
constexpr double k_least_effect = 0.006;
/// A name adds the first number to the likeness of the deed that it says, if the face does at least the second like it.
constexpr double k_by_name = 0.35, k_least_named = 0.15;
/// A control that is less like any deed than this has other words.
constexpr double k_alike = 0.55;
/// How much less like it the deed may be that a control is called by where a likelier control has its own.
constexpr double k_gives_way = 0.12;
/// A deed is one of two where it leaves this share of an effect, which is so much like the other one.
constexpr double k_second = 0.6, k_second_alike = 0.7;
/// An upper lid that comes down by a greater share of what is open closes the eye.
constexpr double k_closes = 0.55;
/// A half of the lids that goes this many times as far as the other is meant.
constexpr double k_half = 1.7;
/// Weighs the size of an effect against its likeness where several controls would get the same name.
constexpr double k_by_amount = 0.2;
/// What does less than this share of what another one of the same words does, does it a little.
constexpr double k_little = 0.6;
/// Share of an effect that brows and eyes may have where the mouth makes a sound.
constexpr double k_besides = 0.5;
/// Share of an effect that can tell it from another.
constexpr double k_telling = 0.12;

/// What is known of one control before all have their words.
struct Sight {
  FaceEffect effect;
  std::vector<LikeDeed> deeds;  ///< the likest first; empty: it does nothing to the face
  std::optional<Deed> named;
  std::optional<Deed> chosen;
};

class Words {
 public:
  Words(const Model& model, const intent::WholeModel& whole, std::span<const portrait::FeatureCurve> features)
      : model_(model),
        whole_(whole),
        face_(FaceMarks::of(model, features)),
        words_(model.rig->parameters().size()),
        sights_(words_.size()) {}

  std::vector<ControlWords> take() {
    const auto joints = joint_words(model_, whole_, face_ ? &*face_ : nullptr);
    std::vector<bool> done(words_.size());
    for (std::size_t i = 0; i < words_.size(); ++i) {
      if (joints[i]) words_[i] = {*joints[i]};
      done[i] = joints[i] || keep_sketched(i) || see(i);
    }
    choose_deeds();
    for (std::size_t i = 0; i < words_.size(); ++i) {
      if (!done[i]) say(i);
    }
    make_unique();
    return std::move(words_);
  }

 private:
  [[nodiscard]] const std::string& name(std::size_t i) const { return model_.rig->parameters()[i].name; }

  void say_name(std::size_t i) {
    const ReadableName own = readable_name(name(i));
    words_[i] = {own};
  }

  /// Who sketches a control names it.
  bool keep_sketched(std::size_t i) {
    if (!model_.deformers) return false;
    const std::size_t first = model_.shapes ? model_.shapes->parameters().size() : 0;
    if (i < first || i >= first + model_.deformers->parameters().size()) return false;
    const bool plain = name(i).find('_') == std::string::npos;
    words_[i] = {plain ? ReadableName{name(i)} : readable_name(name(i))};
    return true;
  }

  [[nodiscard]] FaceEffect effect_at(std::size_t i, double value) {
    rig::Pose pose = rig::rest_pose(*model_.rig);
    pose[i] = value;
    return effect_of(face_->moves(pose));
  }

  /// Looks at what a control does. True: it has its words.
  bool see(std::size_t i) {
    Sight& sight = sights_[i];
    sight.named = deed_named(name(i));
    if (!face_ || !face_->moves(i)) {
      say_without_face(i);
      return true;
    }
    const rig::Parameter& parameter = model_.rig->parameters()[i];
    const bool up = parameter.maximum > parameter.rest;
    sight.effect = effect_at(i, up ? parameter.maximum : parameter.minimum);
    if (amount(sight.effect.aspects) < k_least_effect && sight.effect.sideways < 0.5) {
      say_without_face(i);
      return true;
    }
    if (const std::string said = expression_named(name(i)); !said.empty() && may_be_said(said, sight.effect)) {
      words_[i] = {{said}};
      return true;
    }
    if (const std::string sideways = words_sideways(sight.effect); !sideways.empty()) {
      words_[i] = {{sideways}};
      return true;
    }
    sight.deeds = deeds_like(sight.effect.aspects, sight.effect.side);
    drop_lid_deed(sight);
    for (LikeDeed& one : sight.deeds) {
      if (sight.named == one.deed && one.alike > k_least_named) one.alike += k_by_name;
    }
    std::stable_sort(sight.deeds.begin(), sight.deeds.end(),
                     [](const LikeDeed& a, const LikeDeed& b) { return a.alike > b.alike; });
    return false;
  }

  /// Whether an effect may be an expression: sounds are made below the eyes, and by both sides.
  [[nodiscard]] static bool may_be_said(const std::string& expression, const FaceEffect& effect) {
    if (!expression.starts_with("mouth: ")) return true;
    return effect.side == FaceSide::both && amount_of_eyes(effect.aspects) < k_besides * amount(effect.aspects);
  }

  /// An eye closes, or an upper lid comes down: the one that is not so is no deed of the control.
  void drop_lid_deed(Sight& sight) const {
    const auto way = [&](Aspect aspect) {
      return sight.effect.aspects[static_cast<std::size_t>(aspect)] / weight(aspect);
    };
    const double closed = way(Aspect::lid_lower_up) - way(Aspect::lid_upper_up);
    const bool closes = closed > k_closes * face_->open();
    const auto other = deed_of_words(closes ? "upper lid down" : "eye closes");
    std::erase_if(sight.deeds, [&](const LikeDeed& one) { return one.deed == other; });
  }

  /// Where the face shows nothing, its name says what it can.
  void say_without_face(std::size_t i) {
    const ReadableName own = readable_name(name(i));
    words_[i] = {own};
    if (const std::string said = expression_named(name(i)); !said.empty()) words_[i] = {{said}};
    if (sights_[i].named) words_[i].what = words_of_deed(*sights_[i].named, own.side == FaceSide::both);
  }

  /// Each deed once a side: the likest first, and who comes later takes one that is nearly as like.
  void choose_deeds() {
    struct Wish {
      std::size_t control;
      LikeDeed deed;
    };
    std::vector<Wish> wishes;
    for (std::size_t i = 0; i < sights_.size(); ++i) {
      const auto& deeds = sights_[i].deeds;
      for (const LikeDeed& one : deeds) {
        if (one.alike >= std::max(k_alike, deeds.front().alike - k_gives_way)) wishes.push_back({i, one});
      }
    }
    std::stable_sort(wishes.begin(), wishes.end(),
                     [](const Wish& a, const Wish& b) { return a.deed.alike > b.deed.alike; });
    std::set<std::pair<Deed, FaceSide>> taken;
    for (const Wish& wish : wishes) {
      Sight& sight = sights_[wish.control];
      if (sight.chosen || !taken.insert({wish.deed.deed, sight.effect.side}).second) continue;
      sight.chosen = wish.deed.deed;
    }
    for (Sight& sight : sights_) {
      if (!sight.chosen && !sight.deeds.empty() && sight.deeds.front().alike >= k_alike)
        sight.chosen = sight.deeds.front().deed;
    }
  }

  /// Words for what an effect does most, and what it does besides where that is a deed of its own.
  void say(std::size_t i) {
    const Sight& sight = sights_[i];
    const bool both = sight.effect.side == FaceSide::both;
    words_[i].side = sight.effect.side;
    if (!sight.chosen) {
      words_[i].what = telling(sight.effect, sight.effect.aspects, {});
      if (words_[i].what.empty()) say_name(i);
      return;
    }
    words_[i].what = words_of_deed(*sight.chosen, both);
    words_[i].what += half_of_lids(i);
    words_[i].below = below(i);
    const Aspects rest = without(sight.effect.aspects, *sight.chosen);
    if (amount(rest) < k_second * amount(sight.effect.aspects)) return;
    const auto second = deeds_like(rest, sight.effect.side);
    if (second.empty() || second.front().alike < k_second_alike || sight.named == *sight.chosen) return;
    const std::string_view besides = words_of_deed(second.front().deed, both);
    if (first_word(besides) != first_word(words_[i].what)) words_[i].what += " and " + std::string(besides);
  }

  /// What it does below its rest, where it may go there as well as above.
  [[nodiscard]] std::string below(std::size_t i) {
    const rig::Parameter& parameter = model_.rig->parameters()[i];
    if (!(parameter.minimum < parameter.rest && parameter.maximum > parameter.rest)) return {};
    const FaceEffect effect = effect_at(i, parameter.minimum);
    const auto deeds = deeds_like(effect.aspects, effect.side);
    if (deeds.empty() || deeds.front().alike < k_alike) return {};
    return std::string(words_of_deed(deeds.front().deed, effect.side == FaceSide::both)) +
           std::string(behind(effect.side));
  }

  static std::string_view first_word(std::string_view words) { return words.substr(0, words.find(' ')); }

  /// The words of the largest aspect of what is done, `rest` of it where something is said already, that are not among
  /// some; empty: none is large.
  [[nodiscard]] static std::string telling(const FaceEffect& effect, const Aspects& rest,
                                           const std::set<std::string>& but) {
    std::vector<std::size_t> order(k_aspects);
    for (std::size_t k = 0; k < k_aspects; ++k) order[k] = k;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return std::abs(rest[a]) > std::abs(rest[b]); });
    for (const std::size_t k : order) {
      const double least = k_telling * amount(effect.aspects);
      if (std::abs(rest[k]) < least) break;
      if (std::abs(effect.aspects[k]) < least || (rest[k] > 0) != (effect.aspects[k] > 0)) continue;
      const std::string words(words_of(static_cast<Aspect>(k), effect.aspects[k] > 0, effect.side == FaceSide::both));
      if (!but.contains(words)) return words;
    }
    return {};
  }

  /// Where several have one text, the one that does it most and likest keeps it, and the others say what tells them
  /// from it, or their name.
  void make_unique() {
    std::map<std::string, std::vector<std::size_t>> same;
    for (std::size_t i = 0; i < words_.size(); ++i) same[words_[i].text()].push_back(i);
    std::set<std::string> texts;
    for (const auto& [text, controls] : same) texts.insert(text);
    for (auto& [text, controls] : same) {
      if (controls.size() < 2) continue;
      double most = 1e-300;
      for (const std::size_t i : controls) most = std::max(most, amount_of(i));
      const auto score = [&](std::size_t i) { return likeness(i) + k_by_amount * amount_of(i) / most; };
      std::stable_sort(controls.begin(), controls.end(),
                       [&](std::size_t a, std::size_t b) { return score(a) > score(b); });
      for (std::size_t k = 1; k < controls.size(); ++k) tell_apart(controls[k], controls[0], texts);
    }
  }

  [[nodiscard]] double likeness(std::size_t i) const {
    return sights_[i].deeds.empty() ? 0.0 : sights_[i].deeds.front().alike;
  }
  [[nodiscard]] double amount_of(std::size_t i) const { return amount(sights_[i].effect.aspects); }

  /// ", inner half", ", outer half" of the lids; empty where both go alike or something else is done.
  [[nodiscard]] std::string half_of_lids(std::size_t i) const {
    const Sight& sight = sights_[i];
    if (!sight.chosen) return {};
    const std::string_view words = words_of_deed(*sight.chosen, false);
    const bool lids = words.starts_with("eye ") || words.find("lid") != std::string_view::npos;
    if (!lids || words.find("looks") != std::string_view::npos) return {};
    if (sight.effect.lid_inner > k_half * sight.effect.lid_outer) return ", inner half";
    return sight.effect.lid_outer > k_half * sight.effect.lid_inner ? ", outer half" : "";
  }

  void tell_apart(std::size_t i, std::size_t keeper, std::set<std::string>& texts) {
    const Sight& sight = sights_[i];
    const std::string plain = words_[i].what;
    const auto tries = [&](const std::string& more) {
      words_[i].what = plain + more;
      return texts.insert(words_[i].text()).second;
    };
    if (sight.chosen && sights_[keeper].chosen && amount_of(i) < k_little * amount_of(keeper) && tries(" a little"))
      return;
    std::set<std::string> tried{plain};
    while (sight.chosen) {
      const std::string more = telling(sight.effect, without(sight.effect.aspects, *sight.chosen), tried);
      if (more.empty()) break;
      tried.insert(more);
      if (plain.find(more) == std::string::npos && tries(", " + more)) return;
    }
    static_cast<void>(tries(" (" + name(i) + ")"));
  }

  const Model& model_;
  const intent::WholeModel& whole_;
  std::optional<FaceMarks> face_;
  std::vector<ControlWords> words_;
  std::vector<Sight> sights_;
};

}  // namespace

std::vector<ControlWords> control_words(const Model& model, const intent::WholeModel& whole,
                                        std::span<const portrait::FeatureCurve> features) {
  return Words(model, whole, features).take();
}

}  // namespace penpose::document
