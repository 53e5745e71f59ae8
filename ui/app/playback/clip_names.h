#pragma once

#include <string>

#include "core/document/document.h"

namespace penpose::app {

/// What a clip is called: an animation without a name by its number from 1.
[[nodiscard]] inline std::string clip_name(const document::Clip& clip) {
  return clip.name.empty() && clip.animation ? "animation " + std::to_string(*clip.animation + 1) : clip.name;
}
/// The same of the clip that is shown.
[[nodiscard]] inline std::string shown_clip_name(const document::Document& document) {
  return document.clips.empty() ? document::k_timeline_name : clip_name(*document.clips[document.clip]);
}

}  // namespace penpose::app
