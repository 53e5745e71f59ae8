#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/numbers.h"
#include "core/document/look.h"
#include "core/io/model/model_formats.h"
#include "ui/cli/draw_option.h"
#include "ui/cli/model/picture_options.h"
#include "ui/cli/number_range.h"
#include "ui/cli/orientation_option.h"
#include "ui/cli/progress.h"
#include "ui/cli/subcommand.h"
#include "ui/files/file_roles.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"
#include "ui/files/process/stop_signal.h"
#include "ui/files/sound/sound_file.h"
#include "ui/film/film_frames.h"
#include "ui/film/frame_name.h"
#include "ui/film/write_film.h"
#include "ui/render/appearance.h"
#include "ui/render/light/baked_light.h"
#include "ui/render/renderer.h"

namespace penpose::cli {
namespace {

constexpr int k_most_frames = 1'000'000;

/// The view that the camera on the timeline has; three quarters where none is keyed.
constexpr const char* k_own_camera = "camera";

PictureOptions placed(PictureOptions picture) {
  if (picture.view == k_own_camera) picture.view = "three-quarter";
  return picture;
}

struct FilmOptions {
  std::string model;
  io::Orientation orientation;
  std::string output;
  double fps = 24;
  std::optional<int> from;
  std::optional<int> to;
  std::string sheet;
  PictureOptions picture{"1280x720", {}, k_own_camera};
  std::string crop;
  bool numbers = false;
  std::string sound;
  double sound_offset_s = 0;
  bool silent = false;
  bool wireframe = false;
  bool clay = false;
  bool matcap = false;
  bool shadows = false;
  bool light = false;
  std::string onion;
  std::optional<int> onion_every;
  bool onion_faces = false;
  bool progress = false;
  std::string draw;
};

/// WIDTHxHEIGHT+LEFT+TOP.
std::optional<film::PxPart> parse_part(const std::string& text) {
  film::PxPart part;
  int read = 0;
  if (std::sscanf(text.c_str(), "%6dx%6d+%6d+%6d%n", &part.size.width, &part.size.height, &part.left, &part.top,
                  &read) != 4 ||
      static_cast<std::size_t>(read) != text.size()) {
    return std::nullopt;
  }
  if (part.size.width < 1 || part.size.height < 1 || part.left < 0 || part.top < 0) return std::nullopt;
  return part;
}

std::string check_part(const std::string& text) {
  return parse_part(text) ? "" : "write WIDTHxHEIGHT+LEFT+TOP in px, not \"" + text + "\"";
}

/// "keys", or a number: every so many frames.
std::string check_sheet(const std::string& text) {
  const auto number = base::parse_int(text);
  if (text == "keys" || (number && *number >= 1 && *number <= k_most_frames)) return {};
  return "write keys, or a number for every so many frames, not \"" + text + "\"";
}

/// BEFORE,AFTER.
std::optional<render::GhostLook> parse_onion(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) return std::nullopt;
  const auto before = base::parse_int(text.substr(0, comma));
  const auto after = base::parse_int(text.substr(comma + 1));
  const auto fits = [](const auto& count) { return count && *count >= 0 && *count <= render::k_most_ghosts; };
  if (!fits(before) || !fits(after)) return std::nullopt;
  render::GhostLook look;
  look.before = static_cast<int>(*before);
  look.after = static_cast<int>(*after);
  return look;
}

std::string check_onion(const std::string& text) {
  return parse_onion(text) ? "" : "write how many before and after, each 0 to 9, as in 1,2; not \"" + text + "\"";
}

std::optional<film::FilmGhosts> ghosts_of(const FilmOptions& options) {
  if (options.onion.empty()) return std::nullopt;
  render::GhostLook look = *parse_onion(options.onion);
  if (options.onion_faces) look.style = render::GhostStyle::faces;
  if (options.onion_every) look.steps = render::GhostSteps::frames;
  look.every = options.onion_every.value_or(look.every);
  return std::optional<film::FilmGhosts>(std::in_place, look);
}

/// The part of the picture that is filmed.
base::Result<std::optional<film::PxPart>> part_of(const FilmOptions& options) {
  if (options.crop.empty()) return std::optional<film::PxPart>();
  const auto part = parse_part(options.crop);
  const geometry::Viewport whole = size_of(options.picture);
  if (part->left + part->size.width > whole.width || part->top + part->size.height > whole.height) {
    return base::Error{"reaches out of the picture of " + options.picture.size, "--crop",
                       "name a part of it, or a larger --size"};
  }
  return part;
}

base::Result<std::vector<int>> frames_of(const FilmOptions& options, const film::FilmFrames& frames) {
  const int first = options.from.value_or(0);
  const int last = options.to.value_or(frames.last());
  if (last < first) {
    return base::Error{"the last frame, " + std::to_string(last) + ", is before the first", "",
                       "name others with --from and --to"};
  }
  std::vector<int> chosen;
  if (options.sheet == "keys") {
    for (const int frame : frames.keyed()) {
      if (frame >= first && frame <= last) chosen.push_back(frame);
    }
    if (chosen.empty()) {
      return base::Error{"no frame of these is keyed", "--sheet keys", "name every how many frames, or other frames"};
    }
    return chosen;
  }
  const auto step = base::parse_int(options.sheet).value_or(1);
  for (std::int64_t frame = first; frame <= last; frame += step) chosen.push_back(static_cast<int>(frame));
  return chosen;
}

/// The sound that goes with it. The project's own may be gone: the film is silent then. Errors: the one that is named
/// cannot be read.
base::Result<std::optional<film::PlacedSound>> sound_of(const FilmOptions& options,
                                                        const document::Document& document) {
  if (!options.sound.empty()) {
    auto named = files::load_sound(options.sound, {});
    if (!named) return named.error();
    return std::optional(film::PlacedSound{std::move(named->sound), options.sound_offset_s});
  }
  if (options.silent || !document.sound) return std::optional<film::PlacedSound>();
  auto kept = files::load_sound_of(*document.sound, options.model);
  if (!kept) {
    const base::Error silent{kept.error().what + "; the film is silent", kept.error().place, ""};
    files::warn(silent.line(), document.sound->file);
    return std::optional<film::PlacedSound>();
  }
  if (kept->changed) files::warn("the sound is another one than the project was made with", document.sound->file);
  return std::optional(film::PlacedSound{std::move(kept->sound), document.sound->offset_s});
}

base::Result<film::FilmKind> kind_of(const FilmOptions& options) {
  const auto kind = film::kind_of_name(options.output);
  if (!options.sheet.empty() && kind == film::FilmKind::pictures) return film::FilmKind::sheet;
  if (!options.sheet.empty()) return base::Error{"a sheet is one picture", "-o", "name a .png file"};
  if (kind) return *kind;
  return base::Error{"no kind of film ends like this", "-o", "name a .mp4, .webm, .gif or .png file"};
}

/// What is made of a film's progress: a line on a terminal or, for programs that ask for them, lines.
film::Waiting waiting_of(const FilmOptions& options, std::optional<Progress>& shown) {
  film::Waiting waiting;
  waiting.stop = [] { return files::StopSignal::asked(); };
  waiting.progress = [&](std::size_t done, std::size_t all) {
    if (options.progress) {
      std::cout << done << ' ' << all << '\n' << std::flush;
      return;
    }
    if (!shown) shown.emplace("filming", all);
    shown->advance();
  };
  return waiting;
}

/// None of the pictures may be what is read.
base::Status check_outputs(const film::FilmPlan& plan, const files::FileRoles& files) {
  if (plan.kind != film::FilmKind::pictures) return base::Done{};
  for (const int frame : plan.frames) {
    const std::string picture = film::frame_name(plan.output, static_cast<std::size_t>(frame));
    if (files.is_read(picture)) return base::Error{picture + " is read by this command", "-o", "choose another name"};
  }
  return base::Done{};
}

/// What is filmed: of a project of several characters the one that was worked on, with those that are shown beside it.
struct Filmed {
  document::Document document;
  std::vector<film::Beside> others;
};

base::Result<Filmed> filmed(const FilmOptions& options) {
  auto loaded = options.orientation.is_usual() ? files::load_cast(options.model)
                                               : base::Result<std::optional<files::LoadedCast>>(std::nullopt);
  if (!loaded) return loaded.error();
  if (!*loaded) {
    auto document = files::load_document(options.model, files::NamedBy::user, options.orientation);
    if (!document) return document.error();
    return Filmed{std::move(*document), {}};
  }
  files::LoadedCast& cast = **loaded;
  const std::size_t active = cast.cast.active;
  Filmed all;
  for (std::size_t i = 0; i < cast.documents.size(); ++i) {
    const io::CastMember& member = cast.cast.members[i];
    if (i == active || !member.shown) continue;
    const auto there = joined(member.placement, inverse(cast.cast.members[active].placement));
    all.others.push_back({cast.documents[i], there, render::make_appearance(*cast.documents[i].model)});
  }
  all.document = std::move(cast.documents[active]);
  return all;
}

int run_film(const FilmOptions& options) {
  files::FileRoles files(options.progress ? files::FileRoles::Output::prints : files::FileRoles::Output::silent);
  for (const std::string& input : {options.model, options.picture.camera, options.sound}) files.reads(input);
  if (const auto fits = files.writes(options.output, "-o"); !fits) return files::report(fits.error(), options.output);
  const auto kind = kind_of(options);
  if (!kind) return files::report(kind.error(), options.output);
  if (film::row_of(*kind).needs_ffmpeg && !film::has_ffmpeg()) return files::report(film::no_ffmpeg(), options.output);
  const auto part = part_of(options);
  if (!part) return files::report(part.error());
  auto renderer = render::make_offscreen_renderer(render::way_of(options.draw));
  if (!renderer) return files::report(renderer.error());
  auto all = filmed(options);
  if (!all) return files::report(all.error(), options.model);
  const auto sound = sound_of(options, all->document);
  if (!sound) return files::report(sound.error(), options.sound);
  const auto frames = film::FilmFrames::make(std::move(all->document), options.fps, std::move(all->others));
  if (!frames) return files::report(frames.error(), options.model);
  film::FilmPlan plan{*kind, options.output, size_of(options.picture), options.fps, {}, options.numbers};
  if (*part) plan.size = (*part)->size;
  auto chosen = frames_of(options, *frames);
  if (!chosen) return files::report(chosen.error(), options.model);
  plan.frames = std::move(chosen).value();
  if (auto fits = check_outputs(plan, files); !fits) return files::report(fits.error());
  const auto first = frames->at(plan.frames.front());
  if (!first) return files::report(first.error(), options.model);
  const auto camera = make_camera(placed(options.picture), *first, false);
  if (!camera) return files::report(camera.error(), options.picture.camera);
  render::Appearance appearance = render::make_appearance(*first);
  if (options.shadows) appearance.light = render::bake_light(*first, appearance);
  auto ghosts = ghosts_of(options);
  const film::FrameLook look{.camera = *camera,
                             .moves = options.picture.camera.empty() && options.picture.view == k_own_camera,
                             .part = *part,
                             .wireframe = options.wireframe,
                             .matcap = options.matcap,
                             .clay = options.clay,
                             .light = options.light,
                             .ghosts = ghosts ? &*ghosts : nullptr};
  const auto draw = [&](int frame) { return film::draw_frame(*frames, frame, **renderer, appearance, look); };
  std::optional<Progress> shown;
  const files::StopSignal stops;
  const auto written = film::write_film(plan, draw, *sound ? &**sound : nullptr, waiting_of(options, shown));
  shown.reset();
  if (!written) return files::report(written.error(), options.output);
  const auto undrawn = options.clay ? std::vector<std::string>() : (*renderer)->take_undrawn();
  if (!undrawn.empty()) files::warn(document::undrawn_note(undrawn), options.model);
  return k_success;
}

void add_frame_options(const Command& command, FilmOptions& options) {
  const Check frame = whole_range(0, k_most_frames);
  const char* const frames = "0 to 1000000";
  command.add_option("--fps", options.fps, "frames a second")
      .check(number_range(0.1, 1000.0), "0.1 to 1000")
      .show_default();
  command.add_option("--from", options.from, "number of the first frame (default: 0)").check(frame, frames);
  command.add_option("--to", options.to, "number of the last frame (default: that of the last key)")
      .check(frame, frames);
  command
      .add_option("--sheet", options.sheet,
                  "one picture with many frames and their numbers: the keyed ones (keys), or every so many (a number); "
                  "--size is that of each")
      .check(check_sheet, "keys|N");
  command.add_flag("--numbers", options.numbers, "draw each frame's number into its picture");
}

void add_film_options(const Command& command, FilmOptions& options) {
  command.add_option("MODEL", options.model, "project, or a model with an animation: " + io::names_read() + " file")
      .required();
  add_frame_options(command, options);
  add_picture_options(command, options.picture);
  command.add_option("--crop", options.crop, "film a part of the picture of --size alone: WIDTHxHEIGHT+LEFT+TOP in px")
      .check(check_part, "WxH+X+Y");
  const Option sound =
      command.add_option("--sound", options.sound, "WAV, FLAC, OGG, MP3 or AIFF file in place of the project's sound");
  command.add_option("--sound-offset", options.sound_offset_s, "second of the timeline at which --sound begins")
      .check(number_range(-36000, 36000), "-36000 to 36000")
      .needs(sound)
      .show_default();
  command.add_flag("--silent", options.silent, "without the project's sound").excludes(sound);
  add_orientation_options(command, options.orientation);
  add_draw_option(command, options.draw);
  command.add_flag("--wireframe", options.wireframe, "draw the edges too");
  command.add_flag("--clay", options.clay, "the shape alone, without textures and colours of vertices");
  command.add_flag("--matcap", options.matcap, "the shape in the light of a ball");
  command.add_flag("--shadows", options.shadows, "with soft shadows, in cavities and on the ground");
  command.add_flag("--light", options.light, "on a light ground, as the window has it in light colours");
  const Option onion = command.add_option(
      "--onion", options.onion, "show so many faces before and after, at keys: as in 1,2 for one before and two after");
  onion.check(check_onion, "BEFORE,AFTER");
  command.add_option("--onion-every", options.onion_every, "not at keys, but every so many frames")
      .check(whole_range(1, render::k_most_ghost_frames), "1 to 48")
      .needs(onion);
  command.add_flag("--onion-faces", options.onion_faces, "as translucent faces, not as lines alone").needs(onion);
  command.add_flag("--progress", options.progress,
                   "print a line for each picture that is drawn: how many there are, and of how many");
  command
      .add_option("-o,--output", options.output,
                  "file to write: .mp4, .webm or .gif through ffmpeg, .png for pictures (OUT0000.png, ...)")
      .required();
}

}  // namespace

Subcommand film_subcommand() {
  return subcommand<FilmOptions>(
      "film", files::Rights::all, "Writes a film of a project's timeline, with its sound", add_film_options, run_film,
      {"penpose film clip.glb --size 320x320 -o clip.png", "its pictures; clip.mp4, .webm or .gif through ffmpeg"},
      {"penpose film clip.glb --sheet 6 --size 160x160 -o sheet.png", "every sixth frame on one picture"},
      {{"-o", Completes::files, {".mp4", ".webm", ".gif", ".png"}},
       {"--sound", Completes::files, {".wav", ".flac", ".ogg", ".mp3", ".aiff"}}});
}

}  // namespace penpose::cli
