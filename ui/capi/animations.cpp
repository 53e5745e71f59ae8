#include <algorithm>

#include "core/base/byte_reader.h"
#include "ui/capi/from_c.h"

using namespace penpose;        // NOLINT(google-build-using-namespace): functions of C have no namespace of their own
using namespace penpose::capi;  // NOLINT(google-build-using-namespace)

namespace {

/// The map of that name or text; nothing: the one of the track's format.
std::optional<io::MapFile> map_of(const char* map) {
  if (map == nullptr) return std::nullopt;
  const std::string_view said(map);
  const io::TrackFormat* named = io::track_format_named(said);
  return taken(named != nullptr ? io::read_bundled_map(*named) : io::read_map_file(base::as_bytes(said)));
}

std::optional<io::PictureSize> picture_of(const penpose_animate_options& options) {
  const auto [width, height] = options.picture;
  if (width == 0 && height == 0) return std::nullopt;
  constexpr double k_widest_px = 100000;
  const bool fits = width >= 1 && height >= 1 && width <= k_widest_px && height <= k_widest_px;
  if (!fits) fail_argument("no size of a picture", "picture", "give width and height in px, or 0 and 0");
  return io::PictureSize{width, height};
}

tracking::AnimateOptions options_of(const penpose_animate_options& options) {
  if (options.head < PENPOSE_HEAD_AS_MAP || options.head > PENPOSE_HEAD_APPLY)
    fail_argument("there is no such choice", "head", "give a PENPOSE_HEAD_...");
  if (options.neutral < -1) fail_argument("there is no frame below 0", "neutral", "give a frame, or -1");
  tracking::AnimateOptions out;
  if (options.head != PENPOSE_HEAD_AS_MAP) out.apply_head = options.head == PENPOSE_HEAD_APPLY;
  if (options.neutral >= 0) out.neutral = static_cast<std::size_t>(options.neutral);
  if (options.tremor_px != -1) out.tremor_px = options.tremor_px;
  out.smooth_s = options.smooth_s;
  out.least_confidence = options.least_confidence;
  out.fps = options.fps;
  out.stretch = options.stretch;
  out.units = options.units != 0;
  if (options.curves != nullptr)
    out.curves = taken(io::read_landmarks(base::as_bytes(std::string_view(options.curves))));
  return out;
}

penpose_animated summary_of(const tracking::Animated& made) {
  return {made.poses.size(),
          made.held.size(),
          made.eyes.blinks.size(),
          made.unmatched.size(),
          made.rest ? static_cast<std::int64_t>(made.rest->frame) : -1,
          made.fps};
}

}  // namespace

int32_t penpose_animate(penpose_library* library, penpose_handle character, const void* track, size_t size,
                        const char* map, const penpose_animate_options* options, penpose_handle* animation,
                        penpose_animated* animated, penpose_error* error) {
  return call_character(library, character, error, [&](const character::Character& one, CharacterObject&) {
    needed(animation, "animation");
    const penpose_animate_options usual = PENPOSE_ANIMATE_DEFAULTS;
    const penpose_animate_options& asked = options == nullptr ? usual : *options;
    const auto given = options_of(asked);
    auto drives = map_of(map);
    auto read = taken(io::read_track(array(static_cast<const std::uint8_t*>(track), size, "track"),
                                     drives ? drives->format : nullptr, picture_of(asked)));
    if (!drives) drives = taken(io::read_bundled_map(*read.format));
    auto made = taken(tracking::animate(one.document(), std::move(read.track), *drives, given));
    const penpose_animated summary = summary_of(made);
    give<AnimationObject>(*library, *animation, std::move(made));
    if (animated != nullptr) *animated = summary;
  });
}

int32_t penpose_animation_frames(penpose_library* library, penpose_handle animation, double* times_s, double* values,
                                 size_t room, size_t* count, penpose_error* error) {
  return call_with<AnimationObject>(library, animation, error, [&](const AnimationObject& object) {
    const tracking::Animated& made = object.animated;
    write_list<double>(made.times_s, times_s, room, count, "times_s");
    if (room == 0) return;
    const std::size_t width = made.poses.front().size();
    double* out = array(values, made.poses.size() * width, "values").data();
    for (const rig::Pose& pose : made.poses) out = std::copy(pose.begin(), pose.end(), out);
  });
}

int32_t penpose_animation_notes(penpose_library* library, penpose_handle animation, char* text, size_t capacity,
                                size_t* size, penpose_error* error) {
  return call_with<AnimationObject>(library, animation, error, [&](const AnimationObject& object) {
    std::string all;
    for (const std::string& note : object.animated.notes) all += note + "\n";
    write_list<char>(all, text, capacity, size, "text");
  });
}

int32_t penpose_animation_character(penpose_library* library, penpose_handle animation, penpose_handle* character,
                                    penpose_error* error) {
  return call_with<AnimationObject>(library, animation, error, [&](const AnimationObject& object) {
    give<CharacterObject>(*library, needed(character, "character"), character::Character(object.animated.document));
  });
}
