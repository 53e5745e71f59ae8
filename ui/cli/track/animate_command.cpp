#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>

#include "core/base/numbers.h"
#include "core/base/text/shown_text.h"
#include "core/io/model/model_formats.h"
#include "core/io/tracks/cues/cue_file.h"
#include "core/tracking/animate.h"
#include "core/tracking/driven_controls.h"
#include "ui/cli/number_range.h"
#include "ui/cli/orientation_option.h"
#include "ui/cli/pose/tolerance_option.h"
#include "ui/cli/progress.h"
#include "ui/cli/subcommand.h"
#include "ui/cli/track/track_input.h"
#include "ui/files/file_roles.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"
#include "ui/files/save_model.h"
#include "ui/serve/animation_json.h"

namespace penpose::cli {
namespace {

struct AnimateArguments {
  io::WriteOptions glb;
  std::string model;
  io::Orientation orientation;
  std::string track;
  std::string map;
  std::string curves;
  std::string out;
  std::string head;
  std::optional<std::size_t> neutral;
  std::optional<double> tremor_px;
  double smooth_s = 0;
  double least_confidence = 0.2;
  double fps = 0;
  double stretch = 0;
  std::string picture;
  bool units = false;
  bool json = false;
};

base::Result<io::MapFile> load_map(const std::string& path) {
  if (const io::TrackFormat* named = io::track_format_named(path)) return io::read_bundled_map(*named);
  const auto bytes = files::read_file(path, files::k_most_text_bytes);
  if (!bytes) return bytes.error();
  return io::read_map_file(*bytes);
}

base::Result<std::vector<io::VertexCurve>> load_curves(const std::string& path) {
  if (path.empty()) return std::vector<io::VertexCurve>();
  const auto bytes = files::read_file(path, files::k_most_text_bytes);
  if (!bytes) return bytes.error();
  return io::read_landmarks(*bytes);
}

/// How long the frames of a track took, shown while they do.
class FrameClock {
 public:
  explicit FrameClock(std::size_t frames) : progress_("animating", frames) {}

  animation::FrameWatch watch() {
    return [this](bool done) {
      if (!done) {
        before_ = Clock::now();
        return;
      }
      times_us_.push_back(std::chrono::duration<double, std::micro>(Clock::now() - before_).count());
      progress_.advance();
    };
  }
  /// Ends the show.
  [[nodiscard]] double median_us() {
    progress_.finish();
    std::sort(times_us_.begin(), times_us_.end());
    return times_us_.empty() ? 0 : times_us_[times_us_.size() / 2];
  }

 private:
  using Clock = std::chrono::steady_clock;
  Progress progress_;
  Clock::time_point before_;
  std::vector<double> times_us_;
};

/// Frames as people write them: 3, 7-12, 40.
std::string ranges(const std::vector<std::size_t>& frames) {
  std::string text;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::size_t first = frames[i];
    while (i + 1 < frames.size() && frames[i + 1] == frames[i] + 1) ++i;
    text += (text.empty() ? "frame " : ", ") + std::to_string(first);
    if (frames[i] != first) text += "-" + std::to_string(frames[i]);
  }
  return text;
}

std::size_t frame_count(const io::Track& track) {
  if (const auto* points = std::get_if<animation::PointTrack>(&track)) return points->frames.size();
  if (const auto* values = std::get_if<animation::WeightTrack>(&track)) return values->frames.size();
  return 0;
}

std::optional<io::PictureSize> picture_size(const std::string& text) {
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos) return std::nullopt;
  const auto width = base::parse_int(std::string_view(text).substr(0, cross));
  const auto height = base::parse_int(std::string_view(text).substr(cross + 1));
  if (!width || !height || *width < 1 || *height < 1 || *width > 100000 || *height > 100000) return std::nullopt;
  return io::PictureSize{static_cast<double>(*width), static_cast<double>(*height)};
}

std::string check_picture(const std::string& text) {
  return picture_size(text) ? std::string() : "write WIDTHxHEIGHT in px, not \"" + text + "\"";
}

tracking::AnimateOptions options_of(const AnimateArguments& arguments, std::vector<io::VertexCurve> curves) {
  tracking::AnimateOptions options;
  if (!arguments.head.empty()) options.apply_head = arguments.head == "apply";
  options.neutral = arguments.neutral;
  options.tremor_px = arguments.tremor_px;
  options.smooth_s = arguments.smooth_s;
  options.least_confidence = arguments.least_confidence;
  options.fps = arguments.fps;
  options.stretch = arguments.stretch;
  options.units = arguments.units;
  options.curves = std::move(curves);
  return options;
}

/// The file that an error is about.
const std::string& blamed_file(const AnimateArguments& arguments, tracking::AnimateInput input) {
  if (input == tracking::AnimateInput::model) return arguments.model;
  return input == tracking::AnimateInput::track || arguments.map.empty() ? arguments.track : arguments.map;
}

void print(const tracking::Animated& animated, double solve_us) {
  std::cout << animated.poses.size() << " frames at " << base::format_fixed(animated.fps, 2) << " a second, "
            << animated.held.size() << " held, " << base::format_fixed(solve_us / 1000.0, 2) << " ms a frame\n";
  if (!animated.held.empty()) std::cout << "held: " << ranges(animated.held) << '\n';
  if (animated.whole_frames) {
    std::cout << base::format_fixed(animated.fps, animated.fps == std::floor(animated.fps) ? 0 : 3)
              << " fps: set it in Blender before importing, then keys are on whole frames\n";
  }
  if (animated.rest) std::cout << animation::explain(*animated.rest) << '\n';
  if (!animated.eyes.blinks.empty()) {
    std::cout << animated.eyes.blinks.size() << " blinks, in which the points close by "
              << base::format_fixed(100 * animated.eyes.full_dip, 0) << " % of the usual opening\n";
  }
  for (std::size_t i = 0; i < animated.unmatched.size(); ++i) {
    std::cout << "no control for " << base::shown_name(animated.unmatched[i]);
    const std::string nearest = i < animated.nearest.size() ? animated.nearest[i] : std::string();
    if (!nearest.empty()) std::cout << "; the nearest is " << base::shown_name(nearest);
    std::cout << '\n';
  }
}

/// A file may hold the scores of blend shapes and the points of a face: the points, where it has them and the model has
/// none of the shapes.
base::Result<io::FormattedTrack> points_for(const document::Document& document, const AnimateArguments& arguments,
                                            io::FormattedTrack read) {
  const auto* values = std::get_if<animation::WeightTrack>(&read.track);
  if (values == nullptr || !arguments.map.empty()) return read;
  const document::Model model = document::model_of(document);
  for (const std::string& name : values->names) {
    if (tracking::is_driven(model, name)) return read;
  }
  auto points = read_track(arguments.track, io::track_format_named("mediapipe"), picture_size(arguments.picture));
  if (points && std::holds_alternative<animation::PointTrack>(points->track)) return points;
  return read;
}

int animate(const AnimateArguments& arguments) {
  files::FileRoles files;
  files.reads(arguments.model);
  files.reads(arguments.track);
  files.reads(arguments.curves);
  if (io::track_format_named(arguments.map) == nullptr) files.reads(arguments.map);
  if (const auto fits = files.writes(arguments.out, "-o"); !fits) return files::report(fits.error(), arguments.out);
  const bool motion_alone = arguments.out.ends_with(".vrma");
  if (!io::keeps_everything(arguments.out) && !motion_alone) {
    return files::report(
        {"animations are not kept in such a file", "",
         "name the output " + io::extensions_that_keep_everything() + ", or .vrma, which holds the motion alone"},
        arguments.out);
  }
  const auto document = files::load_document(arguments.model, files::NamedBy::user, arguments.orientation);
  if (!document) return files::report(document.error(), arguments.model);
  std::optional<base::Result<io::MapFile>> map;
  if (!arguments.map.empty()) map = load_map(arguments.map);
  if (map && !*map) return files::report(map->error(), arguments.map);
  auto input = read_track(arguments.track, map ? (*map)->format : nullptr, picture_size(arguments.picture));
  if (input) input = points_for(*document, arguments, std::move(input).value());
  if (!input) return files::report(input.error(), arguments.track);
  if (!map) map = io::read_bundled_map(*input->format);
  if (!*map) return files::report(map->error(), arguments.track);
  auto curves = load_curves(arguments.curves);
  if (!curves) return files::report(curves.error(), arguments.curves);

  const tracking::AnimateOptions options = options_of(arguments, std::move(curves).value());
  FrameClock clock(frame_count(input->track));
  tracking::AnimateInput blamed{};
  const auto animated = tracking::animate(*document, std::move(input->track), **map, options, clock.watch(), &blamed);
  const double solve_us = clock.median_us();
  for (const std::string& pointer : (*map)->skipped) {
    files::warn(pointer + " is not known and was skipped", arguments.map);
  }
  if (!animated) return files::report(animated.error(), blamed_file(arguments, blamed));
  if (auto saved = files::save_as_it_came(animated->document, arguments.out, files::SaveNotes::loud, arguments.glb);
      !saved)
    return files::report(saved.error(), arguments.out);
  for (const std::string& note : document->model->notes) files::warn(note, arguments.model);
  for (const std::string& note : animated->notes) files::warn(note, arguments.track);
  if (arguments.json) {
    std::cout << serve::animation_json(*animated, solve_us).dump_as_made() << '\n';
  } else {
    print(*animated, solve_us);
  }
  return k_success;
}

void add_options(const Command& command, AnimateArguments& arguments) {
  command.add_option("MODEL", arguments.model, "Model with controls").required();
  add_orientation_options(command, arguments.orientation);
  command
      .add_option(
          "--track", arguments.track,
          "OpenFace CSV (points or action units), MediaPipe landmarks or blend shapes (JSON or CSV), 68 points (.pts, "
          "a folder of them, or CSV), curves (JSON), ARKit blend shapes of Live Link Face or Audio2Face (CSV or "
          "JSON, also without names), iFacialMocap and VMC (text), .vmd, a motion of a figure (.vrma), or mouth cues "
          "of " +
              io::cue_format_names())
      .required();
  command.add_option(
      "--map", arguments.map,
      std::string("Map file, or a bundled map: ").append(io::track_format_names("")) +
          " (default: by the track); that of "
          "curves takes brow_R, eyelid_upper_R, eyelid_lower_R (and _L), lip_upper, lip_lower, "
          "lip_upper_inner, lip_lower_inner, and nose_bridge, nose_base, eye_corners_R and _L for the head");
  command.add_option("--curves", arguments.curves, "JSON file of curves of the model that the map may name");
  command
      .add_option("-o", arguments.out,
                  "Write the animated model, " + io::extensions_that_keep_everything() + "; its motion alone, .vrma")
      .required();
  command.add_option("--head", arguments.head, "Turn of the head: drop it or apply it (default: as the map says)")
      .one_of({"drop", "apply"});
  command
      .add_option(
          "--neutral", arguments.neutral,
          "Frame, from 0, in which the face is at rest; its values are subtracted (default: of points, chosen from the "
          "clip)")
      .check(number_range(0, 1e6), "0 to 1000000");
  command
      .add_option("--tremor", arguments.tremor_px,
                  "How far the tracker's points shake, px; 0 leaves them (default: 1, less for small faces)")
      .check(number_range(0.0, 1000.0), "0 to 1000");
  command.add_option("--smooth", arguments.smooth_s, "Smooth over so many seconds to each side, without lag")
      .check(number_range(0.0, 60.0), "0 to 60")
      .show_default();
  command.add_option("--confidence", arguments.least_confidence, "Hold frames of less confidence, 0 to 1")
      .check(number_range(0.0, 1.0), "0 to 1")
      .show_default();
  command.add_option("--fps", arguments.fps, "Keys at so many even frames a second; the take keeps its length")
      .check(number_range(0.1, 10000.0), "0.1 to 10000");
  command
      .add_option("--stretch", arguments.stretch,
                  "Frames follow each other at this rate, whatever the track says of its times; the length changes")
      .check(number_range(0.1, 10000.0), "0.1 to 10000");
  command.add_option("--picture", arguments.picture, "WIDTHxHEIGHT of the video in px, for normalised coordinates")
      .check(check_picture, "WxH");
  command.add_flag("--units", arguments.units,
                   "Take what the tracker says of action units (AU12, ...) as evidence beside its points");
  command.add_flag("--json", arguments.json, "Print one JSON object");
  add_tolerance_option(command, arguments.glb);
}

}  // namespace

Subcommand animate_subcommand() {
  return subcommand<AnimateArguments>(
      "animate", files::Rights::no_programs, "Makes keyframes from the curves that a face tracker saw", add_options,
      animate, {"penpose animate face.glb --track track.json -o clip.glb", "keyframes from a tracked face"},
      {"penpose animate face.glb --track track.json --smooth 0.1 -o clip.glb --json", "steadier, and for scripts"},
      {{"--picture", Completes::nothing}});
}

}  // namespace penpose::cli
