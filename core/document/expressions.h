#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/document/model.h"

namespace penpose::document {

/// The expression that a name of another program means: the one of that folded name (rig::folded_name), or where there
/// is none, the one that the other version of VRM calls so ("happy" of 1.0 is "Joy" of 0.x). None: there is no such
/// expression.
[[nodiscard]] std::optional<std::size_t> expression_named(const Model& model, std::string_view name);

/// The expressions that a name of another program means: that of expression_named, or where there is none, those whose
/// name means the same (rig::face_name): on the same side, or else on none; without a side, both sides. Ascending.
[[nodiscard]] std::vector<std::size_t> expressions_named(const Model& model, std::string_view name);

/// The name of an expression as VRM 1.0 has it among its presets (VRMC_vrm, expressions): "happy" for "Joy",
/// "blinkLeft" for "Blink_L". Empty: it is none of them.
[[nodiscard]] std::string_view preset_of(std::string_view expression_name);

/// The weights that are shown of the weights that expressions have, one each: those of binary ones are 0 or 1, and
/// those that others override give way (VRMC_vrm 1.0, "Procedural Override").
[[nodiscard]] std::vector<double> shown_weights(const Model& model, std::span<const double> weights);

/// Puts the targets of an expression where it has them at a weight of 0..1, within their ranges. What expressions that
/// it overrides move goes to rest, as far as it overrides them; others stay.
void set_expression(const Model& model, const Expression& expression, double weight, rig::Pose& pose);

/// The expressions for other parameters, found by their names in `before`; values of those that are gone are left out,
/// and so are expressions that have none left.
[[nodiscard]] std::vector<Expression> expressions_for(std::vector<Expression> expressions,
                                                      std::span<const rig::Parameter> before,
                                                      std::span<const rig::Parameter> now);

}  // namespace penpose::document
