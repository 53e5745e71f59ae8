#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/model.h"

namespace penpose::tracking {

/// A control that a value of a track drives: rest + gain * value.
struct DrivenControl {
  std::size_t parameter = 0;
  double gain = 1;
  /// The expression whose value it is, with how much of that a value of 1 is; nothing: a control by itself.
  std::optional<std::size_t> expression = std::nullopt;
  double share = 1;
};

/// What a name of a track drives: the controls of that name (rig::controls_named), or what the model's expression of
/// that name is made of. Where it has neither, names that programs agree on stand for others: action units of the
/// Facial Action Coding System ("AU12"; Ekman and Friesen 1978) for the shapes of ARKit or the names of the manual,
/// mouth cues ("mouth cue MBP", of Rhubarb Lip Sync and of Preston Blair's set) for visemes, vowels or ARKit's shapes,
/// and the usual morphs of MikuMikuDance for those of ARKit or VRM. The first set of which the model has any counts.
/// Ascending, each once; empty: the model has nothing for it.
[[nodiscard]] std::vector<DrivenControl> driven_controls(const document::Model& model, std::string_view name);

/// Whether driven_controls gives a control, or the name means that nothing moves ("mouth cue X", the mouth at rest).
[[nodiscard]] bool is_driven(const document::Model& model, std::string_view name);

}  // namespace penpose::tracking
