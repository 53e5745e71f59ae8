#include "core/io/fbx/fbx_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/base/math.h"
#include "core/geometry/space.h"

namespace penpose::io {
namespace {

/// More properties of one object are not looked at.
constexpr std::ptrdiff_t k_most_properties = 5000;
constexpr double k_degree = 0.017453292519943295;

/// "Name\0\1Class" of binary files and "Class::Name" of text files.
std::string plain_name(std::string_view name) {
  if (const std::size_t cut = name.find(std::string_view("\0\1", 2)); cut != std::string_view::npos)
    return std::string(name.substr(0, cut));
  if (const std::size_t cut = name.find("::"); cut != std::string_view::npos) return std::string(name.substr(cut + 2));
  return std::string(name);
}

const FbxRecord* property_record(const FbxRecord& object, std::string_view name) {
  const FbxRecord* list = object.find("Properties70");
  if (list == nullptr) return nullptr;
  // If a property appears twice, the later one counts.
  const auto least = list->records.rend() - list->records.rbegin() > k_most_properties
                         ? list->records.rbegin() + k_most_properties
                         : list->records.rend();
  for (auto one = list->records.rbegin(); one != least; ++one) {
    if (one->text(0) == name) return &*one;
  }
  return nullptr;
}

const FbxRecord* property_record(const FbxObject& object, std::string_view name) {
  const FbxRecord* own = property_record(*object.record, name);
  return own != nullptr || object.usual == nullptr ? own : property_record(*object.usual, name);
}

/// The template of each kind of object, where its kind has a single one.
std::map<std::string, const FbxRecord*, std::less<>> templates_of(const FbxRecord& root) {
  std::map<std::string, const FbxRecord*, std::less<>> out;
  const FbxRecord* definitions = root.find("Definitions");
  if (definitions == nullptr) return out;
  for (const FbxRecord& type : definitions->records) {
    const FbxRecord* only = type.find("PropertyTemplate");
    if (type.name == "ObjectType" && only != nullptr) out.try_emplace(std::string(type.text(0)), only);
  }
  return out;
}

bool is_of_blender(const FbxRecord& root) {
  const FbxRecord* creator = root.find("Creator");
  if (const FbxRecord* header = root.find("FBXHeaderExtension"); creator == nullptr && header != nullptr)
    creator = header->find("Creator");
  return creator != nullptr && creator->text(0).find("Blender") != std::string_view::npos;
}

glm::dmat4 about(int axis, double degrees) {
  const double s = base::sin(degrees * k_degree);
  const double c = base::cos(degrees * k_degree);
  glm::dmat4 m(1);
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  m[u][u] = c;
  m[u][v] = s;
  m[v][u] = -s;
  m[v][v] = c;
  return m;
}

/// The seventh order, "spheric", turns as the first one does.
constexpr std::array<std::array<int, 3>, 6> k_orders{
    {{0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {1, 0, 2}, {2, 0, 1}, {2, 1, 0}}};

glm::dmat4 turned(const glm::dvec3& angles, int order) {
  const auto& axes = k_orders[static_cast<std::size_t>(order)];
  return about(axes[2], angles[axes[2]]) * about(axes[1], angles[axes[1]]) * about(axes[0], angles[axes[0]]);
}

glm::dmat4 moved(const glm::dvec3& by) { return glm::translate(glm::dmat4(1), by); }
glm::dmat4 scaled(const glm::dvec3& by) { return glm::scale(glm::dmat4(1), by); }

/// A number below `count` that stands for one of so many; any other is `otherwise`.
int choice_of(double number, int count, int otherwise) {
  return number >= 0.0 && number < count ? static_cast<int>(number) : otherwise;
}

}  // namespace

base::Result<FbxScene> FbxScene::make(const FbxTree& tree) {
  const FbxRecord* objects = tree.root.find("Objects");
  if (objects == nullptr) return base::Error{"the file has no objects", "", "export it again with its meshes"};
  FbxScene scene;
  scene.settings_ = tree.root.find("GlobalSettings");
  scene.of_blender_ = is_of_blender(tree.root);
  const auto usual = templates_of(tree.root);
  for (const FbxRecord& record : objects->records) {
    const std::int64_t id = record.whole(0);
    if (id == 0 || scene.number_.contains(id)) continue;
    scene.number_[id] = scene.objects_.size();
    const auto own = usual.find(record.name);
    scene.objects_.push_back({id, plain_name(record.text(1)), record.name, std::string(record.text(2)), &record,
                              own == usual.end() ? nullptr : own->second});
  }
  if (const FbxRecord* connections = tree.root.find("Connections")) {
    for (const FbxRecord& one : connections->records) {
      if (one.name != "C") continue;
      const std::string property(one.text(3));
      scene.parts_[one.whole(2)].push_back({one.whole(1), property});
      scene.wholes_[one.whole(1)].push_back({one.whole(2), property});
    }
  }
  return scene;
}

const FbxObject* FbxScene::object(std::int64_t id) const {
  const auto at = number_.find(id);
  return at == number_.end() ? nullptr : &objects_[at->second];
}

std::vector<const FbxObject*> FbxScene::parts_of(std::int64_t id, std::string_view kind, std::string_view use) const {
  std::vector<const FbxObject*> out;
  const auto list = parts_.find(id);
  if (list == parts_.end()) return out;
  for (const FbxConnection& one : list->second) {
    const FbxObject* part = object(one.object);
    if (part != nullptr && part->kind == kind && (use.empty() || part->use == use)) out.push_back(part);
  }
  return out;
}

const std::vector<FbxConnection>& FbxScene::wholes_of(std::int64_t id) const {
  static const std::vector<FbxConnection> none;
  const auto at = wholes_.find(id);
  return at == wholes_.end() ? none : at->second;
}

const FbxObject* FbxScene::part_at(std::int64_t id, std::string_view property) const {
  const auto list = parts_.find(id);
  if (list == parts_.end()) return nullptr;
  for (const FbxConnection& one : list->second) {
    if (one.property == property) return object(one.object);
  }
  return nullptr;
}

const FbxObject* FbxScene::parent_of(const FbxObject& node) const {
  for (const FbxConnection& one : wholes_of(node.id)) {
    const FbxObject* whole = object(one.object);
    if (one.property.empty() && whole != nullptr && whole->kind == "Model") return whole;
  }
  return nullptr;
}

double FbxScene::setting(std::string_view name, double otherwise) const {
  const FbxRecord* record = settings_ == nullptr ? nullptr : property_record(*settings_, name);
  return record == nullptr ? otherwise : record->number(4);
}

double FbxScene::property(const FbxObject& object, std::string_view name, double otherwise) {
  const FbxRecord* record = property_record(object, name);
  return record == nullptr ? otherwise : record->number(4);
}

glm::dvec3 FbxScene::vector(const FbxObject& object, std::string_view name, glm::dvec3 otherwise) {
  const FbxRecord* record = property_record(object, name);
  return record == nullptr ? otherwise : glm::dvec3(record->number(4), record->number(5), record->number(6));
}

glm::dmat4 FbxScene::to_world() const {
  const double unit = setting("UnitScaleFactor", 1.0) / 100.0;  // centimetres of one unit of the file
  const auto axis = [&](const char* name, const char* sign, int otherwise) {
    glm::dvec3 row{0};
    row[choice_of(setting(name, otherwise), 3, otherwise)] = setting(sign, 1.0) < 0.0 ? -1.0 : 1.0;
    return row;
  };
  const glm::dvec3 right = axis("CoordAxis", "CoordAxisSign", 0);
  const glm::dvec3 up = axis("UpAxis", "UpAxisSign", 1);
  const glm::dvec3 front = axis("FrontAxis", "FrontAxisSign", 2);
  glm::dmat4 world(1);
  for (int column = 0; column < 3; ++column)
    world[column] = glm::dvec4(right[column], up[column], front[column], 0.0) * (unit > 0.0 ? unit : 1.0);
  return glm::determinant(glm::dmat3(world)) != 0.0 ? world : scaled(glm::dvec3(unit > 0.0 ? unit : 1.0));
}

FbxNodeTransform::FbxNodeTransform(const FbxObject& node) {
  const auto vector = [&](const char* name, double otherwise = 0.0) {
    return FbxScene::vector(node, name, glm::dvec3(otherwise));
  };
  still_ = {vector("Lcl Translation"), vector("Lcl Rotation"), vector("Lcl Scaling", 1.0)};
  // Another order, and rotations before and after its own, count where the rotation is active, and not for limits
  // alone.
  if (FbxScene::property(node, "RotationActive", 0) != 0.0 &&
      FbxScene::property(node, "RotationSpaceForLimitOnly", 0) == 0.0) {
    order_ = fbx_rotation_order(node);
    before_ = turned(vector("PreRotation"), 0);
    after_ = glm::transpose(turned(vector("PostRotation"), 0));
  }
  turn_offset_ = vector("RotationOffset");
  turn_pivot_ = vector("RotationPivot");
  scale_offset_ = vector("ScalingOffset");
  scale_pivot_ = vector("ScalingPivot");
}

glm::dmat3 fbx_rotation(const glm::dvec3& angles, int order) { return glm::dmat3(turned(angles, order)); }

glm::dvec3 fbx_angles(const glm::dmat3& m, int order) {
  const auto& axes = k_orders[static_cast<std::size_t>(order)];
  const int a = axes[0];
  const int b = axes[1];
  const int c = axes[2];
  const double sign = (a + 1) % 3 == b ? 1.0 : -1.0;
  glm::dvec3 angles(0);
  const double sine = std::clamp(-sign * m[a][c], -1.0, 1.0);
  angles[b] = base::atan2(sine, std::sqrt(std::max(0.0, 1.0 - sine * sine)));
  if (std::abs(sine) < 1.0 - 1e-12) {
    angles[a] = base::atan2(sign * m[b][c], m[c][c]);
    angles[c] = base::atan2(sign * m[a][b], m[a][a]);
  } else {
    angles[a] = base::atan2(-sign * m[c][b], m[b][b]);
  }
  return angles / k_degree;
}

glm::dquat fbx_turn(const glm::dmat3& rotation) {
  const glm::dquat q = glm::quat_cast(rotation);
  const double length = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  if (!(length > 0.0) || !std::isfinite(length)) return {1, 0, 0, 0};
  return {q.w / length, q.x / length, q.y / length, q.z / length};
}

int fbx_rotation_order(const FbxObject& node) { return choice_of(FbxScene::property(node, "RotationOrder", 0), 6, 0); }

bool FbxNodeTransform::has_pivots() const {
  return turn_pivot_ != glm::dvec3(0) || scale_pivot_ != glm::dvec3(0) || scale_offset_ != glm::dvec3(0);
}

FbxLocal FbxNodeTransform::at(const FbxTransform& values) const {
  FbxLocal parts;
  parts.rotation = before_ * glm::dmat3(turned(values.rotation, order_)) * after_;
  parts.scale = values.scaling;
  parts.translation = values.translation + turn_offset_ + turn_pivot_ +
                      parts.rotation * (scale_offset_ + scale_pivot_ - turn_pivot_ - values.scaling * scale_pivot_);
  return parts;
}

glm::dmat4 FbxLocal::matrix() const {
  glm::dmat4 m(rotation);
  for (int i = 0; i < 3; ++i) m[i] *= scale[i];
  m[3] = glm::dvec4(translation, 1.0);
  return m;
}

double FbxScene::frames_per_second() const {
  constexpr std::array<double, 19> k_rates{30, 120,         100,         60,          50,          48,   30,
                                           30, 30. / 1.001, 30. / 1.001, 25,          24,          1000, 24. / 1.001,
                                           0,  96,          72,          60. / 1.001, 120. / 1.001};
  const double rate = k_rates[static_cast<std::size_t>(choice_of(setting("TimeMode", 0), 19, 0))];
  const double own = rate > 0.0 ? rate : setting("CustomFrameRate", 30);
  return own >= 1.0 && own <= 1000.0 ? own : 30.0;
}

glm::dmat4 geometric_matrix(const FbxObject& node) {
  return moved(FbxScene::vector(node, "GeometricTranslation", glm::dvec3(0))) *
         turned(FbxScene::vector(node, "GeometricRotation", glm::dvec3(0)), 0) *
         scaled(FbxScene::vector(node, "GeometricScaling", glm::dvec3(1)));
}

}  // namespace penpose::io
