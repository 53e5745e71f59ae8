#include "core/speech/usual_mouths.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/phonetics/nine_mouths.h"
#include "core/tracking/driven_controls.h"

namespace penpose::speech {
namespace {

using enum NineMouth;

/// What stands for a mouth that is not drawn, the most like it first.
std::vector<NineMouth> most_like(NineMouth mouth) {
  switch (mouth) {
    case a:
      return {e, o, consonants, rest, closed};
    case e:
      return {consonants, a, l, rest, closed};
    case l:
      return {consonants, e, rest, closed};
    case o:
      return {u, a, e, rest, closed};
    case u:
      return {o, rest, closed};
    case consonants:
      return {rest, e, l, closed};
    case f:
      return {closed, rest};
    case closed:
      return {rest};
    case rest:
      return {closed};
  }
  return {};
}

}  // namespace

std::vector<document::Mouth> usual_mouths(const document::Model& model) {
  const auto parameters = model.rig->parameters();
  std::vector<document::Mouth> mouths;
  bool any = false;
  for (std::size_t i = 0; i < k_nine; ++i) {
    document::Mouth mouth{std::string(k_mouth_names[i]), {}};
    for (const auto& driven : tracking::driven_controls(model, std::string("mouth cue ") + k_mouth_letters[i])) {
      const rig::Parameter& moved = parameters[driven.parameter];
      mouth.values.push_back({moved.name, std::clamp(moved.rest + driven.gain, moved.minimum, moved.maximum)});
      any = true;
    }
    mouths.push_back(std::move(mouth));
  }
  return any ? mouths : std::vector<document::Mouth>();
}

base::Result<document::SpokenMouths> with_drawn(const document::SpokenMouths& keys, const document::Mouths& mouths) {
  document::SpokenMouths out = keys;
  const auto drawn = [&](NineMouth mouth) { return document::find_mouth(mouths, name_of(mouth)) != nullptr; };
  for (document::SpokenMouth& key : out) {
    if (document::find_mouth(mouths, key.mouth) != nullptr) continue;
    const auto* name = std::find(k_mouth_names.begin(), k_mouth_names.end(), key.mouth);
    const auto others = name == k_mouth_names.end() ? std::vector<NineMouth>()
                                                    : most_like(static_cast<NineMouth>(name - k_mouth_names.begin()));
    const auto other = std::find_if(others.begin(), others.end(), drawn);
    if (other == others.end())
      return base::Error{"no mouth stands for \"" + key.mouth + "\"", "", "draw it, or the mouth \"rest\""};
    key.mouth = name_of(*other);
  }
  return out;
}

}  // namespace penpose::speech
