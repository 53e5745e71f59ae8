#include "ui/cli/track/animate_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>

#include "core/base/json/json.h"
#include "core/base/math.h"
#include "core/base/numbers.h"
#include "core/base/text/shown_text.h"
#include "core/document/document_hash.h"
#include "core/document/time/animation_building.h"
#include "core/geometry/rotation.h"
#include "core/tracking/head_stand.h"
#include "core/tracking/track_setup.h"
#include "core/tracking/weight_animation.h"
#include "ui/cli/commands.h"
#include "ui/cli/number_range.h"
#include "ui/cli/pose/tolerance_option.h"
#include "ui/cli/progress.h"
#include "ui/cli/track/track_input.h"
#include "ui/files/file_roles.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"
#include "ui/files/save_model.h"

namespace penpose::cli {
namespace {

using json::Json;

struct AnimateArguments {
  io::GlbOptions glb;
  std::string model;
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
  std::string picture;
  bool units = false;
  bool json = false;
};

/// What is written, whatever the track was.
struct Animated {
  std::vector<double> times_s;
  std::vector<rig::Pose> poses;
  std::vector<std::size_t> held;
  std::vector<std::string> notes;
  std::optional<animation::RestChoice> rest;
  animation::EyeMotion eyes;
  std::vector<std::string> unmatched;  ///< names of the track that the model has no control for
  std::vector<document::Stand> stands;
  std::vector<animation::HeadTurn> head;  ///< as seen in the picture; empty for tracks of values
  geometry::ModelPoint pivot{0};
  double solve_us = 0;
};

struct LoadedMap {
  io::MapFile map;
  bool bundled = false;
};

base::Result<LoadedMap> load_map(const std::string& path) {
  const auto bytes = files::read_file(path, files::k_most_text_bytes);
  if (!bytes) return bytes.error();
  auto map = io::read_map_file(*bytes);
  if (!map) return map.error();
  return LoadedMap{std::move(map).value(), false};
}

base::Result<LoadedMap> load_bundled(const io::TrackFormat& format) {
  auto map = io::read_map_file(base::as_bytes(io::bundled_map(format.name)));
  if (!map) return map.error();
  return LoadedMap{std::move(map).value(), true};
}

base::Result<std::vector<io::VertexCurve>> load_landmarks(const std::string& path) {
  if (path.empty()) return std::vector<io::VertexCurve>();
  const auto bytes = files::read_file(path, files::k_most_text_bytes);
  if (!bytes) return bytes.error();
  return io::read_landmarks(*bytes);
}

base::Result<Animated> from_points(const document::Model& model, const animation::PointTrack& track,
                                   const LoadedMap& map, const std::vector<io::VertexCurve>& landmarks,
                                   const AnimateArguments& arguments, bool apply_head) {
  Animated animated;
  auto setup = tracking::make_setup(model, track, map.map, map.bundled, landmarks, animated.notes);
  if (!setup) return setup.error();
  const bool said = map.bundled && setup->points.stable.empty();
  if (apply_head && !said && setup->points.stable.size() < 2) {
    animated.notes.emplace_back(
        setup->points.stable.empty()
            ? "the head cannot be followed and stays still: the map lists no stable points; "
              "list two or more in \"stable\""
            : "the head's turn cannot be followed, only its shift: the map lists a single stable "
              "point; list two or more in \"stable\"");
  }
  if (arguments.neutral.value_or(0) >= track.frames.size()) {
    return base::Error{"there is no frame " + std::to_string(*arguments.neutral) + "; the track has " +
                           std::to_string(track.frames.size()),
                       "--neutral", "frames count from 0"};
  }
  if (arguments.units) {
    setup->units = tracking::unit_controls(model, track);
    if (setup->units.empty()) {
      animated.notes.emplace_back("--units: the track has no action units that the model has controls for");
    }
  }
  setup->neutral = arguments.neutral;
  setup->tremor_px = arguments.tremor_px;
  setup->smooth_s = arguments.smooth_s;
  setup->least_confidence = arguments.least_confidence;
  const auto camera = geometry::frame_box(document::rest_world_box(model), {1000, 1000}, 0);
  using Clock = std::chrono::steady_clock;
  std::vector<double> times_us;
  Clock::time_point before;
  Progress progress("animating", track.frames.size());
  auto result = animation::animate_track(*model.rig, track, *setup, camera, [&](bool done) {
    if (!done) {
      before = Clock::now();
      return;
    }
    times_us.push_back(std::chrono::duration<double, std::micro>(Clock::now() - before).count());
    progress.advance();
  });
  progress.finish();
  if (!result) return result.error();
  if (apply_head) {
    animated.pivot = tracking::head_pivot(*model.rig, *setup, *result, camera);
    animated.stands = tracking::head_stands(*result, animated.pivot, camera, arguments.smooth_s);
  }
  std::sort(times_us.begin(), times_us.end());
  if (!times_us.empty()) animated.solve_us = times_us[times_us.size() / 2];
  animated.times_s = std::move(result->times_s);
  animated.poses = std::move(result->poses);
  animated.held = std::move(result->held);
  animated.rest = std::move(result->rest);
  animated.eyes = std::move(result->eyes);
  if (animated.rest && !animated.rest->near_rest) {
    animated.notes.emplace_back(
        "nothing in the clip is near rest: the lips never touch; if they do in a frame, name it with --neutral");
  }
  animated.head = std::move(result->still.turns);
  return animated;
}

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

/// The head's turns one by one, degrees (pitch: down, yaw: to the picture's right, roll: clockwise) and px.
Json head_to_json(const std::vector<animation::HeadTurn>& head) {
  Json pitch = Json::array();
  Json yaw = Json::array();
  Json roll = Json::array();
  Json scale = Json::array();
  Json shift = Json::array();
  for (const animation::HeadTurn& turn : head) {
    const glm::dvec3 angles = geometry::xyz_from_quaternion(glm::quat_cast(turn.rotation));
    pitch.push_back(base::degrees(angles.x));
    yaw.push_back(-base::degrees(angles.y));
    roll.push_back(base::degrees(angles.z));
    scale.push_back(turn.scale);
    shift.push_back({turn.shift.x, turn.shift.y});
  }
  return {{"pitch", pitch}, {"yaw", yaw}, {"roll", roll}, {"scale", scale}, {"shift_px", shift}};
}

Json to_json(const Animated& animated, const document::Document& document, double fps) {
  const document::Model& model = *document.model;
  Json parameters = Json::object();
  for (std::size_t i = 0; i < model.rig->parameters().size(); ++i) {
    Json& values = parameters[model.rig->parameters()[i].name] = Json::array();
    for (const rig::Pose& pose : animated.poses) values.push_back(pose[i]);
  }
  return {{"frames", animated.poses.size()},
          {"held", animated.held},
          {"fps", fps},
          {"solve_us", animated.solve_us},
          {"unmatched", animated.unmatched},
          {"blinks", animated.eyes.blinks},
          {"blink_dip", animated.eyes.full_dip},
          {"rest", animated.rest ? Json(animated.rest->frame) : Json()},
          {"parameters", std::move(parameters)},
          {"head", head_to_json(animated.head)},
          {"state", document::DocumentHasher()(document).whole.hex()}};
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

/// Frames at an even rate, whatever times the file gives.
template <typename Track>
void retime(Track& track, double fps) {
  for (std::size_t f = 0; fps > 0 && f < track.frames.size(); ++f) {
    track.frames[f].time_s = static_cast<double>(f) / fps;
  }
}

/// The project with the tracked animation first, which is what viewers play. Keys that it had are an animation of their
/// own after that.
document::Document with_tracked(const document::Document& document, const document::Model& model) {
  document::Document result = document::with_model(document, model);
  result.timeline = std::make_shared<const document::Timeline>();
  result.pose = model.pose;
  return result;
}

int animate(const AnimateArguments& arguments) {
  files::FileRoles files;
  files.reads(arguments.model);
  files.reads(arguments.track);
  files.reads(arguments.curves);
  if (io::track_format_named(arguments.map) == nullptr) files.reads(arguments.map);
  if (const auto fits = files.writes(arguments.out, "-o"); !fits) return files::report(fits.error(), arguments.out);
  if (!arguments.out.ends_with(".glb")) {
    return files::report({"animations are kept in .glb files only", "", "name the output .glb"}, arguments.out);
  }
  auto document = files::load_document(arguments.model);
  if (!document) return files::report(document.error(), arguments.model);
  base::Result<document::Model> model = document::model_of(*document);
  if (model->rig->parameters().empty()) {
    return files::report({"the model has no control to animate", "", "articulate it first"}, arguments.model);
  }
  const io::TrackFormat* named = io::track_format_named(arguments.map);
  std::optional<base::Result<LoadedMap>> map;
  if (!arguments.map.empty()) map = named != nullptr ? load_bundled(*named) : load_map(arguments.map);
  if (map && !*map) return files::report(map->error(), arguments.map);
  auto input = read_track(arguments.track, map ? (*map)->map.format : nullptr, picture_size(arguments.picture));
  if (!input) return files::report(input.error(), arguments.track);
  if (!map) map = load_bundled(*input->format);
  if (!*map) return files::report(map->error(), arguments.track);
  const bool apply_head = arguments.head.empty() ? (*map)->map.apply_head : arguments.head == "apply";

  base::Result<Animated> animated = base::Error{};
  if (auto* weights = std::get_if<animation::WeightTrack>(&input->track)) {
    retime(*weights, arguments.fps);
    tracking::WeightAnimation result =
        tracking::animate_weights(*model, *weights, (*map)->map, apply_head, arguments.smooth_s);
    if (result.unmatched.size() == weights->names.size()) {
      return files::report(
          {"the model has a control for none of its " + std::to_string(weights->names.size()) + " columns", "line 1",
           "write a map whose \"names\" say which control each column drives"},
          arguments.track);
    }
    Animated all;
    all.times_s = std::move(result.times_s);
    all.poses = std::move(result.poses);
    all.held = std::move(result.held);
    all.notes = weights->notes;
    if (arguments.fps <= 0 && !weights->rate_note.empty()) all.notes.push_back(weights->rate_note);
    all.unmatched = std::move(result.unmatched);
    all.notes.insert(all.notes.end(), result.notes.begin(), result.notes.end());
    if (apply_head && result.stands.empty())
      all.notes.emplace_back(
          "the head cannot be followed and stays still: there is no column HeadYaw, HeadPitch or HeadRoll");
    all.stands = std::move(result.stands);
    all.pivot = document::rest_world_box(*model).center();
    animated = std::move(all);
  } else {
    auto& points = std::get<animation::PointTrack>(input->track);
    retime(points, arguments.fps);
    const auto landmarks = load_landmarks(arguments.curves);
    if (!landmarks) return files::report(landmarks.error(), arguments.curves);
    animated = from_points(*model, points, **map, *landmarks, arguments, apply_head);
    if (arguments.fps <= 0 && !points.rate_note.empty()) points.notes.push_back(points.rate_note);
    if (animated) animated->notes.insert(animated->notes.begin(), points.notes.begin(), points.notes.end());
  }
  for (const std::string& pointer : (*map)->map.skipped) {
    files::warn(pointer + " is not known and was skipped", arguments.map);
  }
  const std::string map_name = arguments.map.empty() ? arguments.track : arguments.map;
  if (!animated) return files::report(animated.error(), map_name);

  constexpr double k_off_frame = 0.3;
  const double whole_fps = animation::whole_frame_rate(animated->times_s, k_off_frame);
  if (whole_fps > 0) animated->times_s = animation::at_whole_frames(animated->times_s, whole_fps);
  const double fps = whole_fps > 0 ? whole_fps
                                   : animation::frames_per_second(animated->times_s.front(), animated->times_s.back(),
                                                                  animated->times_s.size());
  model->animations.insert(model->animations.begin(),
                           document::make_animation(*model, "tracked", animated->times_s, animated->poses));
  // Joints are turned by the animation itself; a pose of theirs would be added to it.
  model->pose = rig::rest_pose(*model->rig);
  std::copy_n(animated->poses.front().begin(), document::weight_count(*model), model->pose.begin());
  if (!animated->stands.empty()) {
    auto with_head =
        document::with_stand(std::move(model).value(), 0, animated->pivot, animated->times_s, animated->stands);
    if (!with_head) return files::report(with_head.error(), arguments.model);
    model = std::move(with_head);
  }
  const document::Document result = with_tracked(*document, *model);
  if (auto saved = files::save_as_it_came(result, arguments.out, files::SaveNotes::loud, arguments.glb); !saved)
    return files::report(saved.error(), arguments.out);
  for (const std::string& note : document->model->notes) files::warn(note, arguments.model);
  for (const std::string& note : animated->notes) files::warn(note, arguments.track);
  if (arguments.json) {
    std::cout << to_json(*animated, result, fps).dump_as_made() << '\n';
    return k_success;
  }
  std::cout << animated->poses.size() << " frames at " << base::format_fixed(fps, 2) << " a second, "
            << animated->held.size() << " held, " << base::format_fixed(animated->solve_us / 1000.0, 2)
            << " ms a frame\n";
  if (!animated->held.empty()) std::cout << "held: " << ranges(animated->held) << '\n';
  if (whole_fps > 0) {
    std::cout << base::format_fixed(whole_fps, whole_fps == std::floor(whole_fps) ? 0 : 3)
              << " fps: set it in Blender before importing, then keys are on whole frames\n";
  }
  if (animated->rest) std::cout << animation::explain(*animated->rest) << '\n';
  if (!animated->eyes.blinks.empty()) {
    std::cout << animated->eyes.blinks.size() << " blinks, in which the points close by "
              << base::format_fixed(100 * animated->eyes.full_dip, 0) << " % of the usual opening\n";
  }
  for (const std::string& name : animated->unmatched) std::cout << "no control for " << base::shown_name(name) << '\n';
  return k_success;
}

}  // namespace

void add_animate_command(CLI::App& app, int& status) {
  auto arguments = std::make_shared<AnimateArguments>();
  CLI::App* command = app.add_subcommand("animate", "Makes keyframes from the curves that a face tracker saw");
  command->add_option("MODEL", arguments->model, "Model with controls")->required();
  command
      ->add_option(
          "--track", arguments->track,
          "OpenFace CSV, MediaPipe landmarks (JSON or CSV), 68 points (.pts, a folder of them, or CSV), curves "
          "(JSON) or ARKit blend shapes (CSV)")
      ->required();
  command->add_option(
      "--map", arguments->map,
      std::string("Map file, or a bundled map: ").append(io::track_format_names("")) +
          " (default: by the track); that of "
          "curves takes brow_R, eyelid_upper_R, eyelid_lower_R (and _L), lip_upper, lip_lower, "
          "lip_upper_inner, lip_lower_inner, and nose_bridge, nose_base, eye_corners_R and _L for the head");
  command->add_option("--curves", arguments->curves, "JSON file of curves of the model that the map may name");
  command->add_option("-o", arguments->out, "Write the animated model, .glb")->required();
  command->add_option("--head", arguments->head, "Turn of the head: drop it or apply it (default: as the map says)")
      ->check(CLI::IsMember({"drop", "apply"}));
  command
      ->add_option("--neutral", arguments->neutral,
                   "Frame, from 0, in which the face is at rest (default: chosen from the clip)")
      ->check(CLI::Validator(number_range(0, 1e6), "0 to 1000000"));
  command
      ->add_option("--tremor", arguments->tremor_px,
                   "How far the tracker's points shake, px; 0 leaves them (default: 1, less for small faces)")
      ->check(CLI::Validator(number_range(0.0, 1000.0), "0 to 1000"));
  command->add_option("--smooth", arguments->smooth_s, "Smooth over so many seconds to each side, without lag")
      ->check(CLI::Validator(number_range(0.0, 60.0), "0 to 60"))
      ->capture_default_str();
  command->add_option("--confidence", arguments->least_confidence, "Hold frames of less confidence, 0 to 1")
      ->check(CLI::Validator(number_range(0.0, 1.0), "0 to 1"))
      ->capture_default_str();
  command->add_option("--fps", arguments->fps, "Frames a second, instead of the track's own times")
      ->check(CLI::Validator(number_range(0.1, 10000.0), "0.1 to 10000"));
  command->add_option("--picture", arguments->picture, "WIDTHxHEIGHT of the video in px, for normalised coordinates")
      ->check(CLI::Validator(check_picture, "WxH"));
  command->add_flag("--units", arguments->units,
                    "Take what the tracker says of action units (AU12, ...) as evidence beside its points");
  command->add_flag("--json", arguments->json, "Print one JSON object");
  add_tolerance_option(*command, arguments->glb);
  command->callback([arguments, &status] { status = animate(*arguments); });
}

}  // namespace penpose::cli
