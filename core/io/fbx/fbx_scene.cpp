#include "core/io/fbx/fbx_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/base/math.h"
#include "core/geometry/space.h"

namespace penpose::io {
namespace {

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
  for (const FbxRecord& one : list->records) {
    if (one.text(0) == name) return &one;
  }
  return nullptr;
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

/// Angles in degrees, the first letter of the order turned first.
glm::dmat4 turned(const glm::dvec3& angles, int order) {
  constexpr std::array<std::array<int, 3>, 6> k_orders{
      {{0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {1, 0, 2}, {2, 0, 1}, {2, 1, 0}}};
  // The seventh order, "spheric", turns as the first one does.
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
  for (const FbxRecord& record : objects->records) {
    const std::int64_t id = record.whole(0);
    if (id == 0 || scene.number_.contains(id)) continue;
    scene.number_[id] = scene.objects_.size();
    scene.objects_.push_back({id, plain_name(record.text(1)), record.name, std::string(record.text(2)), &record});
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
  const FbxRecord* record = property_record(*object.record, name);
  return record == nullptr ? otherwise : record->number(4);
}

glm::dvec3 FbxScene::vector(const FbxObject& object, std::string_view name, glm::dvec3 otherwise) {
  const FbxRecord* record = property_record(*object.record, name);
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

FbxTransform transform_of(const FbxObject& node) {
  return {FbxScene::vector(node, "Lcl Translation", glm::dvec3(0)),
          FbxScene::vector(node, "Lcl Rotation", glm::dvec3(0)), FbxScene::vector(node, "Lcl Scaling", glm::dvec3(1))};
}

glm::dmat4 local_matrix(const FbxObject& node, const FbxTransform& values) {
  const auto vector = [&](const char* name) { return FbxScene::vector(node, name, glm::dvec3(0)); };
  // Another order, and rotations before and after its own, count where the rotation is active, and not for limits
  // alone.
  const bool around = FbxScene::property(node, "RotationActive", 0) != 0.0 &&
                      FbxScene::property(node, "RotationSpaceForLimitOnly", 0) == 0.0;
  const int order = around ? choice_of(FbxScene::property(node, "RotationOrder", 0), 6, 0) : 0;
  const auto around_turn = [&](const char* name) { return turned(around ? vector(name) : glm::dvec3(0), 0); };
  const glm::dvec3 turn_pivot = vector("RotationPivot");
  const glm::dvec3 scale_pivot = vector("ScalingPivot");
  return moved(values.translation + vector("RotationOffset") + turn_pivot) * around_turn("PreRotation") *
         turned(values.rotation, order) * glm::transpose(around_turn("PostRotation")) *
         moved(vector("ScalingOffset") + scale_pivot - turn_pivot) * scaled(values.scaling) * moved(-scale_pivot);
}

FbxLocal parts_of(const glm::dmat4& local) {
  FbxLocal parts;
  parts.translation = glm::dvec3(local[3]);
  glm::dmat3 turn(local);
  for (int i = 0; i < 3; ++i) parts.scale[i] = geometry::length(turn[i]);
  if (glm::determinant(turn) < 0.0) parts.scale.x = -parts.scale.x;
  for (int i = 0; i < 3; ++i) turn[i] = parts.scale[i] != 0.0 ? turn[i] / parts.scale[i] : glm::dmat3(1)[i];
  const glm::dquat q = glm::quat_cast(turn);
  const double length = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  if (length > 0.0 && std::isfinite(length))
    parts.rotation = glm::dquat(q.w / length, q.x / length, q.y / length, q.z / length);
  return parts;
}

glm::dmat4 geometric_matrix(const FbxObject& node) {
  return moved(FbxScene::vector(node, "GeometricTranslation", glm::dvec3(0))) *
         turned(FbxScene::vector(node, "GeometricRotation", glm::dvec3(0)), 0) *
         scaled(FbxScene::vector(node, "GeometricScaling", glm::dvec3(1)));
}

}  // namespace penpose::io
