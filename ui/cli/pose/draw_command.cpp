#include <algorithm>
#include <iomanip>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "core/base/json/json.h"
#include "core/base/numbers.h"
#include "core/base/text/shown_text.h"
#include "core/document/document_hash.h"
#include "core/io/project/landmark_file.h"
#include "core/portrait/pose_from_drawing.h"
#include "core/tracking/drawing_start.h"
#include "core/tracking/feature_curves.h"
#include "ui/cli/number_range.h"
#include "ui/cli/subcommand.h"
#include "ui/files/file_roles.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"
#include "ui/files/save_model.h"
#include "ui/render/picture/picture_lines.h"
#include "ui/serve/drawing_json.h"

namespace penpose::cli {
namespace {

using json::Json;

struct DrawArguments {
  std::string model;
  std::string drawing;
  std::string neutral;
  std::string curves;
  double yaw_degrees = 0;
  std::string out;
  bool json = false;
};

base::Result<std::vector<io::VertexCurve>> named_curves(const std::string& path) {
  if (path.empty()) return std::vector<io::VertexCurve>{};
  const auto bytes = files::read_file(path);
  if (!bytes) return bytes.error();
  auto named = io::read_landmarks(*bytes);
  if (named && named->empty()) return base::Error{"it names no curves", "/curves", "name the features of the face"};
  return named;
}

base::Result<io::PictureLines> lines_of(const std::string& path) {
  const auto bytes = files::read_file(path);
  if (!bytes) return bytes.error();
  auto read = render::read_picture_lines(*bytes);
  if (!read) return read.error();
  if (read->lines.empty()) return base::Error{"it has no lines", "", "draw the features of the face as open lines"};
  return read;
}

std::vector<portrait::DrawnLine> points_of(const io::PictureLines& lines) {
  std::vector<portrait::DrawnLine> out;
  for (const io::PictureLine& line : lines.lines) out.push_back(line.points);
  return out;
}

Json lines_json(const io::PictureLines& drawn, const std::vector<portrait::LineRead>& read,
                const std::vector<portrait::FeatureCurve>& curves) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < read.size(); ++i) {
    Json row = {{"index", drawn.lines[i].element}};
    row.update(serve::line_json(read[i], curves));
    rows.push_back(std::move(row));
  }
  return rows;
}

void print(const io::PictureLines& drawn, const portrait::DrawnPose& posed, const document::Document& document,
           const tracking::FeatureCurves& features) {
  const auto& curves = features.curves;
  if (features.found) std::cout << "feature curves were found by the shape of the face\n";
  for (const std::string& name : features.unsure)
    std::cout << "  " << name << " is not sure and not used; --curves names it\n";
  for (std::size_t i = 0; i < posed.read.lines.size(); ++i) {
    const portrait::LineRead& line = posed.read.lines[i];
    std::cout << "line " << drawn.lines[i].element << ": "
              << (line.curve ? base::shown_name(curves[*line.curve].name) : std::string("nothing known"));
    if (line.curve && (line.from > 0.0 || line.to < 1.0)) {
      std::cout << ", " << base::format_fixed(100.0 * line.from, 0) << " to " << base::format_fixed(100.0 * line.to, 0)
                << " % of it";
    }
    std::cout << '\n';
  }
  const auto parameters = document.model->rig->parameters();
  std::size_t moved = 0;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (posed.pose[i] == document.pose[i]) continue;
    ++moved;
    std::cout << "  " << base::shown_name(parameters[i].name) << "  " << base::format_fixed(document.pose[i], 4)
              << " -> " << base::format_fixed(posed.pose[i], 4) << '\n';
  }
  if (moved == 0) std::cout << "the drawing shows the face at rest\n";
}

void print_json(const DrawArguments& arguments, const io::PictureLines& drawn,
                const std::optional<io::PictureLines>& neutral, const portrait::DrawnPose& posed,
                const document::Document& document, const tracking::FeatureCurves& features) {
  const auto& curves = features.curves;
  Json parameters = Json::object();
  for (std::size_t i = 0; i < posed.pose.size(); ++i)
    parameters[document.model->rig->parameters()[i].name] = posed.pose[i];
  document::Document after = document;
  after.pose = posed.pose;
  Json out = {{"model", arguments.model},
              {"drawing", arguments.drawing},
              {"parameters", std::move(parameters)},
              {"lines", lines_json(drawn, posed.read.lines, curves)},
              {"state", document::DocumentHasher()(after).whole.hex()}};
  if (neutral) out["neutral_lines"] = lines_json(*neutral, posed.read.neutral, curves);
  std::cout << out.dump_as_made() << '\n';
}

int draw(const DrawArguments& arguments) {
  files::FileRoles roles;
  roles.reads(arguments.model);
  roles.reads(arguments.drawing);
  if (!arguments.neutral.empty()) roles.reads(arguments.neutral);
  if (!arguments.curves.empty()) roles.reads(arguments.curves);
  if (const auto fits = arguments.out.empty() ? base::Done{} : roles.writes(arguments.out, "-o"); !fits)
    return files::report(fits.error(), arguments.out);
  auto document = files::load_document(arguments.model);
  if (!document) return files::report(document.error(), arguments.model);
  const document::Model& model = *document->model;
  const auto named = named_curves(arguments.curves);
  if (!named) return files::report(named.error(), arguments.curves);
  const intent::WholeModel whole = intent::measure_whole_model(*model.rig);
  const auto features = tracking::feature_curves_of(model, whole, *named);
  if (!features) return files::report(features.error(), named->empty() ? arguments.model : arguments.curves);
  const auto& curves = features->curves;
  const auto drawn = lines_of(arguments.drawing);
  if (!drawn) return files::report(drawn.error(), arguments.drawing);
  portrait::Drawing drawing{points_of(*drawn), {}};
  std::optional<io::PictureLines> neutral;
  if (!arguments.neutral.empty()) {
    auto read = lines_of(arguments.neutral);
    if (!read) return files::report(read.error(), arguments.neutral);
    neutral = std::move(*read);
    drawing.neutral = points_of(*neutral);
  }
  const auto start = tracking::drawing_start(*document, whole);
  const auto camera = portrait::camera_of_drawing(*model.rig, curves, start.pose, arguments.yaw_degrees);
  const auto posed = portrait::pose_from_drawing(*model.rig, whole, curves, drawing, camera, start.pose, start.free);
  if (!posed) return files::report(posed.error(), arguments.drawing);
  if (arguments.json) {
    print_json(arguments, *drawn, neutral, *posed, *document, *features);
  } else {
    print(*drawn, *posed, *document, *features);
  }
  if (arguments.out.empty()) return k_success;
  document->pose = posed->pose;
  if (auto saved = files::save_as_it_came(*document, arguments.out); !saved)
    return files::report(saved.error(), arguments.out);
  return k_success;
}

void add_options(CLI::App& command, DrawArguments& arguments) {
  command.add_option("MODEL", arguments.model, "model or project with a face")->required();
  command
      .add_option("DRAWING", arguments.drawing,
                  "lines of a face, in any order and place: SVG, or a picture of them (PNG, JPEG, WebP)")
      ->required();
  command.add_option("--neutral", arguments.neutral,
                     "the same hand's drawing of the face at rest, in the same view: takes its proportions out");
  command.add_option(
      "--curves", arguments.curves,
      "JSON file of the model's feature curves; without it the model's own, or those found by the shape of the face");
  command.add_option("--yaw", arguments.yaw_degrees, "degrees that the drawing sees the face from beside, about +Y")
      ->check(CLI::Validator(number_range(-360, 360), "-360 to 360"))
      ->capture_default_str();
  command.add_option("-o,--output", arguments.out, "write the posed model or project (.glb, .gltf, .obj)");
  command.add_flag("--json", arguments.json, "print one JSON object");
}

}  // namespace

Subcommand draw_subcommand() {
  return subcommand<DrawArguments>(
      "draw", files::Rights::no_programs, "Poses a face as a drawing of it shows, without labels", add_options, draw,
      {"penpose draw head.glb smile.svg -o smile.glb", "the face takes what the drawing shows"},
      {"penpose draw head.glb smile.png --neutral rest.png --curves curves.json --json",
       "by the same hand's drawing of the face at rest; which line is which, and the pose"},
      {{"DRAWING", Completes::files}});
}

}  // namespace penpose::cli
