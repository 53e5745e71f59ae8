#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/document/time/animation_sampling.h"
#include "core/io/fbx/read_fbx.h"

namespace penpose::io {
namespace {

/// A file of +y up in metres at 24 frames a second.
class Text {
 public:
  Text& model(int id, const std::string& name, const std::string& use, const std::string& properties = {}) {
    objects_ += "\tModel: " + std::to_string(id) + ", \"Model::" + name + "\", \"" + use +
                "\" {\n\t\tProperties70:  {\n" + properties + "\t\t}\n\t}\n";
    return *this;
  }
  /// Three vertices: x, y and z.
  Text& triangle(int id, int model) {
    objects_ += "\tGeometry: " + std::to_string(id) +
                ", \"Geometry::\", \"Mesh\" {\n\t\tVertices: *9 {\n\t\t\ta: 1,0,0,0,1,0,0,0,1\n\t\t}\n"
                "\t\tPolygonVertexIndex: *3 {\n\t\t\ta: 0,1,-3\n\t\t}\n\t}\n";
    return link(id, model);
  }
  Text& object(const std::string& text) {
    objects_ += text;
    return *this;
  }
  Text& link(int part, int whole, const std::string& property = {}) {
    links_ += "\tC: \"" + std::string(property.empty() ? "OO" : "OP") + "\"," + std::to_string(part) + "," +
              std::to_string(whole) + (property.empty() ? "" : ", \"" + property + "\"") + "\n";
    return *this;
  }
  /// A take, 900, of one layer, 901.
  Text& take() {
    objects_ +=
        "\tAnimationStack: 900, \"AnimStack::Take\", \"\" {\n\t}\n\tAnimationLayer: 901, \"AnimLayer::\", \"\" "
        "{\n\t}\n";
    return link(901, 900);
  }
  /// Keys along one axis: times in seconds.
  Text& keys(int id, int object, const std::string& property, const std::string& axis,
             const std::vector<std::pair<int, double>>& keys,
             const std::string& attributes = "KeyAttrFlags: *1 {\n\t\t\ta: 4\n\t\t}\n", int layer = 901) {
    std::string times;
    std::string values;
    for (const auto& [time_s, value] : keys) {
      times += (times.empty() ? "" : ",") + std::to_string(time_s * 46186158000LL);
      values += (values.empty() ? "" : ",") + std::to_string(value);
    }
    const std::string count = std::to_string(keys.size());
    objects_ += "\tAnimationCurveNode: " + std::to_string(id) +
                ", \"AnimCurveNode::\", \"\" {\n\t}\n\tAnimationCurve: " + std::to_string(id + 1) +
                ", \"AnimCurve::\", \"\" {\n\t\tKeyTime: *" + count + " {\n\t\t\ta: " + times +
                "\n\t\t}\n\t\tKeyValueFloat: *" + count + " {\n\t\t\ta: " + values + "\n\t\t}\n\t\t" + attributes +
                "\t\tKeyAttrRefCount: *1 {\n\t\t\ta: " + count + "\n\t\t}\n\t}\n";
    return link(id, layer).link(id, object, property).link(id + 1, id, axis);
  }
  [[nodiscard]] std::vector<std::uint8_t> bytes() const {
    const std::string all =
        "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\n\tFBXVersion: 7400\n}\nGlobalSettings:  {\n\tProperties70:  "
        "{\n"
        "\t\tP: \"UnitScaleFactor\", \"double\", \"Number\", \"\",100\n\t\tP: \"TimeMode\", \"enum\", \"\", "
        "\"\",11\n\t}\n}\n"
        "Objects:  {\n" +
        objects_ + "}\nConnections:  {\n" + links_ + "}\n";
    return {all.begin(), all.end()};
  }
  [[nodiscard]] document::Model read() const {
    auto model = read_fbx(bytes(), {});
    EXPECT_TRUE(model.ok()) << model.error().line();
    return std::move(model).value();
  }

 private:
  std::string objects_, links_;
};

std::string vector(const std::string& name, const std::string& value) {
  return "\t\t\tP: \"" + name + "\", \"\", \"\", \"\"," + value + "\n";
}

std::vector<geometry::ModelPoint> places_at(const document::Model& model, double time_s) {
  EXPECT_EQ(model.animations.size(), 1U);
  return document::posed_positions(
      document::model_at(model, document::sample(model, model.animations.at(0), time_s)).value());
}

void expect_at(const geometry::ModelPoint& a, const geometry::ModelPoint& b) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-6) << i;
}

TEST(FbxMotion, AVertexGroupIsTheMaskOfAShape) {
  const auto file = [](const std::string& mask) {
    return Text()
        .model(1, "face", "Mesh")
        .triangle(2, 1)
        .object(
            "\tDeformer: 3, \"Deformer::\", \"BlendShape\" {\n\t}\n"
            "\tDeformer: 4, \"SubDeformer::smile\", \"BlendShapeChannel\" {\n\t\tFullWeights: " +
            mask +
            "\n\t}\n\tGeometry: 5, \"Geometry::smile\", \"Shape\" {\n\t\tIndexes: *2 {\n\t\t\ta: 0,2\n\t\t}\n"
            "\t\tVertices: *6 {\n\t\t\ta: 0,4,0,0,4,0\n\t\t}\n\t}\n")
        .link(3, 2)
        .link(4, 3)
        .link(5, 4)
        .read();
  };
  const auto half = file("*2 {\n\t\t\ta: 25,100\n\t\t}");
  ASSERT_EQ(half.shapes->shapes().size(), 1U);
  EXPECT_EQ(half.shapes->shapes()[0].deltas.at(0).y, 1.F);
  EXPECT_EQ(half.shapes->shapes()[0].deltas.at(1).y, 4.F);
  // A single value is that of the channel at which the shape is whole.
  const auto whole = file("*1 {\n\t\t\ta: 100\n\t\t}");
  EXPECT_EQ(whole.shapes->shapes()[0].deltas.at(0).y, 4.F);
}

TEST(FbxMotion, NodesAboveAMeshMoveIt) {
  const auto model = Text()
                         .model(1, "mover", "Null")
                         .model(2, "face", "Mesh", vector("Lcl Translation", "0,2,0"))
                         .link(2, 1)
                         .triangle(3, 2)
                         .take()
                         .keys(10, 1, "Lcl Translation", "d|X", {{0, 0}, {2, 4}})
                         .keys(12, 2, "Lcl Scaling", "d|Y", {{0, 1}, {2, 3}})
                         .read();
  expect_at(document::posed_positions(model)[1], {0, 3, 0});
  // An axis without keys stays as the file has it.
  expect_at(places_at(model, 1)[1], {2, 2 + 2, 0});
}

TEST(FbxMotion, PivotsMoveANodeAsItTurns) {
  const auto model = Text()
                         .model(1, "face", "Mesh", vector("RotationPivot", "1,0,0"))
                         .triangle(2, 1)
                         .take()
                         .keys(10, 1, "Lcl Rotation", "d|Z", {{0, 0}, {1, 180}})
                         .read();
  expect_at(places_at(model, 0)[1], {0, 1, 0});
  expect_at(places_at(model, 0.5)[1], {0, -1, 0});
  expect_at(places_at(model, 1)[1], {2, -1, 0});
  // Frames between two keys are exact: 24 a second.
  const double angle = 180.0 * 5 / 24 * 3.14159265358979323846 / 180.0;
  expect_at(places_at(model, 5.0 / 24)[1],
            {1 - std::cos(angle) - std::sin(angle), -std::sin(angle) + std::cos(angle), 0});
}

TEST(FbxMotion, ScalesGoAlongAsTheNodeSays) {
  const auto tip = [](const std::string& type, double time_s) {
    const auto model =
        Text()
            .model(1, "above", "Null", vector("Lcl Scaling", "2,1,1"))
            .model(2, "face", "Mesh",
                   vector("Lcl Translation", "1,0,0") + vector("Lcl Rotation", "0,0,90") + vector("InheritType", type))
            .link(2, 1)
            .triangle(3, 2)
            .take()
            .keys(10, 1, "Lcl Translation", "d|Y", {{0, 0}, {1, 1}})
            .keys(12, 1, "Lcl Scaling", "d|X", {{0, 2}, {1, 4}})
            .read();
    return time_s < 0 ? document::posed_positions(model)[1] : places_at(model, time_s)[1];
  };
  // The second vertex points along -x once it is turned.
  expect_at(tip("1", -1), {2 - 2, 0, 0});
  expect_at(tip("0", -1), {2 - 1, 0, 0});
  expect_at(tip("2", -1), {2 - 1, 0, 0});
  expect_at(tip("1", 1), {4 - 4, 1, 0});
  expect_at(tip("2", 1), {4 - 1, 1, 0});
}

TEST(FbxMotion, ChildrenOfScaledNodesTakeTheScaleApart) {
  const auto model = Text()
                         .model(1, "above", "Null", vector("Lcl Scaling", "1,3,1"))
                         .model(2, "face", "Mesh", vector("Lcl Rotation", "0,0,90") + vector("InheritType", "0"))
                         .link(2, 1)
                         .triangle(3, 2)
                         .read();
  // Scaled by 3 along its own y, which points along -x; by RSrs it would be left at -1.
  expect_at(document::posed_positions(model)[1], {-3, 0, 0});
  expect_at(document::posed_positions(model)[0], {0, 1, 0});
}

TEST(FbxMotion, OneGeometryOnSeveralNodesIsThereForEach) {
  const auto model =
      Text()
          .model(1, "left", "Mesh", vector("Lcl Translation", "-5,0,0"))
          .model(2, "right", "Mesh", vector("Lcl Translation", "5,0,0") + vector("GeometricTranslation", "0,1,0"))
          .triangle(3, 1)
          .link(3, 2)
          .read();
  ASSERT_EQ(model.mesh->parts().size(), 2U);
  expect_at(document::posed_positions(model)[0], {-4, 0, 0});
  expect_at(document::posed_positions(model)[3], {6, 1, 0});
}

TEST(FbxMotion, TheTemplateOfTheFileSaysWhatANodeDoesNot) {
  std::string text;
  {
    const auto bytes = Text()
                           .model(1, "above", "Null", vector("Lcl Scaling", "1,3,1"))
                           .model(2, "face", "Mesh", vector("Lcl Rotation", "0,0,90"))
                           .link(2, 1)
                           .triangle(3, 2)
                           .bytes();
    text.assign(bytes.begin(), bytes.end());
  }
  text.insert(
      text.find("Objects:"),
      "Definitions:  {\n\tObjectType: \"Model\" {\n\t\tPropertyTemplate: \"FbxNode\" {\n\t\t\tProperties70:  {\n"
      "\t\t\t\tP: \"InheritType\", \"enum\", \"\", \"\",0\n\t\t\t}\n\t\t}\n\t}\n}\n");
  const auto model = read_fbx(std::vector<std::uint8_t>(text.begin(), text.end()), {}).value();
  expect_at(document::posed_positions(model)[1], {-3, 0, 0});
}

TEST(FbxMotion, StepsHoldAndSplinesBend) {
  const auto moved = [](const std::string& attributes, double time_s) {
    const auto model = Text()
                           .model(1, "face", "Mesh")
                           .triangle(2, 1)
                           .take()
                           .keys(10, 1, "Lcl Translation", "d|X", {{0, 0}, {1, 8}}, attributes)
                           .read();
    return places_at(model, time_s)[0].x - 1;
  };
  const std::string step = "KeyAttrFlags: *1 {\n\t\t\ta: 2\n\t\t}\n";
  EXPECT_NEAR(moved(step, 0.9), 0, 1e-9);
  EXPECT_NEAR(moved(step, 1.0), 8, 1e-9);
  // Flat at both ends: a smooth step.
  const std::string flat =
      "KeyAttrFlags: *1 {\n\t\t\ta: 1032\n\t\t}\n\t\tKeyAttrDataFloat: *4 {\n\t\t\ta: 0.0,0,0,0\n\t\t}\n";
  EXPECT_NEAR(moved(flat, 0.25), 8 * (3 * 0.0625 - 2 * 0.015625), 1e-6);
  // Text files have slopes as the bits of a number: 8 a second is a straight line.
  const std::string bits =
      "KeyAttrFlags: *1 {\n\t\t\ta: 1032\n\t\t}\n\t\tKeyAttrDataFloat: *4 {\n\t\t\ta: "
      "1090519040,1090519040,0,0\n\t\t}\n";
  EXPECT_NEAR(moved(bits, 0.25), 2, 1e-6);
}

TEST(FbxMotion, LayersAddToTheOneBelow) {
  const auto model =
      Text()
          .model(1, "face", "Mesh")
          .triangle(2, 1)
          .take()
          .object("\tAnimationLayer: 902, \"AnimLayer::\", \"\" {\n\t\tProperties70:  {\n" + vector("Weight", "50") +
                  "\t\t}\n\t}\n")
          .link(902, 900)
          .keys(10, 1, "Lcl Translation", "d|X", {{0, 0}, {1, 2}})
          .keys(12, 1, "Lcl Translation", "d|X", {{0, 0}, {1, 6}}, "KeyAttrFlags: *1 {\n\t\t\ta: 4\n\t\t}\n", 902)
          .read();
  expect_at(places_at(model, 1)[0], {1 + 2 + 3, 0, 0});
}

TEST(FbxMotion, KeysFarApartTakeLittle) {
  Text text;
  text.model(1, "face", "Mesh").triangle(2, 1).take();
  for (int i = 0; i < 20; ++i) {
    text.model(100 + i, "j" + std::to_string(i), "LimbNode");
    text.keys(200 + 2 * i, 100 + i, "Lcl Rotation", "d|X", {{0, 0}, {33000, 90}});
  }
  const auto model = text.read();
  std::size_t numbers = 0;
  for (const document::Channel& channel : model.animations.at(0).channels)
    numbers += channel.times_s.size() + channel.values.size();
  EXPECT_LT(numbers, 2'600'000U);
  EXPECT_EQ(model.animations[0].channels.size(), 20U);
  ASSERT_FALSE(model.notes.empty());
  EXPECT_NE(model.notes.back().find("fewer keys"), std::string::npos);
}

TEST(FbxMotion, RecordsOfNothingAreRefused) {
  std::string text = "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\n\tFBXVersion: 7400\n}\n";
  for (int i = 0; i < 100'000; ++i) text += ":\n";
  const auto refused = read_fbx(std::vector<std::uint8_t>(text.begin(), text.end()), {});
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().line().find("too many records"), std::string::npos);
}

TEST(FbxMotion, WhatIsNotReadIsSaid) {
  const auto model = Text()
                         .model(1, "face", "Mesh")
                         .triangle(2, 1)
                         .object(
                             "\tDeformer: 3, \"Deformer::\", \"Skin\" {\n\t\tSkinningType: \"DualQuaternion\"\n\t}\n"
                             "\tDeformer: 4, \"Deformer::\", \"VertexCacheDeformer\" {\n\t}\n"
                             "\tConstraint: 5, \"Constraint::aim\", \"Aim\" {\n\t}\n\tGeometry: 6, \"Geometry::\", "
                             "\"NurbsSurface\" {\n\t}\n")
                         .read();
  ASSERT_EQ(model.notes.size(), 4U);
  EXPECT_NE(model.notes[0].find("dual quaternions"), std::string::npos);
  EXPECT_NE(model.notes[1].find("geometry caches"), std::string::npos);
  EXPECT_NE(model.notes[2].find("constraints"), std::string::npos);
  EXPECT_NE(model.notes[3].find("no meshes"), std::string::npos);
}

}  // namespace
}  // namespace penpose::io
