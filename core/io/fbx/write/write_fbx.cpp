#include "core/io/fbx/write/write_fbx.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <utility>

#include "core/document/look.h"
#include "core/io/fbx/write/fbx_keys.h"
#include "core/io/fbx/write/fbx_pictures.h"
#include "core/io/fbx/write/fbx_writer.h"

namespace penpose::io {
namespace {

class Writer {
 public:
  Writer(const document::Model& model, const WriteOptions& options, WriteReport& report)
      : model_(model), options_(options), pictures_(model, options, report) {
    frames_.a_second = options.fps;
  }
  [[nodiscard]] bool has_fewer_frames() const { return frames_.fewer; }

  std::vector<std::uint8_t> write() {
    add_settings();
    file_.begin("Objects");
    add_joints();
    for (std::size_t i = 0; i < model_.mesh->parts().size(); ++i) add_part(i);
    add_animations();
    file_.end();
    file_.begin("Connections");
    for (const Link& link : links_) {
      file_.begin("C").text(link.property.empty() ? "OO" : "OP").id(link.part).id(link.whole);
      if (!link.property.empty()) file_.text(link.property);
      file_.end();
    }
    file_.end();
    return file_.take();
  }

 private:
  struct Link {
    std::int64_t part = 0, whole = 0;
    std::string property;
  };

  std::int64_t next() { return ++last_id_; }
  void link(std::int64_t part, std::int64_t whole, std::string property = {}) {
    links_.push_back({part, whole, std::move(property)});
  }
  FbxWriter& object(const char* kind, std::int64_t id, std::string_view name, const char* called, const char* use) {
    return file_.begin(kind).id(id).text(FbxWriter::named(name, called)).text(use);
  }
  void property(const char* name, const char* type, const char* label, double value) {
    file_.begin("P").text(name).text(type).text(label).text("A").number(value).end();
  }
  void property(const char* name, std::int32_t value) {
    file_.begin("P").text(name).text("int").text("Integer").text("").whole(value).end();
  }
  void vector(const char* name, const char* type, const glm::dvec3& value) {
    file_.begin("P").text(name).text(type).text("").text("A").number(value.x).number(value.y).number(value.z).end();
  }
  void matrix(const char* name, const glm::dmat4& m) {
    std::array<double, 16> numbers{};
    for (int i = 0; i < 16; ++i) numbers[static_cast<std::size_t>(i)] = m[i / 4][i % 4];
    file_.begin(name).numbers(numbers).end();
  }

  void add_settings() {
    file_.begin("GlobalSettings").entry("Version", 1000).begin("Properties70");
    for (const auto& [name, value] : {std::pair{"UpAxis", 1},
                                      {"UpAxisSign", 1},
                                      {"FrontAxis", 2},
                                      {"FrontAxisSign", 1},
                                      {"CoordAxis", 0},
                                      {"CoordAxisSign", 1},
                                      {"OriginalUpAxis", 1},
                                      {"OriginalUpAxisSign", 1}})
      property(name, value);
    property("UnitScaleFactor", "double", "Number", 100);
    property("OriginalUnitScaleFactor", "double", "Number", 100);
    file_.begin("P").text("TimeMode").text("enum").text("").text("").whole(14).end();
    property("CustomFrameRate", "double", "Number", options_.fps);
    file_.end().end();
  }

  void add_model(std::int64_t id, std::string_view name, const char* use, const FbxKeys::Local& local) {
    object("Model", id, name, "Model", use).entry("Version", 232).begin("Properties70");
    vector("Lcl Translation", "Lcl Translation", local.translation);
    vector("Lcl Rotation", "Lcl Rotation", local.angles);
    vector("Lcl Scaling", "Lcl Scaling", local.scale);
    file_.begin("P").text("InheritType").text("enum").text("").text("").whole(1).end();
    file_.end().entry("Culling", "CullingOff").end();
  }

  void add_joints() {
    if (!model_.skeleton) return;
    const auto joints = model_.skeleton->joints();
    std::size_t value = document::weight_count(model_);
    for (const rig::Joint& joint : joints) {
      glm::dvec3 turn(0);
      for (int axis = 0; joint.posable && axis < 3; ++axis) turn[axis] = model_.pose[value++];
      const std::int64_t id = next();
      joints_.push_back(id);
      add_model(id, joint.name, "LimbNode", FbxKeys::at(joint, turn));
      link(id, joint.parent < 0 ? 0 : joints_[static_cast<std::size_t>(joint.parent)]);
      const std::int64_t bone = next();
      object("NodeAttribute", bone, joint.name, "NodeAttribute", "LimbNode").begin("Properties70").end();
      file_.entry("TypeFlags", "Skeleton").end();
      link(bone, id);
    }
  }

  void add_part(std::size_t number) {
    const mesh::Part& part = model_.mesh->parts()[number];
    const std::int64_t node = next();
    const std::int64_t geometry = next();
    add_model(node, part.name, "Mesh", {});
    link(node, 0);
    object("Geometry", geometry, part.name, "Geometry", "Mesh").begin("Properties70").end();
    std::vector<double> places;
    for (std::uint32_t v = 0; v < part.vertex_count; ++v) {
      const auto& at = model_.mesh->positions()[part.first_vertex + v];
      places.insert(places.end(), {at.x, at.y, at.z});
    }
    std::vector<std::int32_t> corners;
    for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
      const mesh::Triangle& triangle = model_.mesh->triangles()[t];
      for (std::size_t i = 0; i < 3; ++i) {
        const auto v = static_cast<std::int32_t>(triangle[i] - part.first_vertex);
        corners.push_back(i == 2 ? -v - 1 : v);
      }
    }
    file_.entry("GeometryVersion", 124);
    file_.begin("Vertices").numbers(places).end();
    file_.begin("PolygonVertexIndex").wholes(corners).end();
    const Surfaces surfaces = surfaces_of(part, number);
    if (!surfaces.all.empty()) add_layers(part, surfaces);
    file_.end();
    link(geometry, node);
    for (const document::Surface& surface : surfaces.all) add_material(surface, node);
    add_skin(part, geometry);
    add_shapes(part, geometry);
  }

  struct Surfaces {
    std::vector<document::Surface> all;
    std::vector<std::int32_t> of_triangles;
  };
  /// Holds the look of a part's triangles.
  [[nodiscard]] Surfaces surfaces_of(const mesh::Part& part, std::size_t number) const {
    Surfaces out;
    out.of_triangles.assign(part.triangle_count, 0);
    if (model_.look == nullptr || model_.look->surface_of.size() != model_.mesh->triangles().size()) {
      if (number >= model_.materials.size()) return out;
      document::Surface surface;
      surface.name = model_.materials[number].name;
      surface.base_color = model_.materials[number].base_color;
      out.all.push_back(std::move(surface));
      return out;
    }
    std::map<std::uint32_t, std::int32_t> known;
    for (std::uint32_t t = 0; t < part.triangle_count; ++t) {
      const std::uint32_t surface = model_.look->surface_of[part.first_triangle + t];
      const auto [at, is_new] = known.try_emplace(surface, static_cast<std::int32_t>(out.all.size()));
      if (is_new && surface < model_.look->surfaces.size()) out.all.push_back(model_.look->surfaces[surface]);
      if (is_new && surface >= model_.look->surfaces.size()) out.all.emplace_back();
      out.of_triangles[t] = at->second;
    }
    return out;
  }

  void begin_layer(const char* kind, const char* mapping, const char* reference) {
    file_.begin(kind).whole(0).entry("Version", 101).entry("Name", "map1");
    file_.entry("MappingInformationType", mapping).entry("ReferenceInformationType", reference);
  }

  /// Texture coordinates and materials.
  void add_layers(const mesh::Part& part, const Surfaces& surfaces) {
    std::vector<const char*> kinds{"LayerElementMaterial"};
    if (model_.look != nullptr && model_.look->coordinates[0].size() == model_.mesh->positions().size()) {
      kinds.push_back("LayerElementUV");
      std::vector<double> places;
      std::vector<std::int32_t> corners;
      for (std::uint32_t v = 0; v < part.vertex_count; ++v) {
        const auto& at = model_.look->coordinates[0][part.first_vertex + v];
        // Up from the lower edge of the picture.
        places.insert(places.end(), {double{at[0]}, 1.0 - double{at[1]}});
      }
      for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
        for (const std::uint32_t v : model_.mesh->triangles()[t])
          corners.push_back(static_cast<std::int32_t>(v - part.first_vertex));
      }
      begin_layer("LayerElementUV", "ByPolygonVertex", "IndexToDirect");
      file_.begin("UV").numbers(places).end().begin("UVIndex").wholes(corners).end().end();
    }
    const bool one = surfaces.all.size() == 1;
    begin_layer("LayerElementMaterial", one ? "AllSame" : "ByPolygon", "IndexToDirect");
    if (one) {
      file_.begin("Materials").wholes(std::array<std::int32_t, 1>{0}).end().end();
    } else {
      file_.begin("Materials").wholes(surfaces.of_triangles).end().end();
    }
    file_.begin("Layer").whole(0).entry("Version", 100);
    for (const char* kind : kinds) file_.begin("LayerElement").entry("Type", kind).entry("TypedIndex", 0).end();
    file_.end();
  }

  void add_material(const document::Surface& surface, std::int64_t node) {
    const std::int64_t id = next();
    object("Material", id, surface.name, "Material", "").entry("Version", 102).entry("ShadingModel", "Phong");
    file_.entry("MultiLayer", 0).begin("Properties70");
    vector("DiffuseColor", "Color", {surface.base_color[0], surface.base_color[1], surface.base_color[2]});
    property("DiffuseFactor", "Number", "", 1);
    property("Opacity", "Number", "", surface.base_color[3]);
    file_.end().end();
    link(id, node);
    if (surface.texture && surface.texture->coordinates == 0) add_texture(*surface.texture, id);
  }

  /// The picture lies beside the file.
  void add_texture(const document::TextureUse& use, std::int64_t material) {
    if (use.image >= model_.look->images.size()) return;
    const std::string name = pictures_.name_of(use.image);
    if (name.empty()) return;
    const std::int64_t texture = next();
    const std::int64_t video = next();
    object("Texture", texture, name, "Texture", "").entry("Type", "TextureVideoClip").entry("Version", 202);
    file_.entry("TextureName", FbxWriter::named(name, "Texture")).entry("Media", FbxWriter::named(name, "Video"));
    file_.entry("FileName", name).entry("RelativeFilename", name).begin("Properties70").end().end();
    object("Video", video, name, "Video", "Clip").entry("Type", "Clip").begin("Properties70").end();
    file_.entry("UseMipMap", 0).entry("Filename", name).entry("RelativeFilename", name).end();
    link(texture, material, "DiffuseColor");
    link(video, texture);
  }

  void add_skin(const mesh::Part& part, std::int64_t geometry) {
    if (!model_.skeleton) return;
    std::map<std::uint32_t, std::pair<std::vector<std::int32_t>, std::vector<double>>> clusters;
    for (std::uint32_t v = 0; v < part.vertex_count; ++v) {
      for (const rig::Influence& one : model_.skeleton->influences_of(part.first_vertex + v)) {
        clusters[one.joint].first.push_back(static_cast<std::int32_t>(v));
        clusters[one.joint].second.push_back(one.weight);
      }
    }
    if (clusters.empty()) return;
    const std::int64_t skin = next();
    object("Deformer", skin, "", "Deformer", "Skin").entry("Version", 101).begin("Link_DeformAcuracy").number(50).end();
    file_.end();
    link(skin, geometry);
    for (const auto& [joint, shares] : clusters) {
      const std::int64_t id = next();
      object("Deformer", id, "", "SubDeformer", "Cluster").entry("Version", 100);
      file_.begin("UserData").text("").text("").end();
      file_.begin("Indexes").wholes(shares.first).end();
      file_.begin("Weights").numbers(shares.second).end();
      const glm::dmat4& to_bone = model_.skeleton->joints()[joint].inverse_bind;
      matrix("Transform", to_bone);
      matrix("TransformLink", glm::determinant(to_bone) != 0.0 ? glm::inverse(to_bone) : glm::dmat4(1));
      file_.end();
      link(id, skin);
      link(joints_[joint], id);
    }
  }

  void add_shapes(const mesh::Part& part, std::int64_t geometry) {
    if (!model_.shapes) return;
    std::int64_t deformer = 0;
    const auto shapes = model_.shapes->shapes();
    for (std::size_t s = 0; s < shapes.size(); ++s) {
      const rig::BlendShape& shape = shapes[s];
      std::vector<std::int32_t> indices;
      std::vector<double> deltas;
      for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
        if (shape.vertices[i] < part.first_vertex || shape.vertices[i] >= part.first_vertex + part.vertex_count)
          continue;
        indices.push_back(static_cast<std::int32_t>(shape.vertices[i] - part.first_vertex));
        for (int axis = 0; axis < 3; ++axis) deltas.push_back(double{shape.deltas[i][axis]});
      }
      if (indices.empty()) continue;
      if (deformer == 0) {
        deformer = next();
        object("Deformer", deformer, part.name, "Deformer", "BlendShape").entry("Version", 100).end();
        link(deformer, geometry);
      }
      const std::int64_t channel = next();
      const std::int64_t target = next();
      const double percent = model_.pose[s] * 100.0;
      object("Deformer", channel, shape.parameter.name, "SubDeformer", "BlendShapeChannel").entry("Version", 100);
      file_.begin("DeformPercent").number(percent).end();
      file_.begin("FullWeights").numbers(std::array<double, 1>{100}).end();
      file_.begin("Properties70");
      property("DeformPercent", "Number", "", percent);
      file_.end().end();
      object("Geometry", target, shape.parameter.name, "Geometry", "Shape").entry("Version", 100);
      file_.begin("Indexes").wholes(indices).end().begin("Vertices").numbers(deltas).end().end();
      link(channel, deformer);
      link(target, channel);
      channels_[s].push_back(channel);
    }
  }

  /// One curve an axis.
  void add_curves(std::int64_t layer, const FbxKeys& keys, const std::vector<std::int64_t>& objects,
                  const char* property_name, const std::vector<const char*>& axes) {
    const std::int64_t node = next();
    object("AnimationCurveNode", node, property_name, "AnimCurveNode", "").begin("Properties70");
    for (std::size_t axis = 0; axis < axes.size(); ++axis)
      property(axes[axis], "Number", "", keys.values[axis].front());
    file_.end().end();
    link(node, layer);
    for (const std::int64_t one : objects) link(node, one, property_name);
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      const std::int64_t curve = next();
      object("AnimationCurve", curve, "", "AnimCurve", "").begin("Default").number(0).end().entry("KeyVer", 4008);
      file_.begin("KeyTime").ids(keys.ticks).end();
      file_.begin("KeyValueFloat").floats(keys.values[axis]).end();
      file_.begin("KeyAttrFlags").wholes(std::array<std::int32_t, 1>{keys.steps ? 2 : 4}).end();
      file_.begin("KeyAttrDataFloat").floats(std::array<double, 4>{0, 0, 0, 0}).end();
      file_.begin("KeyAttrRefCount")
          .wholes(std::array<std::int32_t, 1>{static_cast<std::int32_t>(keys.ticks.size())})
          .end();
      file_.end();
      link(curve, node, axes[axis]);
    }
  }

  void add_animations() {
    for (const document::Animation& animation : model_.animations) {
      const std::int64_t stack = next();
      const std::int64_t layer = next();
      const std::int64_t stop = FbxKeys::ticks_of(document::duration_s(animation));
      object("AnimationStack", stack, animation.name, "AnimStack", "").begin("Properties70");
      for (const char* name : {"LocalStop", "ReferenceStop"})
        file_.begin("P").text(name).text("KTime").text("Time").text("").id(stop).end();
      file_.end().end();
      object("AnimationLayer", layer, animation.name, "AnimLayer", "").begin("Properties70").end().end();
      link(layer, stack);
      for (const document::Channel& channel : animation.channels) add_channel(layer, channel);
    }
  }

  void add_channel(std::int64_t layer, const document::Channel& channel) {
    if (channel.target == document::ChannelTarget::weights) {
      const std::size_t width = document::weight_count(model_);
      for (const auto& [shape, objects] : channels_) {
        const FbxKeys keys = FbxKeys::of_weight(channel, width, shape, frames_);
        if (!keys.ticks.empty()) add_curves(layer, keys, objects, "DeformPercent", {"d|DeformPercent"});
      }
      return;
    }
    if (channel.joint >= joints_.size()) return;
    const FbxKeys keys = FbxKeys::of_joint(channel, frames_);
    if (keys.ticks.empty()) return;
    const char* name = channel.target == document::ChannelTarget::translation ? "Lcl Translation"
                       : channel.target == document::ChannelTarget::rotation  ? "Lcl Rotation"
                                                                              : "Lcl Scaling";
    add_curves(layer, keys, {joints_[channel.joint]}, name, {"d|X", "d|Y", "d|Z"});
  }

  const document::Model& model_;
  const WriteOptions& options_;
  FbxPictures pictures_;
  FbxFrames frames_;
  FbxWriter file_;
  std::vector<Link> links_;
  std::vector<std::int64_t> joints_;
  std::map<std::size_t, std::vector<std::int64_t>> channels_;  ///< of each shape, one a mesh
  std::int64_t last_id_ = 1'000'000;
};

}  // namespace

base::Result<std::vector<std::uint8_t>> write_fbx(const document::Model& model, const WriteOptions& options,
                                                  WriteReport& report) {
  if (model.deformers) {
    report.notes.emplace_back(
        "sketched controls are left out of FBX: write a .glb, where they are baked, and that as .fbx");
  }
  if (!model.expressions.empty()) report.notes.emplace_back("expressions are left out: FBX has no place for them");
  report.targets = model.shapes ? model.shapes->shapes().size() : 0;
  Writer writer(model, options, report);
  auto bytes = writer.write();
  if (writer.has_fewer_frames())
    report.notes.emplace_back("keys that are far apart have no frames between them: turns go another way there");
  return bytes;
}

}  // namespace penpose::io
