#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/character/character.h"
#include "core/character/live_target.h"
#include "core/tracking/animate.h"
#include "firmware_io/decode/decoder_factory.h"
#include "replay/session/command_recorder.h"
#include "ui/capi/handle_table.h"

// What the handles of the C library name.

struct penpose_library {
  penpose::capi::HandleTable handles;
};

namespace penpose::capi {

struct CharacterObject final : Object {
  static constexpr Kind k_kind = Kind::character;
  explicit CharacterObject(character::Character made) : Object(k_kind), character(std::move(made)) {}

  character::Character character;
  std::string session;                              ///< what was recorded so far
  std::optional<replay::CommandRecorder> recorder;  ///< nothing: nothing is recorded
};

struct LiveObject final : Object {
  static constexpr Kind k_kind = Kind::live;
  explicit LiveObject(character::LiveTarget begun) : Object(k_kind), live(std::move(begun)) {}

  character::LiveTarget live;
};

struct AnimationObject final : Object {
  static constexpr Kind k_kind = Kind::animation;
  explicit AnimationObject(tracking::Animated made) : Object(k_kind), animated(std::move(made)) {}

  tracking::Animated animated;
};

struct TabletObject final : Object {
  static constexpr Kind k_kind = Kind::tablet;
  explicit TabletObject(std::unique_ptr<decode::PenDecoder> made) : Object(k_kind), decoder(std::move(made)) {}

  std::unique_ptr<decode::PenDecoder> decoder;
};

/// A character of the library's own, by its name. Errors: there is none of that name.
[[nodiscard]] base::Result<document::Document> built_in_document(std::string_view name);

}  // namespace penpose::capi
