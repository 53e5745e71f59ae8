#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "core/base/json/json.h"
#include "core/base/numbers.h"
#include "core/base/text/shown_text.h"
#include "core/document/features/feature_curves.h"
#include "core/poses/keep_pose.h"
#include "core/poses/sides.h"
#include "core/poses/take_pose.h"
#include "ui/cli/number_range.h"
#include "ui/cli/subcommand.h"
#include "ui/files/file_roles.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"
#include "ui/files/poses/pose_folder.h"
#include "ui/files/save_model.h"

namespace penpose::cli {
namespace {

using json::Json;

struct PosesArguments {
  std::string model;
  std::string folder;
  std::string keep;
  std::vector<std::string> assignments;
  std::string take;
  std::string by;
  std::string part = "all";
  bool mirror = false;
  double amount = 1;
  std::string out;
  bool json = false;
};

std::string folder_of(const PosesArguments& arguments) {
  return arguments.folder.empty() ? files::usual_pose_folder() : arguments.folder;
}

/// A document's face as poses are measured on it; none where it has no features.
std::optional<poses::FaceMeasure> face_of(const document::Document& document) {
  const auto features =
      document::feature_curves_of(*document.model, intent::measure_whole_model(*document.model->rig), {});
  return features ? poses::FaceMeasure::of(*document.model, features->curves) : std::nullopt;
}

int list(const PosesArguments& arguments) {
  const std::string folder = folder_of(arguments);
  const auto all = files::read_pose_folder(folder);
  if (!all) return files::report(all.error(), folder);
  if (all->empty() && !arguments.json)
    files::warn("no pose is in this library yet: keep one with --keep NAME, or under Poses in the window", folder);
  Json listed = Json::array();
  for (const auto& [path, pose] : *all) {
    if (!pose) {
      files::warn(pose.error().line(), path);
      continue;
    }
    if (arguments.json) {
      Json one = Json::object();
      one["name"] = pose->name;
      one["model"] = pose->model;
      one["file"] = path;
      listed.push_back(std::move(one));
    } else {
      std::cout << base::shown_name(pose->name) << "  of " << base::shown_name(pose->model) << "  " << path << '\n';
    }
  }
  if (arguments.json) std::cout << listed.dump_as_made() << '\n';
  return k_success;
}

int keep(const PosesArguments& arguments, const document::Document& document) {
  document::Model model = *document.model;
  model.pose = document.pose;
  for (const std::string& assignment : arguments.assignments) {
    if (auto set = files::set_parameter(model, assignment); !set) return files::report(set.error(), "--set");
  }
  const auto face = face_of(document);
  std::vector<poses::KeptLine> lines;
  if (face && model.pose == document.pose)
    lines = poses::lines_of(document, *face, [](document::CurveId) { return true; });
  const std::string name = std::filesystem::path(files::model_name(arguments.model).file).filename().string();
  const auto kept = poses::keep_pose(document, model.pose, arguments.keep, name, face ? &*face : nullptr, lines);
  const auto path = files::add_pose(folder_of(arguments), kept);
  if (!path) return files::report(path.error(), {});
  std::cout << *path << '\n';
  return k_success;
}

/// The pose that is meant: of a file, or of that name in the library.
base::Result<poses::KeptPose> meant_pose(const PosesArguments& arguments) {
  if (arguments.take.ends_with(".json")) {
    const auto bytes = files::read_file(arguments.take, files::k_most_text_bytes);
    if (!bytes) return bytes.error();
    return poses::read_kept_pose(*bytes);
  }
  auto all = files::read_pose_folder(folder_of(arguments));
  if (!all) return all.error();
  for (auto& [path, pose] : *all) {
    if (pose && pose->name == arguments.take) return std::move(pose);
  }
  return base::Error{"the library in " + folder_of(arguments) + " has no pose of that name", "",
                     "penpose poses lists those that it has"};
}

void print(const poses::KeptPose& pose, const poses::TakenPose& taken, const rig::Rig& rig, bool as_json) {
  Json values = Json::object();
  for (const auto& [name, value] : taken.values) {
    const rig::Parameter& one = rig.parameters()[*rig::find_parameter(rig.parameters(), name)];
    if (std::abs(value - one.rest) < 1e-6) continue;
    values[name] = value;
    if (!as_json) std::cout << "    " << base::shown_name(name) << " = " << base::format_fixed(value, 4) << '\n';
  }
  if (!as_json) {
    std::cout << poses::words_of(pose, taken) << '\n';
    return;
  }
  Json out = Json::object();
  out["pose"] = pose.name;
  out["by"] = poses::name_of(taken.way);
  out["left"] = taken.left ? Json(*taken.left) : Json();
  out["values"] = std::move(values);
  out["missing"] = Json(taken.missing);
  out["clamped"] = Json(taken.clamped);
  std::cout << out.dump_as_made() << '\n';
}

int take(const PosesArguments& arguments, document::Document& document) {
  const auto pose = meant_pose(arguments);
  if (!pose) return files::report(pose.error(), arguments.take);
  const auto face = face_of(document);
  const poses::TakeOptions options{poses::part_named(arguments.part).value_or(poses::FacePart::all),
                                   poses::way_named(arguments.by)};
  auto taken = poses::take_pose(*pose, *document.model, face ? &*face : nullptr, options);
  if (!taken) return files::report(taken.error(), arguments.model);
  if (arguments.mirror || arguments.amount != 1)
    taken->values =
        poses::shared_values(*document.model, document.pose, taken->values, {arguments.mirror, arguments.amount});
  print(*pose, *taken, *document.model->rig, arguments.json);
  if (arguments.out.empty()) return k_success;
  document.pose = poses::with_values(*document.model->rig, document.pose, taken->values);
  if (auto saved = files::save_as_it_came(document, arguments.out); !saved)
    return files::report(saved.error(), arguments.out);
  return k_success;
}

int poses_command(const PosesArguments& arguments) {
  if (arguments.keep.empty() && arguments.take.empty()) return list(arguments);
  if (arguments.model.empty())
    return files::report({"a MODEL was expected", "", "name the model that is posed"}, "poses");
  files::FileRoles roles;
  roles.reads(arguments.model);
  if (arguments.take.ends_with(".json")) roles.reads(arguments.take);
  if (const auto fits = arguments.out.empty() ? base::Done{} : roles.writes(arguments.out, "-o"); !fits)
    return files::report(fits.error(), arguments.out);
  auto document = files::load_document(arguments.model);
  if (!document) return files::report(document.error(), arguments.model);
  return arguments.keep.empty() ? take(arguments, *document) : keep(arguments, *document);
}

void add_options(const Command& command, PosesArguments& arguments) {
  command.add_option("MODEL", arguments.model, "model, project or session; without --keep and --take poses are listed");
  command.add_option("--folder", arguments.folder,
                     "the library; without it $XDG_DATA_HOME/penpose/poses or ~/.local/share/penpose/poses");
  const Option keep = command.add_option("--keep", arguments.keep, "keep the pose of MODEL under this name");
  command.add_option("--set", arguments.assignments, "NAME=VALUE: a control of the kept pose; may be given many times")
      .one_value_a_time()
      .needs(keep);
  const Option take = command.add_option(
      "--take", arguments.take, "pose MODEL as this pose of the library, by its name, or as this file (.json)");
  take.excludes(keep);
  command
      .add_option("--by", arguments.by,
                  "names: values of the same controls; effects: what controls do; lines: how it was drawn; without it "
                  "the first of them that fits")
      .one_of({"names", "effects", "lines"})
      .needs(take);
  command.add_option("--part", arguments.part, "what of the pose is taken")
      .one_of({"all", "brows", "eyes", "mouth"})
      .show_default();
  command.add_flag("--mirror", arguments.mirror, "take the pose with left and right exchanged").needs(take);
  command
      .add_option("--amount", arguments.amount, "how much of the way from the pose of MODEL to the pose that is taken")
      .check(number_range(0, 1), "0 to 1")
      .show_default()
      .needs(take);
  command.add_option("-o,--output", arguments.out, "write the posed model or project (.glb, .gltf, .obj)").needs(take);
  command.add_flag("--json", arguments.json, "print JSON");
}

}  // namespace

Subcommand poses_subcommand() {
  return subcommand<PosesArguments>(
      "poses", files::Rights::no_programs, "Lists the library of poses, keeps a pose in it, takes one to any rig",
      add_options, poses_command,
      {"penpose poses face.glb --keep smile --set mouth_corner_L=0.8", "a pose, for every other rig"},
      {"penpose poses face.glb --take smile.pose.json --by effects -o smiling.glb",
       "the controls of this face that do what those of the pose did"},
      {{"--keep", Completes::nothing}, {"--folder", Completes::folders}, {"--take", Completes::files, {"json"}}});
}

}  // namespace penpose::cli
