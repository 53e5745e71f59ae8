#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "core/base/json/json.h"
#include "core/base/numbers.h"
#include "core/base/text/shown_text.h"
#include "core/document/commands/apply.h"
#include "core/document/document_hash.h"
#include "core/document/features/feature_curves.h"
#include "ui/cli/number_range.h"
#include "ui/cli/pose/drawing_files.h"
#include "ui/cli/pose/posed_sheet.h"
#include "ui/cli/progress.h"
#include "ui/cli/subcommand.h"
#include "ui/files/file_roles.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"
#include "ui/files/save_model.h"
#include "ui/serve/drawing_json.h"

namespace penpose::cli {
namespace {

using json::Json;

/// What a contour line was taken for.
constexpr const char* k_silhouette = "silhouette";

struct DrawArguments {
  std::string model;
  std::vector<std::string> drawings;
  std::string neutral;
  std::string curves;
  std::optional<double> yaw_degrees;
  double every_s = 1;
  bool silhouette = false;
  std::string out;
  bool json = false;
};

/// A drawing and what it asks for.
struct Sheet {
  std::string file;
  io::PictureLines drawn;
  PosedSheet posed;
  std::optional<double> time_s;  ///< of its key; none: it is no key
};

Json line_json(const LineTaken& line, const std::vector<portrait::FeatureCurve>& curves) {
  if (!line.contour) return serve::line_json(line.read, curves);
  return {{"curve", line.explained ? Json(k_silhouette) : Json()}};
}

Json lines_json(const Sheet& sheet, const std::vector<portrait::FeatureCurve>& curves) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < sheet.posed.lines.size(); ++i) {
    Json row = {{"index", sheet.drawn.lines[i].element}};
    row.update(line_json(sheet.posed.lines[i], curves));
    rows.push_back(std::move(row));
  }
  return rows;
}

Json neutral_json(const io::PictureLines& drawn, const std::vector<portrait::LineRead>& read,
                  const std::vector<portrait::FeatureCurve>& curves) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < read.size(); ++i) {
    Json row = {{"index", drawn.lines[i].element}};
    row.update(serve::line_json(read[i], curves));
    rows.push_back(std::move(row));
  }
  return rows;
}

/// What a line was taken for, in words.
std::string words_of(const LineTaken& line, const std::vector<portrait::FeatureCurve>& curves) {
  if (line.contour) return line.explained ? k_silhouette : "nothing known";
  if (!line.read.curve) return "nothing known";
  std::string words = base::shown_name(curves[*line.read.curve].name);
  if (line.read.from > 0.0 || line.read.to < 1.0) {
    words += ", " + base::format_fixed(100.0 * line.read.from, 0) + " to " +
             base::format_fixed(100.0 * line.read.to, 0) + " % of it";
  }
  if (line.read.lower) words += ", and " + base::shown_name(curves[*line.read.lower].name) + " below";
  return words;
}

void print(const Sheet& sheet, const document::Document& document, const std::vector<portrait::FeatureCurve>& curves) {
  if (sheet.time_s)
    std::cout << base::shown_name(sheet.file) << ": key at " << base::format_double(*sheet.time_s) << " s\n";
  const std::vector<LineTaken>& lines = sheet.posed.lines;
  for (std::size_t i = 0; i < lines.size(); ++i)
    std::cout << "line " << sheet.drawn.lines[i].element << ": " << words_of(lines[i], curves) << '\n';
  const auto parameters = document.model->rig->parameters();
  std::size_t moved = 0;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (sheet.posed.pose[i] == document.pose[i]) continue;
    ++moved;
    std::cout << "  " << base::shown_name(parameters[i].name) << "  " << base::format_fixed(document.pose[i], 4)
              << " -> " << base::format_fixed(sheet.posed.pose[i], 4) << '\n';
  }
  const auto contour = [](const LineTaken& line) { return line.contour; };
  if (std::none_of(lines.begin(), lines.end(),
                   [](const LineTaken& line) { return line.explained || line.read.curve.has_value(); })) {
    std::cout << "no line is a " << (std::all_of(lines.begin(), lines.end(), contour) ? "contour" : "feature")
              << " of this " << (std::all_of(lines.begin(), lines.end(), contour) ? "model" : "face")
              << ", and nothing moves\n";
  } else if (moved == 0) {
    std::cout << "the drawing shows the " << (curves.empty() ? "model" : "face") << " at rest\n";
  }
}

void print(const std::vector<Sheet>& sheets, const document::Document& document,
           const document::FeatureCurves& features) {
  if (features.found) std::cout << "feature curves were found by the shape of the face\n";
  for (const std::string& name : portrait::names_of(features.unsure))
    std::cout << "  " << name << " is not sure and not used; --curves names it\n";
  for (const std::string& name : features.doubtful)
    std::cout << "  " << name << " is not sure; --curves names a better one\n";
  for (const document::NamedCurve& one : document.model->features) {
    const char* how = one.points.empty() ? "is none, as somebody said" : "is as it was corrected";
    std::cout << "  " << base::shown_name(one.name) << ' ' << how << '\n';
  }
  for (const Sheet& sheet : sheets) print(sheet, document, features.curves);
}

/// Adds what one drawing asks for.
void add_sheet(Json& row, const Sheet& sheet, const std::optional<io::PictureLines>& neutral, const rig::Rig& rig,
               const std::vector<portrait::FeatureCurve>& curves) {
  row["drawing"] = sheet.file;
  if (sheet.time_s) row["time_s"] = *sheet.time_s;
  Json parameters = Json::object();
  for (std::size_t i = 0; i < sheet.posed.pose.size(); ++i) parameters[rig.parameters()[i].name] = sheet.posed.pose[i];
  row["parameters"] = std::move(parameters);
  row["lines"] = lines_json(sheet, curves);
  if (neutral) row["neutral_lines"] = neutral_json(*neutral, sheet.posed.neutral, curves);
}

/// `after`: with what was drawn.
void print_json(const DrawArguments& arguments, const std::vector<Sheet>& sheets,
                const std::optional<io::PictureLines>& neutral, const document::Document& after,
                const std::vector<portrait::FeatureCurve>& curves) {
  const rig::Rig& rig = *after.model->rig;
  Json out = {{"model", arguments.model}};
  if (sheets.front().time_s) {
    Json rows = Json::array();
    for (const Sheet& sheet : sheets) {
      Json row = Json::object();
      add_sheet(row, sheet, neutral, rig, curves);
      rows.push_back(std::move(row));
    }
    out["drawings"] = std::move(rows);
  } else {
    add_sheet(out, sheets.front(), neutral, rig, curves);
  }
  out["state"] = document::DocumentHasher()(after).whole.hex();
  std::cout << out.dump_as_made() << '\n';
}

/// The document in the pose of a single drawing, or with a key for each, in the pose of the first of them. Errors: the
/// timeline is too short (place: --every).
base::Result<document::Document> posed_by(const document::Document& document, const std::vector<Sheet>& sheets) {
  document::Document after = document;
  if (!sheets.front().time_s) {
    after.pose = sheets.front().posed.pose;
    return after;
  }
  document::ApplyWorkspace work;
  for (const Sheet& sheet : sheets) {
    after.pose = sheet.posed.pose;
    const std::string name = std::filesystem::path(sheet.file).stem().string();
    auto keyed = document::apply(after, document::SetKey{*sheet.time_s, name}, work);
    if (!keyed) return base::Error{keyed.error().what, "--every", keyed.error().remedy};
    after = std::move(*keyed);
  }
  return document::apply(after, document::GoToTime{*sheets.front().time_s}, work);
}

int draw(const DrawArguments& arguments) {
  std::string blamed;
  const auto named = drawing_files(arguments.drawings, arguments.neutral, blamed);
  if (!named) return files::report(named.error(), blamed);
  // One file poses the model; a folder, or several, are keys.
  const bool keys = *named != arguments.drawings || named->size() > 1;
  files::FileRoles roles;
  roles.reads(arguments.model);
  for (const std::string& file : *named) roles.reads(file);
  if (!arguments.neutral.empty()) roles.reads(arguments.neutral);
  if (!arguments.curves.empty()) roles.reads(arguments.curves);
  if (const auto fits = arguments.out.empty() ? base::Done{} : roles.writes(arguments.out, "-o"); !fits)
    return files::report(fits.error(), arguments.out);
  const auto document = files::load_document(arguments.model);
  if (!document) return files::report(document.error(), arguments.model);
  const document::Model& model = *document->model;
  const intent::WholeModel whole = intent::measure_whole_model(*model.rig);
  std::vector<Sheet> sheets;
  bool features = false;
  for (const std::string& file : *named) {
    auto drawn = read_drawing_file(file);
    if (!drawn) return files::report(drawn.error(), file);
    features = features || !(arguments.silhouette || std::all_of(drawn->lines.begin(), drawn->lines.end(), is_contour));
    sheets.push_back({file, std::move(*drawn), {}, std::nullopt});
  }
  document::FeatureCurves face;
  if (features) {
    const auto vertices = read_curves_file(arguments.curves);
    if (!vertices) return files::report(vertices.error(), arguments.curves);
    auto found = document::feature_curves_of(model, whole, *vertices);
    if (!found) return files::report(found.error(), vertices->empty() ? arguments.model : arguments.curves);
    face = std::move(*found);
  }
  const auto& curves = face.curves;
  std::optional<io::PictureLines> neutral;
  if (!arguments.neutral.empty()) {
    auto read = read_drawing_file(arguments.neutral);
    if (!read) return files::report(read.error(), arguments.neutral);
    neutral = std::move(*read);
    std::erase_if(neutral->lines, is_contour);
    if (neutral->lines.empty())
      return files::report({"it has contours alone", "", "draw the features of the face"}, arguments.neutral);
  }
  SheetReading reading{*document,           whole, curves, {}, arguments.yaw_degrees.value_or(model.front_yaw_degrees),
                       arguments.silhouette};
  if (neutral) {
    for (const io::PictureLine& line : neutral->lines) reading.neutral.push_back(line.points);
  }
  const auto& before = document->timeline->keys;
  const double first_s = before.empty() ? 0.0 : before.back().time_s + arguments.every_s;
  Progress progress("reading drawings", sheets.size());
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    auto posed = posed_sheet(reading, sheets[i].drawn);
    if (!posed) return files::report(posed.error(), sheets[i].file);
    sheets[i].posed = std::move(*posed);
    if (keys) sheets[i].time_s = first_s + arguments.every_s * static_cast<double>(i);
    progress.advance();
  }
  progress.finish();
  const auto after = posed_by(*document, sheets);
  if (!after) return files::report(after.error(), arguments.model);
  if (arguments.json) {
    print_json(arguments, sheets, neutral, *after, curves);
  } else {
    print(sheets, *document, face);
  }
  if (arguments.out.empty()) return k_success;
  if (auto saved = files::save_as_it_came(*after, arguments.out); !saved)
    return files::report(saved.error(), arguments.out);
  return k_success;
}

void add_options(const Command& command, DrawArguments& arguments) {
  command.add_option("MODEL", arguments.model, "model or project with a face, or with anything that moves its contours")
      .required();
  command
      .add_option("DRAWING", arguments.drawings,
                  "lines of a face, in any order and place: SVG, or a picture of them (PNG, JPEG, WebP); several, or a "
                  "folder of them in the order of their names, are keys on the timeline")
      .required();
  command
      .add_option("--every", arguments.every_s,
                  "seconds from one key to the next; the first is at 0, or so long after "
                  "the last key that MODEL has")
      .check(number_range(0.001, 3600), "0.001 to 3600")
      .show_default();
  const Option silhouette = command.add_flag(
      "--silhouette", arguments.silhouette,
      "all lines are contours of the model, of a body too, as `penpose render --lines` draws them; without it those "
      "are whose id begins with silhouette");
  command
      .add_option("--neutral", arguments.neutral,
                  "the same hand's drawing of the face at rest, in the same view: takes its proportions out")
      .excludes(silhouette);
  command
      .add_option("--curves", arguments.curves,
                  "JSON file of the model's feature curves; without it the model's own, or those found by the shape of "
                  "the face")
      .excludes(silhouette);
  command
      .add_option("--yaw", arguments.yaw_degrees,
                  "degrees about +Y from which the drawing sees the model; without it from its front")
      .check(number_range(-360, 360), "-360 to 360");
  command.add_option("-o,--output", arguments.out, "write the posed model or project (.glb, .gltf, .obj)");
  command.add_flag("--json", arguments.json, "print one JSON object");
}

}  // namespace

Subcommand draw_subcommand() {
  return subcommand<DrawArguments>(
      "draw", files::Rights::no_programs, "Poses a model as drawings of it show, without labels", add_options, draw,
      {"penpose draw face.glb smile.svg -o posed.glb", "the face takes what the drawing shows"},
      {"penpose draw face.glb smile.svg --neutral rest.svg --json",
       "by the same hand's drawing of the face at rest; which line is which, and the pose"},
      {{"DRAWING", Completes::files}});
}

}  // namespace penpose::cli
