#include <algorithm>
#include <iomanip>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "core/base/json/json.h"
#include "core/base/numbers.h"
#include "core/base/text/shown_text.h"
#include "core/document/document_hash.h"
#include "core/document/features/feature_curves.h"
#include "core/document/humanoid_rest.h"
#include "core/document/words/control_words.h"
#include "core/intent/model/doubles.h"
#include "core/io/gltf/read/gltf_contents.h"
#include "core/io/model/model_formats.h"
#include "ui/cli/orientation_option.h"
#include "ui/cli/subcommand.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"

namespace penpose::cli {
namespace {

using json::Json;

struct InfoArguments {
  std::string model;
  io::Orientation orientation;
  bool json = false;
};

double duration_s(const document::Animation& animation) {
  double end = 0;
  for (const document::Channel& channel : animation.channels) {
    if (!channel.times_s.empty()) end = std::max(end, channel.times_s.back());
  }
  return end;
}

std::size_t shape_count(const document::Model& model) { return model.shapes ? model.shapes->parameters().size() : 0; }

/// Joints of the file. A reader hangs further ones on a joint that skins bind in several ways; they are no other
/// joints.
std::size_t joint_count(const document::Model& model) {
  if (!model.skeleton) return 0;
  const auto joints = model.skeleton->joints();
  return static_cast<std::size_t>(std::count_if(joints.begin(), joints.end(), [&](const rig::Joint& joint) {
    if (joint.parent < 0 || joint.posable) return true;
    const std::string& parent = joints[static_cast<std::size_t>(joint.parent)].name;
    const bool again = joint.name.starts_with(parent + ".") && joint.translation == glm::dvec3(0) &&
                       joint.rest_rotation == glm::dquat(1, 0, 0, 0) && joint.scale == glm::dvec3(1);
    return !again;
  }));
}

/// What the file holds beside the model; empty where it is no glTF.
io::GltfContents contents_of(const std::string& path) {
  const auto bytes = files::read_plain_file(path);
  return bytes ? io::gltf_contents(*bytes) : io::GltfContents();
}

using Doubles = std::vector<intent::DoubleControl>;

/// What is measured of a model.
struct Measured {
  Doubles doubles;
  std::vector<document::ControlWords> words;  ///< one a parameter
};

Measured measure(const document::Model& model) {
  if (model.rig->parameters().empty()) return {};
  const intent::WholeModel whole = intent::measure_whole_model(*model.rig);
  const auto features = document::feature_curves_of(model, whole, {});
  std::vector<portrait::FeatureCurve> curves;
  if (features) curves = features->curves;
  return {intent::doubles_of(whole), document::control_words(model, whole, curves)};
}

/// Of a file that does not say itself which axis points up: the one that is taken to.
std::string_view up_axis(const InfoArguments& arguments) {
  if (!io::has_open_orientation({}, arguments.model)) return {};
  return arguments.orientation.up == io::Up::z ? "z" : "y";
}

/// Bones of the figure and the names of their joints.
std::vector<std::pair<std::string, std::string>> bones_of(const document::Model& model) {
  const document::Humanoid humanoid = document::humanoid_of(model);
  std::vector<std::pair<std::string, std::string>> bones;
  for (std::size_t b = 0; b < document::k_human_bones; ++b) {
    const auto bone = static_cast<document::HumanBone>(b);
    const auto joint = humanoid.joint(bone);
    if (joint) bones.emplace_back(document::name_of(bone), model.skeleton->joints()[*joint].name);
  }
  return bones;
}

Json to_json(const document::Model& model, const Measured& measured, const io::GltfContents& contents,
             const std::string& state, const std::string& path) {
  Json parts = Json::array();
  for (const mesh::Part& part : model.mesh->parts()) {
    parts.push_back({{"name", part.name},
                     {"first_vertex", part.first_vertex},
                     {"vertices", part.vertex_count},
                     {"faces", part.triangle_count}});
  }
  Json parameters = Json::array();
  for (std::size_t i = 0; i < model.pose.size(); ++i) {
    const rig::Parameter& p = model.rig->parameters()[i];
    parameters.push_back({{"name", p.name},
                          {"minimum", p.minimum},
                          {"maximum", p.maximum},
                          {"rest", p.rest},
                          {"value", model.pose[i]},
                          {"words", measured.words[i].text()}});
  }
  const auto json_of = [](const std::vector<document::NamedCurve>& curves) {
    Json out = Json::array();
    for (const document::NamedCurve& curve : curves)
      out.push_back({{"name", curve.name}, {"points", curve.points.size()}});
    return out;
  };
  Json animations = Json::array();
  for (const document::Animation& animation : model.animations) {
    animations.push_back(
        {{"name", animation.name}, {"channels", animation.channels.size()}, {"duration_s", duration_s(animation)}});
  }
  Json textures = Json::array();
  for (const io::GltfTexture& texture : contents.textures) {
    textures.push_back({{"name", texture.name}, {"type", texture.type}});
  }
  Json twice = Json::array();
  for (const intent::DoubleControl& one : measured.doubles) {
    Json of = Json::array();
    for (const std::size_t k : one.of) of.push_back(model.rig->parameters()[k].name);
    twice.push_back({{"name", model.rig->parameters()[one.parameter].name}, {"of", std::move(of)}});
  }
  Json expressions = Json::array();
  for (const document::Expression& expression : model.expressions) {
    Json values = Json::object();
    for (const auto& [parameter, value] : expression.values) values[model.rig->parameters()[parameter].name] = value;
    expressions.push_back({{"name", expression.name}, {"values", std::move(values)}});
  }
  Json humanoid = Json::object();
  for (const auto& [bone, joint] : bones_of(model)) humanoid[bone] = joint;
  const geometry::Box box = document::rest_world_box(model);
  return {{"model", path},
          {"vertices", model.mesh->vertex_count()},
          {"faces", model.mesh->triangle_count()},
          {"components", model.mesh->component_count()},
          {"parts", std::move(parts)},
          {"blend_shapes", shape_count(model)},
          {"joints", joint_count(model)},
          {"parameters", std::move(parameters)},
          {"doubles", std::move(twice)},
          {"front_yaw_degrees", model.front_yaw_degrees},
          {"humanoid", std::move(humanoid)},
          {"curves", json_of(model.curves)},
          {"features", json_of(model.features)},
          {"animations", std::move(animations)},
          {"expressions", std::move(expressions)},
          {"textures", std::move(textures)},
          {"passed_through", contents.passed_through},
          {"not_understood", contents.not_understood},
          {"bounding_box",
           {{"minimum", {box.minimum.x, box.minimum.y, box.minimum.z}},
            {"maximum", {box.maximum.x, box.maximum.y, box.maximum.z}}}},
          {"notes", model.notes},
          {"state", state}};
}

constexpr std::size_t k_longest_path = 4096;

std::string shown(double value) { return base::format_fixed(value, 4); }
std::string name_or_none(const std::string& name) { return name.empty() ? "(without a name)" : base::shown_name(name); }

void print_parameters(const document::Model& model, const Measured& measured) {
  const auto parameters = model.rig->parameters();
  std::cout << "parameters  " << parameters.size() << " (" << shape_count(model) << " blend shapes, "
            << joint_count(model) << " joints)\n";
  std::size_t widest = 0;
  for (const rig::Parameter& p : parameters) widest = std::max(widest, base::shown_name(p.name).size());
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const rig::Parameter& p = parameters[i];
    std::cout << "  " << std::left << std::setw(static_cast<int>(widest)) << base::shown_name(p.name) << "  "
              << shown(p.minimum) << " .. " << shown(p.maximum);
    if (model.pose[i] != p.rest) std::cout << "  at " << shown(model.pose[i]);
    std::cout << "  " << base::shown_name(measured.words[i].text()) << '\n';
  }
}

/// "smile = smile_L + smile_R"; one that does the same as another: "smile_2 like smile".
void print_doubles(const document::Model& model, const Doubles& doubles) {
  if (doubles.empty()) return;
  const auto parameters = model.rig->parameters();
  std::cout << "doubles     " << doubles.size() << '\n';
  for (const intent::DoubleControl& one : doubles) {
    std::cout << "  " << base::shown_name(parameters[one.parameter].name) << (one.of.size() > 1 ? " = " : " like ");
    for (std::size_t k = 0; k < one.of.size(); ++k)
      std::cout << (k > 0 ? " + " : "") << base::shown_name(parameters[one.of[k]].name);
    std::cout << '\n';
  }
}

/// "humanoid    52 bones; head J_Bip_C_Head, leftEye J_Adj_L_FaceEye": those of the head by their joints.
void print_humanoid(const document::Model& model) {
  const auto bones = bones_of(model);
  if (bones.empty()) return;
  std::cout << "humanoid    " << bones.size() << (bones.size() == 1 ? " bone" : " bones");
  const char* between = "; ";
  for (const auto& [bone, joint] : bones) {
    if (bone != "neck" && bone != "head" && bone != "leftEye" && bone != "rightEye" && bone != "jaw") continue;
    std::cout << between << bone << ' ' << name_or_none(joint);
    between = ", ";
  }
  std::cout << '\n';
}

/// "Blink = 1.0000 Fcl_EYE_Close".
void print_expressions(const document::Model& model) {
  if (model.expressions.empty()) return;
  std::cout << "expressions " << model.expressions.size() << '\n';
  for (const document::Expression& expression : model.expressions) {
    std::cout << "  " << base::shown_name(expression.name) << " =";
    for (std::size_t k = 0; k < expression.values.size(); ++k) {
      const auto& [parameter, value] = expression.values[k];
      std::cout << (k > 0 ? " + " : " ") << shown(value) << ' '
                << base::shown_name(model.rig->parameters()[parameter].name);
    }
    std::cout << '\n';
  }
}

/// Heading and names, nothing where there are none.
void print_list(const char* heading, const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::cout << (i == 0 ? heading : ", ") << base::shown_name(names[i]);
  }
  if (!names.empty()) std::cout << '\n';
}

void print_beside(const io::GltfContents& contents) {
  if (!contents.textures.empty()) std::cout << "textures    " << contents.textures.size() << '\n';
  for (const io::GltfTexture& texture : contents.textures) {
    std::cout << "  " << name_or_none(texture.name) << "  " << base::shown_name(texture.type) << '\n';
  }
  print_list("passed through  ", contents.passed_through);
  print_list("not understood  ", contents.not_understood);
}

void print(const document::Model& model, const Measured& measured, const io::GltfContents& contents,
           const InfoArguments& arguments) {
  const std::string& path = arguments.model;
  const geometry::Box box = document::rest_world_box(model);
  std::cout << base::shown_line(path, k_longest_path) << "\nvertices    " << model.mesh->vertex_count()
            << "\nfaces       " << model.mesh->triangle_count() << "\ncomponents  " << model.mesh->component_count()
            << "\nbox         " << shown(box.minimum.x) << ' ' << shown(box.minimum.y) << ' ' << shown(box.minimum.z)
            << "  to  " << shown(box.maximum.x) << ' ' << shown(box.maximum.y) << ' ' << shown(box.maximum.z) << '\n';
  if (const std::string_view up = up_axis(arguments); !up.empty()) {
    std::cout << "up          " << up << " in the file";
    if (arguments.orientation.left_handed) std::cout << ", left-handed";
    if (arguments.orientation.is_usual() && io::looks_as_if_z_were_up(model)) {
      std::cout << "; if the model lies on its back, z is: --up z";
    }
    std::cout << '\n';
  }
  std::cout << "parts       " << model.mesh->parts().size() << '\n';
  for (const mesh::Part& part : model.mesh->parts()) {
    std::cout << "  " << name_or_none(part.name) << "  " << part.vertex_count << " vertices, " << part.triangle_count
              << " faces\n";
  }
  print_parameters(model, measured);
  print_doubles(model, measured.doubles);
  print_humanoid(model);
  print_expressions(model);
  std::cout << "curves      " << model.curves.size() << '\n';
  for (const document::NamedCurve& curve : model.curves) {
    std::cout << "  " << base::shown_name(curve.name) << "  " << curve.points.size() << " points\n";
  }
  if (!model.features.empty()) std::cout << "corrected   " << model.features.size() << '\n';
  for (const document::NamedCurve& curve : model.features) {
    std::cout << "  " << base::shown_name(curve.name) << "  "
              << (curve.points.empty() ? "none" : std::to_string(curve.points.size()) + " points") << '\n';
  }
  std::cout << "animations  " << model.animations.size() << '\n';
  for (const document::Animation& animation : model.animations) {
    std::cout << "  " << name_or_none(animation.name) << "  " << animation.channels.size() << " channels, "
              << base::format_fixed(duration_s(animation), 2) << " s\n";
  }
  print_beside(contents);
  for (const std::string& note : model.notes)
    std::cout << "note        " << base::shown_line(note, k_longest_path) << '\n';
}

int run_info(const InfoArguments& arguments) {
  const auto document = files::load_document(arguments.model, files::NamedBy::user, arguments.orientation);
  if (!document) return files::report(document.error(), arguments.model);
  const document::Model model = document::model_of(*document);
  const Measured measured = measure(model);
  const io::GltfContents contents = contents_of(arguments.model);
  if (arguments.json) {
    const std::string state = document::DocumentHasher()(*document).whole.hex();
    Json out = to_json(model, measured, contents, state, arguments.model);
    if (const std::string_view up = up_axis(arguments); !up.empty()) {
      out["up"] = Json(up);
      out["up_in_doubt"] = Json(arguments.orientation.is_usual() && io::looks_as_if_z_were_up(model));
    }
    std::cout << out.dump_as_made() << '\n';
  } else {
    print(model, measured, contents, arguments);
  }
  return k_success;
}

void add_options(const Command& command, InfoArguments& arguments) {
  command.add_option("MODEL", arguments.model, io::names_read() + " file").required();
  command.add_flag("--json", arguments.json, "print one JSON object");
  add_orientation_options(command, arguments.orientation);
}

}  // namespace

Subcommand info_subcommand() {
  return subcommand<InfoArguments>(
      "info", files::Rights::reads_only, "Says what is in a model", add_options, run_info,
      {"penpose info face.glb", "what can be posed"},
      {"penpose info builtin:demo --json", "the built-in head with its controls, for scripts"});
}

}  // namespace penpose::cli
