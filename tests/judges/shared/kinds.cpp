#include "tests/judges/shared/kinds.h"

#include <algorithm>
#include <map>

#include "core/base/math.h"
#include "tests/judges/cases/picture.h"
#include "tests/judges/rigs/control_words.h"

namespace penpose::judges {
namespace {

using Sum = std::vector<std::pair<std::string, double>>;
using Names = std::vector<std::string>;

struct NewShape {
  std::string name;
  Sum sum;
  double up = 0;  ///< of the mouth, in halves of its width; instead of a sum
};

struct Recipe {
  std::string name;
  Names kept;
  std::vector<NewShape> made;
  Names cases;
  Names need, accept;  ///< patterns
};

Names joined(Names a, const Names& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}
Names without(const Names& names, const std::string& word) {
  Names out;
  for (const std::string& name : names) {
    if (name.find(word) == std::string::npos) out.push_back(name);
  }
  return out;
}
Sum both(const Sum& sum) {
  Sum out;
  for (const auto& [name, amount] : sum) {
    if (name.back() != '_') {
      out.emplace_back(name, amount);
    } else {
      out.emplace_back(name + "L", amount);
      out.emplace_back(name + "R", amount);
    }
  }
  return out;
}

const std::vector<Recipe>& recipes() {
  static const std::vector<Recipe> all = [] {
    const Names base{"browDown_L",    "browDown_R",   "browInnerUp_L", "browInnerUp_R", "browOuterUp_L",
                     "browOuterUp_R", "eyeBlink_L",   "eyeBlink_R",    "eyeWide_L",     "eyeWide_R",
                     "jawOpen",       "mouthSmile_L", "mouthSmile_R",  "mouthFrown_L",  "mouthFrown_R"};
    const Names wide = joined(base, {"mouthStretch_L", "mouthStretch_R", "mouthPucker"});
    const Names smiles{"smile_08", "smile_15", "smile_22", "smile_30", "smile_line_20"};
    const Names both_corners{"mouthSmile_L", "mouthSmile_R"};
    return std::vector<Recipe>{
        {"kiss_or_ooh",
         base,
         {{"ooh", {{"mouthPucker", 0.85}, {"jawOpen", 0.2}}},
          {"emote_kiss", both({{"mouthPucker", 1}, {"eyeBlink_", 0.9}})}},
         {"narrow_10", "narrow_20", "narrow_30", "narrow_40"},
         {"ooh"},
         {}},
        {"open_or_surprise",
         without(base, "jawOpen"),
         {{"open_mouth", {{"jawOpen", 0.9}, {"mouthPucker", 0.35}}},
          {"emote_surprise",
           both({{"jawOpen", 0.55}, {"browInnerUp_", 0.7}, {"browOuterUp_", 0.7}, {"eyeWide_", 0.8}})}},
         {"open_20", "open_45", "open_line_30"},
         {"open_mouth"},
         {}},
        {"small_smile",
         joined(without(base, "Smile"), {"mouthPucker", "mouthFunnel"}),
         {{"smile", both({{"mouthSmile_", 0.22}})}},
         smiles,
         {"smile"},
         {}},
        {"few_shapes", wide, {}, smiles, both_corners, {"mouthStretch_[LR]"}},
        {"mouth_up",
         wide,
         {{"mouth_Up", {}, 0.35}, {"mouth_Down", {}, -0.35}},
         smiles,
         both_corners,
         {"mouthStretch_[LR]"}},
        {"no_brow_shape",
         without(base, "brow"),
         {},
         {"brows_up_08", "brows_up_16", "brows_up_28", "furrow_10", "sad_brows_14"},
         {},
         {"nothing"}},
    };
  }();
  return all;
}

const rig::BlendShape& shape_named(const document::Model& model, const std::string& name) {
  const auto shapes = model.shapes->shapes();
  return *std::find_if(shapes.begin(), shapes.end(), [&](const auto& s) { return s.parameter.name == name; });
}

rig::BlendShape summed(const document::Model& model, const std::string& name, const Sum& sum) {
  std::map<std::uint32_t, ModelVector> deltas;
  for (const auto& [part, amount] : sum) {
    const rig::BlendShape& shape = shape_named(model, part);
    for (std::size_t i = 0; i < shape.vertices.size(); ++i)
      deltas[shape.vertices[i]] += ModelVector(shape.deltas[i]) * amount;
  }
  rig::BlendShape made;
  made.parameter.name = name;
  for (const auto& [v, delta] : deltas) {
    made.vertices.push_back(v);
    made.deltas.emplace_back(delta);
  }
  return made;
}

/// The mouth and what is around it goes up, fading with the distance. `lips`: vertices along all lines of lips.
rig::BlendShape lifted(const document::Model& model, const std::string& name, double halves,
                       const std::vector<std::uint32_t>& lips) {
  const auto rest = posed(model, rig::rest_pose(*model.rig));
  ModelPoint middle{0};
  geometry::Box box;
  for (const std::uint32_t v : lips) {
    middle += rest[v] / static_cast<double>(lips.size());
    box.add(rest[v]);
  }
  const double half = 0.5 * (box.maximum.x - box.minimum.x);
  const std::uint32_t first = shape_named(model, "jawOpen").vertices.front();
  std::vector<glm::dmat4> matrices(model.skeleton->joints().size());
  const rig::Pose still(model.skeleton->parameters().size(), 0.0);
  model.skeleton->joint_matrices(still, matrices);
  const auto to_world = glm::dmat3(model.skeleton->vertex_matrix(first, matrices));
  const ModelVector way = glm::inverse(to_world) * ModelVector{0, halves * half, 0};
  const mesh::Part* face = nullptr;
  for (const mesh::Part& part : model.mesh->parts()) {
    if (part.first_vertex <= first && first < part.first_vertex + part.vertex_count) face = &part;
  }
  rig::BlendShape made;
  made.parameter.name = name;
  for (std::uint32_t v = face->first_vertex; v < face->first_vertex + face->vertex_count; ++v) {
    const ModelVector d = (rest[v] - middle) / ModelVector{1, 0.7, 1} / (1.2 * half);
    made.vertices.push_back(v);
    made.deltas.emplace_back(way * base::exp(-(d.x * d.x + d.y * d.y + d.z * d.z)));
  }
  return made;
}

}  // namespace

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (const Recipe& recipe : recipes()) names.push_back(recipe.name);
  return names;
}

Kind make_kind(const std::string& name) {
  const Recipe& recipe =
      *std::find_if(recipes().begin(), recipes().end(), [&](const Recipe& r) { return r.name == name; });
  document::Model model = read_shared_model("ict_avatar.glb");
  SharedFile file = read_shared_cases("ict_avatar_gestures.json");
  std::vector<std::uint32_t> lips;
  for (const io::PoseCase& one : file.cases.cases) {
    for (const io::CaseReference& reference : one.references) {
      if (reference.curve.find("lip") != std::string::npos)
        lips.insert(lips.end(), reference.vertices.begin(), reference.vertices.end());
    }
  }
  std::vector<rig::BlendShape> shapes;
  for (const std::string& kept : recipe.kept) shapes.push_back(shape_named(model, kept));
  for (const NewShape& made : recipe.made) {
    shapes.push_back(made.up != 0 ? lifted(model, made.name, made.up, lips) : summed(model, made.name, made.sum));
  }
  auto layer = rig::BlendShapes::make(std::move(shapes), model.mesh->vertex_count()).value();
  Kind kind{name, document::with_controls(std::move(model), std::move(layer), nullptr).value(), {}};
  for (const io::PoseCase& one : file.cases.cases) {
    if (!has(recipe.cases, one.name)) continue;
    Gesture gesture;
    gesture.asked = one;
    for (const std::string& pattern : recipe.need) gesture.needed.push_back(controls_like(kind.model, pattern));
    for (const std::string& pattern : recipe.accept) {
      for (std::string& control : controls_like(kind.model, pattern)) gesture.accepted.push_back(std::move(control));
    }
    kind.gestures.push_back(std::move(gesture));
  }
  return kind;
}

}  // namespace penpose::judges
