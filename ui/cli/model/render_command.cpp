#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "core/base/numbers.h"
#include "core/base/text/closest_name.h"
#include "core/base/text/letters.h"
#include "core/document/features/feature_curves.h"
#include "core/document/look.h"
#include "core/document/time/animation_sampling.h"
#include "core/io/model/model_formats.h"
#include "core/io/picture_lines/svg/write_svg_lines.h"
#include "core/io/project/case_file.h"
#include "core/tracking/line_drawing.h"
#include "ui/cli/draw_option.h"
#include "ui/cli/model/picture_options.h"
#include "ui/cli/number_range.h"
#include "ui/cli/orientation_option.h"
#include "ui/cli/progress.h"
#include "ui/cli/subcommand.h"
#include "ui/files/file_roles.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"
#include "ui/files/process/kept_memory.h"
#include "ui/film/frame_name.h"
#include "ui/render/appearance.h"
#include "ui/render/light/baked_light.h"
#include "ui/render/renderer.h"

namespace penpose::cli {
namespace {

constexpr double k_most_turns = 1e6;

struct RenderOptions {
  std::string model;
  io::Orientation orientation;
  std::vector<std::string> assignments;
  std::optional<double> time_s;
  std::string animation;
  bool frames = false;
  double fps = 24;
  PictureOptions picture;
  std::string output;
  bool wireframe = false;
  bool plain = false;
  bool clay = false;
  bool matcap = false;
  bool shadows = false;
  bool curves = false;
  bool lines = false;
  std::string cases;
  std::string case_name;
  std::string draw;
};

std::vector<render::CurveDrawing> named_curves(const document::Model& model,
                                               std::span<const geometry::ModelPoint> positions) {
  std::vector<render::CurveDrawing> drawings;
  for (const document::NamedCurve& curve : model.curves) {
    render::CurveDrawing drawing;
    for (const mesh::MeshPoint& point : curve.points) {
      drawing.points.push_back(mesh::position_of(point, model.mesh->triangles(), positions));
    }
    drawings.push_back(std::move(drawing));
  }
  return drawings;
}

/// The curves of one case as they lie on the posed model, and where the references should be.
base::Result<std::vector<render::CurveDrawing>> case_curves(const RenderOptions& options, const document::Model& model,
                                                            std::span<const geometry::ModelPoint> positions) {
  const auto bytes = files::read_file(options.cases, files::k_most_text_bytes);
  if (!bytes) return bytes.error();
  const auto file = io::read_cases(*bytes);
  if (!file) return file.error();
  if (auto fits = io::check_cases(*file, model, io::TargetForm::drawn); !fits) return fits.error();
  const auto found = std::find_if(file->cases.begin(), file->cases.end(),
                                  [&](const auto& one) { return one.name == options.case_name; });
  if (found == file->cases.end()) {
    std::vector<std::string> names;
    for (const auto& one : file->cases) names.push_back(one.name);
    const auto close = base::closest_name(options.case_name, names);
    return base::Error{"there is no case \"" + options.case_name + "\"", "--case",
                       close ? "did you mean " + *close + "?" : "name one of the file"};
  }
  std::vector<render::CurveDrawing> drawings;
  const auto on_surface = [&](std::span<const std::uint32_t> vertices, render::CurveKind kind) {
    render::CurveDrawing& drawing = drawings.emplace_back();
    drawing.kind = kind;
    for (const std::uint32_t v : vertices) drawing.points.push_back(positions[v]);
  };
  for (const auto& constraint : found->constraints) on_surface(constraint.vertices, render::CurveKind::constraint);
  for (const auto& reference : found->references) on_surface(reference.vertices, render::CurveKind::reference);
  for (const auto& reference : found->references) {
    render::CurveDrawing& drawing = drawings.emplace_back();
    drawing.kind = render::CurveKind::target;
    drawing.points = reference.target;
  }
  return drawings;
}

/// Says what cannot be drawn: what the file's reader knows, and what came out when it was drawn.
void warn_of_undrawn(const RenderOptions& options, const document::Model& model, render::Renderer& renderer) {
  std::vector<std::string> undrawn = renderer.take_undrawn();
  if (options.clay || options.matcap) return;
  if (model.look) undrawn.insert(undrawn.begin(), model.look->undrawn.begin(), model.look->undrawn.end());
  if (!undrawn.empty()) files::warn(document::undrawn_note(undrawn), options.model);
}

/// Draws the model as it is posed and writes the picture.
int draw(const RenderOptions& options, const document::Model& model, render::Renderer& renderer,
         const render::Appearance& appearance, const geometry::Camera& camera, const std::string& output) {
  const render::PosedMesh posed = render::posed_mesh(model);
  std::vector<render::CurveDrawing> curves;
  if (options.curves) curves = named_curves(model, document::posed_positions(model));
  if (!options.cases.empty()) {
    const auto drawings = case_curves(options, model, document::posed_positions(model));
    if (!drawings) return files::report(drawings.error(), options.cases);
    curves.insert(curves.end(), drawings->begin(), drawings->end());
  }
  render::Scene scene = render::scene_of(model, posed, appearance);
  scene.curves = curves;
  scene.wireframe = options.wireframe;
  scene.clay = options.clay;
  scene.matcap = options.matcap;
  const auto image = renderer.render(scene, camera);
  if (!image) return files::report(image.error(), options.model);
  const auto png = render::encode_png(*image);
  if (!png) return files::report(png.error(), output);
  if (auto written = files::write_file(output, *png); !written) return files::report(written.error(), output);
  return k_success;
}

/// Draws the model's features and contours as an SVG and writes it. What has no face has contours alone.
int draw_lines(const RenderOptions& options, const document::Model& model, const geometry::Camera& camera) {
  const auto features = document::feature_curves_of(model, intent::measure_whole_model(*model.rig), {});
  if (!features) files::warn(features.error().what + "; the silhouette is drawn alone", options.model);
  const std::string svg = io::write_svg_lines(
      tracking::line_drawing(model, features ? features->curves : std::vector<portrait::FeatureCurve>{}, camera));
  if (auto written = files::write_file(options.output, base::as_bytes(svg)); !written)
    return files::report(written.error(), options.output);
  return k_success;
}

/// The animation that is asked for: by its name, or of those without or of one name by its number from 1; else the
/// first.
base::Result<std::size_t> chosen_animation(const RenderOptions& options, const document::Model& model) {
  if (options.animation.empty()) return std::size_t{0};
  const auto& animations = model.animations;
  const auto named = [&](const document::Animation& one) { return one.name == options.animation; };
  const auto found = std::find_if(animations.begin(), animations.end(), named);
  if (found != animations.end()) return static_cast<std::size_t>(found - animations.begin());
  const auto number = base::parse_int(options.animation);
  if (number && *number >= 1 && static_cast<std::size_t>(*number) <= animations.size()) {
    return static_cast<std::size_t>(*number - 1);
  }
  std::vector<std::string> names;
  for (const document::Animation& one : animations) names.push_back(one.name);
  const auto close = base::closest_name(options.animation, names);
  return base::Error{"the model has no animation \"" + options.animation + "\"", "--animation",
                     close ? "did you mean " + *close + "?" : "`penpose info` lists the animations"};
}

/// The model at a moment of the animation that comes first, with what --set says on top.
base::Result<document::Model> moment_of(const RenderOptions& options, const document::Model& model,
                                        std::optional<double> time_s) {
  base::Result<document::Model> moment = model;
  if (time_s) moment = document::model_at(model, document::sample(model, model.animations.front(), *time_s));
  if (!moment) return moment;
  for (const std::string& assignment : options.assignments) {
    if (auto set = files::set_parameter(*moment, assignment); !set) return set.error();
  }
  return moment;
}

/// Sequences go into a folder of their own, which need not be there yet.
base::Status make_folder_of(const std::string& output) {
  const std::filesystem::path folder = std::filesystem::path(output).parent_path();
  if (folder.empty()) return base::Done{};
  std::error_code code;
  std::filesystem::create_directories(folder, code);
  if (!code && !std::filesystem::is_directory(folder, code) && !code) {
    code = std::make_error_code(std::errc::not_a_directory);
  }
  if (!code) return base::Done{};
  return base::Error{"its folder cannot be made (" + code.message() + ")", "", "name another folder"};
}

int run_render(const RenderOptions& options) {
  files::FileRoles files(options.frames ? files::FileRoles::Output::prints : files::FileRoles::Output::silent);
  for (const std::string& input : {options.model, options.picture.camera, options.cases}) files.reads(input);
  if (const auto fits = files.writes(options.output, "-o"); !fits) return files::report(fits.error(), options.output);
  if (options.lines && options.output != "-" && !base::lower_case(options.output).ends_with(".svg")) {
    return files::report({"lines are written as SVG", "-o", "name a .svg file"}, options.output);
  }
  files::keep_little_memory();
  // Asked for first: what OpenGL needs is much, and not every driver says when it is not there. Lines need none.
  auto renderer = options.lines ? base::Result<std::unique_ptr<render::Renderer>>(nullptr)
                                : render::make_offscreen_renderer(render::way_of(options.draw));
  if (!renderer) return files::report(renderer.error());
  auto model = files::load_model(options.model, files::NamedBy::user, options.orientation);
  if (!model) return files::report(model.error(), options.model);
  const char* needs_animation = options.time_s               ? "--time"
                                : options.frames             ? "--frames"
                                : !options.animation.empty() ? "--animation"
                                                             : nullptr;
  if (needs_animation != nullptr && model->animations.empty()) {
    return files::report(
        {"the model has no animation", needs_animation, std::string("leave ") + needs_animation + " out"},
        options.model);
  }
  if (!model->animations.empty()) {
    const auto chosen = chosen_animation(options, *model);
    if (!chosen) return files::report(chosen.error(), options.model);
    std::swap(model->animations.front(), model->animations[*chosen]);
  }
  const bool begins = options.frames || (!options.animation.empty() && !options.time_s);
  const auto first = moment_of(options, *model, begins ? std::optional(0.0) : options.time_s);
  if (!first) return files::report(first.error(), options.model);
  const auto camera = make_camera(options.picture, *first, options.time_s.has_value());
  if (!camera) return files::report(camera.error(), options.picture.camera);
  if (options.lines) return draw_lines(options, *first, *camera);
  render::AppearanceOptions look;
  look.recognise = !options.plain;
  render::Appearance appearance = render::make_appearance(*first, look);
  if (options.shadows) appearance.light = render::bake_light(*first, appearance);
  if (!options.frames) {
    const int status = draw(options, *first, **renderer, appearance, *camera, options.output);
    if (status == k_success) warn_of_undrawn(options, *first, **renderer);
    return status;
  }
  const double duration = document::duration_s(model->animations.front());
  const double last = std::round(duration * options.fps);
  if (!(last < k_most_turns)) {
    return files::report({"the animation has too many frames", "--fps", "choose a lower rate"}, options.model);
  }
  const auto count = static_cast<std::size_t>(last) + 1;
  if (auto made = make_folder_of(options.output); !made) return files::report(made.error(), options.output);
  Progress progress("rendering", count);
  for (std::size_t f = 0; f < count; ++f) {
    const auto moment = moment_of(options, *model, static_cast<double>(f) / options.fps);
    if (!moment) return files::report(moment.error(), options.model);
    const std::string picture = film::frame_name(options.output, f + 1);
    if (files.is_read(picture)) return files::report({"is read by this command", "-o", "choose another name"}, picture);
    const int status = draw(options, *moment, **renderer, appearance, *camera, picture);
    if (status != k_success) return status;
    if (f == 0) warn_of_undrawn(options, *model, **renderer);
    progress.advance();
  }
  return k_success;
}

void add_render_options(const Command& command, RenderOptions& options) {
  command.add_option("MODEL", options.model, io::names_read() + " file").required();
  command.add_option("--set", options.assignments, "NAME=VALUE: a parameter of the pose; may be given many times")
      .one_value_a_time();
  const Option time =
      command.add_option("--time", options.time_s, "second of the model's first animation, or of --animation")
          .check(number_range(-1e6, 1e6), "-1000000 to 1000000");
  command.add_option("--animation", options.animation,
                     "name of the animation of --time and --frames, or its number from 1 (default: the first); at its "
                     "first moment where neither is given");
  const Option frames =
      command
          .add_flag("--frames", options.frames,
                    "one picture a frame of the animation: OUT0001.png, OUT0002.png, ... as Blender names them; ### "
                    "at the end of OUT says how many digits; the folder is made if it is not there")
          .excludes(time);
  command.add_option("--fps", options.fps, "frames a second of --frames")
      .check(number_range(0.1, 1000.0), "0.1 to 1000")
      .show_default();
  add_orientation_options(command, options.orientation);
  add_picture_options(command, options.picture);
  add_draw_option(command, options.draw);
  const Option wireframe = command.add_flag("--wireframe", options.wireframe, "draw the edges too");
  const Option clay =
      command.add_flag("--clay", options.clay, "the shape alone, without textures and colours of vertices");
  const Option matcap = command.add_flag("--matcap", options.matcap, "the shape in the light of a ball");
  const Option shadows =
      command.add_flag("--shadows", options.shadows, "with soft shadows, in cavities and on the ground");
  const Option plain = command.add_flag("--plain", options.plain,
                                        "the file's materials only: do not tell eyes and teeth apart by shape");
  const Option curves = command.add_flag("--curves", options.curves, "draw the curves that the model carries");
  const Option cases = command.add_option("--cases", options.cases, "file of posing cases; draws the curves of one");
  const Option case_name = command.add_option("--case", options.case_name, "which case of the file");
  cases.needs(case_name);
  case_name.needs(cases);
  const Option lines = command.add_flag(
      "--lines", options.lines, "draw lines alone, as an SVG: the features of the face by their names, and contours");
  for (const Option& other : {frames, wireframe, clay, matcap, shadows, plain, curves, cases}) lines.excludes(other);
  command.add_option("-o,--output", options.output, "PNG file to write, or SVG with --lines").required();
}

}  // namespace

Subcommand render_subcommand() {
  return subcommand<RenderOptions>(
      "render", files::Rights::no_programs, "Draws a picture of a model", add_render_options, run_render,
      {"penpose render builtin:demo --set jaw=0.4 --view front -o jaw.png", "a picture"},
      {"penpose render clip.glb --frames --size 320x320 -o frames/clip", "frames/clip0001.png, ... for ffmpeg"},
      {{"-o", Completes::files, {".png", ".svg"}}});
}

}  // namespace penpose::cli
