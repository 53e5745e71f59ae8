#include <algorithm>
#include <iomanip>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/json/json.h"
#include "core/base/numbers.h"
#include "core/base/text/closest_name.h"
#include "core/base/text/shown_text.h"
#include "core/document/document_hash.h"
#include "core/document/expressions.h"
#include "core/document/suggestion.h"
#include "ui/cli/number_range.h"
#include "ui/cli/pose/keyed_poses.h"
#include "ui/cli/pose/leave_out_table.h"
#include "ui/cli/progress.h"
#include "ui/cli/subcommand.h"
#include "ui/files/file_roles.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"
#include "ui/files/save_model.h"

namespace penpose::cli {
namespace {

using json::Json;

struct SuggestArguments {
  std::string model;
  std::vector<std::string> keys;
  std::size_t every = 1;
  std::vector<std::string> assignments;
  std::vector<std::string> holds;
  std::optional<double> strength;
  bool leave_one_out = false;
  std::string out;
  bool json = false;
};

/// The parameters that `--hold` names: one, or with a * at its end all that begin so. Ascending.
base::Result<std::vector<std::size_t>> held_by_name(const std::vector<std::string>& holds,
                                                    std::span<const rig::Parameter> parameters) {
  std::vector<std::size_t> held;
  for (const std::string& hold : holds) {
    const bool many = hold.ends_with('*');
    const std::string begin = hold.substr(0, hold.size() - (many ? 1 : 0));
    const std::size_t before = held.size();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (many ? parameters[i].name.starts_with(begin) : parameters[i].name == begin) held.push_back(i);
    }
    if (held.size() > before) continue;
    std::vector<std::string> names;
    for (const rig::Parameter& parameter : parameters) names.push_back(parameter.name);
    const auto close = base::closest_name(begin, names);
    return base::Error{"the model has no parameter " + std::string(many ? "that begins so" : "of that name"),
                       "--hold " + hold, close ? "did you mean " + *close + "?" : "`penpose info` lists the names"};
  }
  std::sort(held.begin(), held.end());
  held.erase(std::unique(held.begin(), held.end()), held.end());
  return held;
}

/// The keys to learn from: the model's own, or those of the files that were named. Names the file that is to blame.
base::Result<std::vector<document::PoseKey>> gather_keys(const SuggestArguments& arguments,
                                                         const document::Document& document, std::string& blamed) {
  blamed = arguments.model;
  if (arguments.keys.empty()) return keyed_poses(document, arguments.every);
  std::vector<document::PoseKey> all;
  for (const std::string& path : arguments.keys) {
    blamed = path;
    const auto other = load_posed(path);
    if (!other) return other.error();
    auto keys = keyed_poses(*other, arguments.every);
    if (!keys) return keys;
    keys = carried_over(std::move(*keys), other->model->rig->parameters(), document.model->rig->parameters());
    if (!keys) return keys;
    all.insert(all.end(), keys->begin(), keys->end());
    if (all.size() > k_most_keyed_poses) {
      return base::Error{"with it there are more than " + std::to_string(k_most_keyed_poses) + " key poses", "",
                         "take fewer with --every"};
    }
  }
  return all;
}

/// Of the controls that a key moves from rest, the half that move the model most: what is drawn first.
std::vector<std::size_t> greater_half(const rig::Rig& rig, const rig::Pose& key) {
  const auto parameters = rig.parameters();
  const rig::Pose rest = rig::rest_pose(rig);
  std::vector<rig::ModelPoint> still(rig.vertex_count());
  std::vector<rig::ModelPoint> moved(rig.vertex_count());
  rig.evaluate(rest, still);
  std::vector<std::pair<double, std::size_t>> ways;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (key[i] == rest[i]) continue;
    rig::Pose pose = rest;
    pose[i] = key[i];
    rig.evaluate(pose, moved);
    double way = 0;
    for (std::size_t v = 0; v < still.size(); ++v) {
      const double d = geometry::distance(still[v], moved[v]);
      way += d * d;
    }
    if (way > 0) ways.emplace_back(-way, i);
  }
  std::sort(ways.begin(), ways.end());
  ways.resize((ways.size() + 1) / 2);
  std::vector<std::size_t> held;
  held.reserve(ways.size());
  for (const auto& [way, i] : ways) held.push_back(i);
  std::sort(held.begin(), held.end());
  return held;
}

int leave_out(const SuggestArguments& arguments, const document::Document& document,
              const std::vector<document::PoseKey>& keys, const std::vector<std::size_t>& named) {
  const rig::Rig& rig = *document.model->rig;
  // A key is asked for once for itself and once for every other.
  std::map<rig::Pose, std::vector<std::size_t>> halves;
  const prior::HeldOf held = [&](const rig::Pose& key) {
    if (!named.empty()) return named;
    const auto [found, is_new] = halves.try_emplace(key);
    if (is_new) found->second = greater_half(rig, key);
    return found->second;
  };
  std::vector<rig::Pose> poses;
  poses.reserve(keys.size());
  for (const document::PoseKey& key : keys) poses.push_back(key.pose);
  Progress progress("leaving one out", prior::distinct(poses).size());
  const auto rows = prior::leave_one_out(rig, poses, held, arguments.strength, [&] { progress.advance(); });
  progress.finish();
  if (!rows) return files::report(rows.error(), arguments.keys.empty() ? arguments.model : arguments.keys.front());
  if (rows->empty())
    return files::report({"no key moves anything", "", "key poses that differ from rest"}, arguments.model);
  if (arguments.json) {
    print_left_out_json(arguments.model, keys, *rows);
  } else {
    print_left_out(keys, *rows);
  }
  return k_success;
}

void print(const document::Document& document, const document::Suggestion& suggestion) {
  const auto parameters = document.model->rig->parameters();
  std::size_t widest = 0;
  std::size_t moved = 0;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (suggestion.pose[i] == document.pose[i]) continue;
    widest = std::max(widest, base::shown_name(parameters[i].name).size());
    ++moved;
  }
  std::cout << "learned from " << suggestion.keys << " poses, shrunk by " << base::format_fixed(suggestion.shrinkage, 2)
            << "; " << suggestion.command.held.size() << " of " << parameters.size() << " parameters held, " << moved
            << " suggested at strength " << base::format_fixed(suggestion.command.strength, 2) << '\n';
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (suggestion.pose[i] == document.pose[i]) continue;
    std::cout << "  " << std::left << std::setw(static_cast<int>(widest)) << base::shown_name(parameters[i].name)
              << std::right << "  " << base::format_fixed(document.pose[i], 4) << " -> "
              << base::format_fixed(suggestion.pose[i], 4) << '\n';
  }
}

void print_json(const SuggestArguments& arguments, const document::Document& before,
                const document::Suggestion& suggestion) {
  const auto parameters = before.model->rig->parameters();
  Json suggested = Json::object();
  Json all = Json::object();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (suggestion.pose[i] != before.pose[i]) suggested[parameters[i].name] = suggestion.pose[i];
    all[parameters[i].name] = suggestion.pose[i];
  }
  document::Document after = before;
  after.pose = suggestion.pose;
  const Json out = {{"model", arguments.model},          {"keys", suggestion.keys},
                    {"shrinkage", suggestion.shrinkage}, {"strength", suggestion.command.strength},
                    {"held", suggestion.command.held},   {"suggested", std::move(suggested)},
                    {"parameters", std::move(all)},      {"state", document::DocumentHasher()(after).whole.hex()}};
  std::cout << out.dump_as_made() << '\n';
}

/// The document with the pose that `--set` asks for; what was set is held.
base::Status set_all(const SuggestArguments& arguments, document::Document& document, std::vector<std::size_t>& held) {
  document::Model model = *document.model;
  model.pose = document.pose;
  for (const std::string& assignment : arguments.assignments) {
    if (auto set = files::set_parameter(model, assignment); !set) return set;
    const std::string name = assignment.substr(0, assignment.rfind('='));
    const auto number = rig::find_parameter(model.rig->parameters(), name);
    if (number) held.push_back(*number);
    const auto expression = number ? std::nullopt : document::expression_named(model, name);
    for (std::size_t k = 0; expression && k < model.expressions[*expression].values.size(); ++k) {
      held.push_back(model.expressions[*expression].values[k].first);
    }
  }
  document.pose = model.pose;
  return base::Done{};
}

int suggest(const SuggestArguments& arguments) {
  files::FileRoles files;
  files.reads(arguments.model);
  for (const std::string& path : arguments.keys) files.reads(path);
  if (const auto fits = arguments.out.empty() ? base::Done{} : files.writes(arguments.out, "-o"); !fits)
    return files::report(fits.error(), arguments.out);
  auto document = load_posed(arguments.model);
  if (!document) return files::report(document.error(), arguments.model);
  const auto parameters = document->model->rig->parameters();
  auto held = held_by_name(arguments.holds, parameters);
  if (!held) return files::report(held.error(), arguments.model);
  std::string blamed;
  const auto keys = gather_keys(arguments, *document, blamed);
  if (!keys) return files::report(keys.error(), blamed);
  if (arguments.leave_one_out) return leave_out(arguments, *document, *keys, *held);

  if (auto set = set_all(arguments, *document, *held); !set) return files::report(set.error(), arguments.model);
  const std::vector<std::string> posed = document::posed_parameters(*document);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const bool holds = std::find(held->begin(), held->end(), i) != held->end() ||
                       std::find(posed.begin(), posed.end(), parameters[i].name) != posed.end();
    if (holds) names.push_back(parameters[i].name);
  }
  if (names.empty()) {
    return files::report({"nothing is posed in it, so that there is nothing to suggest the rest of", "",
                          "pose a part of it with --set NAME=VALUE, or name what shall stay with --hold"},
                         arguments.model);
  }
  const auto suggestion = document::suggest_rest(*document, *keys, names, arguments.strength);
  if (!suggestion) return files::report(suggestion.error(), blamed);
  if (arguments.json) {
    print_json(arguments, *document, *suggestion);
  } else {
    print(*document, *suggestion);
  }
  if (arguments.out.empty()) return k_success;
  document->pose = suggestion->pose;
  if (auto saved = files::save_as_it_came(*document, arguments.out); !saved)
    return files::report(saved.error(), arguments.out);
  return k_success;
}

void add_options(const Command& command, SuggestArguments& arguments) {
  command.add_option("MODEL", arguments.model, "model, project or session (.session) whose pose is half made")
      .required();
  command
      .add_option("--keys", arguments.keys,
                  "learn from the poses of this project, session or animated model, by the names of its parameters, "
                  "in place of MODEL's own; may be given many times")
      .one_value_a_time();
  command.add_option("--every", arguments.every, "take every so many keys: those of a track are nearly all alike")
      .check(whole_range(1, 1'000'000), "1 to 1000000")
      .show_default();
  const Option set =
      command
          .add_option("--set", arguments.assignments, "NAME=VALUE: a parameter that is posed; may be given many times")
          .one_value_a_time();
  command
      .add_option("--hold", arguments.holds,
                  "a parameter that stays, beside what is posed and locked; mouth* holds all that begin so; may be "
                  "given many times")
      .one_value_a_time();
  command
      .add_option("--strength", arguments.strength,
                  "share of the way, 0 to 1; without it what would have served the keys best, each left out in turn")
      .check(number_range(0, 1), "0 to 1");
  const Option out =
      command.add_option("-o,--output", arguments.out, "write the posed model or project (.glb, .gltf, .obj)");
  command
      .add_flag("--leave-one-out", arguments.leave_one_out,
                "leave each key out, hold of it what --hold says (else the half of its controls that moves the model "
                "most), suggest the rest and print what error is left, in % of how far its pose moves the whole "
                "model, beside not moving the rest and beside the mean of the other keys")
      .excludes(set)
      .excludes(out);
  command.add_flag("--json", arguments.json, "print one JSON object");
}

}  // namespace

Subcommand suggest_subcommand() {
  return subcommand<SuggestArguments>(
      "suggest", files::Rights::no_programs, "Suggests the rest of a pose from poses that are keyed", add_options,
      suggest, {"penpose suggest keyed.glb --set jaw=0.3", "the rest of the face, from the poses that are keyed"},
      {"penpose suggest keyed.glb --leave-one-out", "how well the keyed poses foretell each other"},
      {{"--hold", Completes::nothing}});
}

}  // namespace penpose::cli
