#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/named_value.h"
#include "core/rig/rig.h"

namespace penpose::document {

/// A mouth as the artist draws it: the controls that it moves and their values.
struct Mouth {
  std::string name;
  std::vector<NamedValue> values;  ///< each control once, in the order of the rig; empty: the mouth at rest
  friend bool operator==(const Mouth&, const Mouth&) = default;
};
using Mouths = std::vector<std::shared_ptr<const Mouth>>;

/// A mouth that was keyed at a moment (KeyMouths).
struct SpokenMouth {
  double time_s = 0;
  std::string mouth;
  friend bool operator==(const SpokenMouth&, const SpokenMouth&) = default;
};
/// Ascending in time.
using SpokenMouths = std::vector<SpokenMouth>;

inline constexpr std::size_t k_most_mouths = 100;

[[nodiscard]] const Mouth* find_mouth(const Mouths& mouths, std::string_view name);

/// The numbers of the controls that the mouths of `spoken` move, ascending.
[[nodiscard]] std::vector<std::size_t> controls_of(const Mouths& mouths, const SpokenMouths& spoken,
                                                   std::span<const rig::Parameter> parameters);
/// What a mouth makes of some controls, one value each: those that it does not move are at rest.
[[nodiscard]] std::vector<double> values_of(const Mouth& mouth, std::span<const std::size_t> controls,
                                            std::span<const rig::Parameter> parameters);

/// Those of the mouths' values whose controls a rig has, in its order and within their ranges.
[[nodiscard]] Mouths mouths_of_rig(const Mouths& mouths, std::span<const rig::Parameter> parameters);
/// The mouths with a control called otherwise.
[[nodiscard]] Mouths with_renamed_control(const Mouths& mouths, const std::string& from, const std::string& to);

}  // namespace penpose::document
