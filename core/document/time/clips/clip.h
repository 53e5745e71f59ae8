#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "core/document/model.h"
#include "core/document/sound/mouths.h"
#include "core/document/time/bookmark.h"
#include "core/document/time/timeline.h"

namespace penpose::document {

/// A clip of a document: a timeline with a name. The keys of the one that is shown are Document::timeline.
struct Clip {
  std::string name;
  std::optional<std::size_t> animation = {};        ///< of the model, whose keys it has; none: it was made here
  std::shared_ptr<const Timeline> opened = {};      ///< the keys as they were read from the animation; null: none
  std::shared_ptr<const Timeline> timeline = {};    ///< never null, but for the clip that is shown
  std::shared_ptr<const SpokenMouths> spoken = {};  ///< Document::spoken of it
  std::shared_ptr<const Bookmarks> bookmarks = {};  ///< Document::bookmarks of it
};

/// The name of a timeline that got no other one.
inline constexpr const char* k_timeline_name = "timeline";
inline constexpr std::size_t k_most_clips = 1000;

/// The animation with a clip's keys: channels whose controls have the same keys as in `opened` stay as they are, the
/// others are made of `timeline` (to_animation). What a rig has no control for stays.
[[nodiscard]] Animation with_keys(const Model& model, const Animation& animation, const Timeline& opened,
                                  const Timeline& timeline);

}  // namespace penpose::document
