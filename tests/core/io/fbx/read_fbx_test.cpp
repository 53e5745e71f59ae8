#include "core/io/fbx/read_fbx.h"

#include <gtest/gtest.h>
#include <string>
#include <string_view>

#include "core/base/byte_writer.h"
#include "core/base/math.h"
#include "core/document/time/animation_sampling.h"
#include "core/io/fbx/tree/fbx_tree.h"
#include "core/io/model/model_formats.h"

namespace penpose::io {
namespace {

/// A square of two joints' skin with a shape that has one between, in centimetres, its up axis +z.
constexpr std::string_view k_text = R"(; FBX 7.4.0 project file
FBXHeaderExtension:  {
	FBXHeaderVersion: 1003
	FBXVersion: 7400
}
GlobalSettings:  {
	Properties70:  {
		P: "UpAxis", "int", "Integer", "",2
		P: "UpAxisSign", "int", "Integer", "",1
		P: "FrontAxis", "int", "Integer", "",1
		P: "FrontAxisSign", "int", "Integer", "",-1
		P: "CoordAxis", "int", "Integer", "",0
		P: "CoordAxisSign", "int", "Integer", "",1
		P: "UnitScaleFactor", "double", "Number", "",1
	}
}
Objects:  {
	Model: 1, "Model::hips", "LimbNode" {
		Properties70:  {
			P: "Lcl Translation", "Lcl Translation", "", "A",0,0,100
		}
	}
	Model: 2, "Model::head", "LimbNode" {
		Properties70:  {
			P: "Lcl Translation", "Lcl Translation", "", "A",0,0,50
			P: "Lcl Rotation", "Lcl Rotation", "", "A",90,0,0
		}
	}
	Model: 3, "Model::face", "Mesh" {
		Properties70:  {
			P: "GeometricTranslation", "Vector3D", "Vector", "",0,0,10
		}
	}
	Geometry: 4, "Geometry::face", "Mesh" {
		Vertices: *12 {
			a: 0,0,140,10,0,140,
10,0,150,0,0,150
		}
		PolygonVertexIndex: *4 {
			a: 0,1,2,-4
		}
	}
	Material: 20, "Material::skin", "" {
		Properties70:  {
			P: "DiffuseColor", "Color", "", "A",1,0.5,0.25
		}
	}
	Deformer: 5, "Deformer::", "Skin" {
	}
	Deformer: 6, "SubDeformer::", "Cluster" {
		Indexes: *2 {
			a: 0,1
		}
		Weights: *2 {
			a: 1,0.25
		}
		Transform: *16 {
			a: 1,0,0,0,0,1,0,0,0,0,1,0,0,0,-100,1
		}
		TransformLink: *16 {
			a: 1,0,0,0,0,1,0,0,0,0,1,0,0,0,100,1
		}
	}
	Deformer: 7, "SubDeformer::", "Cluster" {
		Indexes: *3 {
			a: 1,2,3
		}
		Weights: *3 {
			a: 0.75,1,1
		}
		Transform: *16 {
			a: 1,0,0,0,0,1,0,0,0,0,1,0,0,0,-150,1
		}
		TransformLink: *16 {
			a: 1,0,0,0,0,1,0,0,0,0,1,0,0,0,150,1
		}
	}
	Deformer: 8, "Deformer::", "BlendShape" {
	}
	Deformer: 9, "SubDeformer::smile", "BlendShapeChannel" {
		FullWeights: *2 {
			a: 50,100
		}
		Properties70:  {
			P: "DeformPercent", "Number", "", "A",25
		}
	}
	Geometry: 10, "Geometry::half", "Shape" {
		Indexes: *1 {
			a: 2
		}
		Vertices: *3 {
			a: 4,0,0
		}
	}
	Geometry: 11, "Geometry::full", "Shape" {
		Indexes: *2 {
			a: 2,3
		}
		Vertices: *6 {
			a: 2,0,0,0,0,2
		}
	}
	AnimationStack: 12, "AnimStack::Take 001", "" {
	}
	AnimationLayer: 13, "AnimLayer::Base", "" {
	}
	AnimationCurveNode: 14, "AnimCurveNode::DeformPercent", "" {
	}
	AnimationCurve: 15, "AnimCurve::", "" {
		KeyTime: *2 {
			a: 0,46186158000
		}
		KeyValueFloat: *2 {
			a: 0,100
		}
		KeyAttrFlags: *1 {
			a: 4
		}
		KeyAttrDataFloat: *4 {
			a: 0,0,0,0
		}
		KeyAttrRefCount: *1 {
			a: 2
		}
	}
}
Connections:  {
	C: "OO",1,0
	C: "OO",2,1
	C: "OO",3,0
	C: "OO",4,3
	C: "OO",20,3
	C: "OO",5,4
	C: "OO",6,5
	C: "OO",7,5
	C: "OO",1,6
	C: "OO",2,7
	C: "OO",8,4
	C: "OO",9,8
	C: "OO",10,9
	C: "OO",11,9
	C: "OO",13,12
	C: "OO",14,13
	C: "OP",14,9, "DeformPercent"
	C: "OP",15,14, "d|DeformPercent"
}
)";

/// The same records as a binary file has them.
class Packed {
 public:
  static std::vector<std::uint8_t> file(const FbxTree& tree) {
    Packed packed;
    packed.out_.append(std::string_view("Kaydara FBX Binary  \0\x1a\0", 23));
    packed.out_.write(std::uint32_t{7400});
    for (const FbxRecord& record : tree.root.records) packed.add(record);
    packed.end();
    return packed.out_.take();
  }

 private:
  void end() { out_.append(std::string(13, '\0')); }
  static std::size_t size_of(const FbxValue& value) {
    struct Size {
      std::size_t operator()(std::int64_t) const { return 9; }
      std::size_t operator()(double) const { return 9; }
      std::size_t operator()(const std::string& text) const { return 5 + text.size(); }
      std::size_t operator()(const std::vector<std::int64_t>& all) const { return 13 + 8 * all.size(); }
      std::size_t operator()(const std::vector<double>& all) const { return 13 + 8 * all.size(); }
    };
    return std::visit(Size{}, value);
  }
  static std::size_t values_size(const FbxRecord& record) {
    std::size_t sum = 0;
    for (const FbxValue& value : record.values) sum += size_of(value);
    return sum;
  }
  static std::size_t size_of(const FbxRecord& record) {
    std::size_t sum = 13 + record.name.size() + values_size(record);
    for (const FbxRecord& inner : record.records) sum += size_of(inner);
    return record.records.empty() ? sum : sum + 13;
  }
  void add(const FbxRecord& record) {
    out_.write(static_cast<std::uint32_t>(out_.size() + size_of(record)));
    out_.write(static_cast<std::uint32_t>(record.values.size()));
    out_.write(static_cast<std::uint32_t>(values_size(record)));
    out_.write(static_cast<std::uint8_t>(record.name.size()));
    out_.append(record.name);
    for (const FbxValue& value : record.values) add(value);
    for (const FbxRecord& inner : record.records) add(inner);
    if (!record.records.empty()) end();
  }
  void kind(char letter) { out_.write(static_cast<std::uint8_t>(letter)); }
  void array(char letter, std::size_t count) {
    kind(letter);
    out_.write(static_cast<std::uint32_t>(count));
    out_.write(std::uint32_t{0});
    out_.write(std::uint32_t{0});
  }
  void add(const FbxValue& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
      kind('L');
      out_.write(static_cast<std::uint64_t>(*whole));
    } else if (const auto* number = std::get_if<double>(&value)) {
      kind('D');
      out_.write_f64(*number);
    } else if (const auto* text = std::get_if<std::string>(&value)) {
      kind('S');
      out_.write(static_cast<std::uint32_t>(text->size()));
      out_.append(*text);
    } else if (const auto* wholes = std::get_if<std::vector<std::int64_t>>(&value)) {
      array('l', wholes->size());
      for (const std::int64_t one : *wholes) out_.write(static_cast<std::uint64_t>(one));
    } else {
      const auto& numbers = std::get<std::vector<double>>(value);
      array('d', numbers.size());
      for (const double one : numbers) out_.write_f64(one);
    }
  }
  base::ByteWriter out_;
};

std::vector<std::uint8_t> bytes_of(std::string_view text) { return {text.begin(), text.end()}; }
std::vector<std::uint8_t> packed() { return Packed::file(read_fbx_tree(base::as_bytes(k_text)).value()); }

void expect_near(const geometry::ModelPoint& a, const geometry::ModelPoint& b) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-6) << i;
}

TEST(ReadFbx, TextAndBinaryFilesGiveTheSameModel) {
  const auto text = read_fbx(bytes_of(k_text), {});
  ASSERT_TRUE(text.ok()) << text.error().line();
  const auto binary = read_fbx(packed(), {});
  ASSERT_TRUE(binary.ok()) << binary.error().line();
  EXPECT_EQ(document::state_hash(*text), document::state_hash(*binary));
  EXPECT_EQ(format_of_content(bytes_of(k_text))->name, "FBX");
  EXPECT_EQ(format_of_content(packed())->name, "FBX");
}

TEST(ReadFbx, TheWorldIsYUpInMetres) {
  const auto model = read_fbx(bytes_of(k_text), {}).value();
  ASSERT_EQ(model.mesh->vertex_count(), 4U);
  EXPECT_EQ(model.mesh->triangle_count(), 2U);
  EXPECT_EQ(model.mesh->parts()[0].name, "face");
  EXPECT_EQ(model.materials[0].name, "skin");
  EXPECT_EQ(model.materials[0].base_color[1], 0.5);
  // Its own geometry stands 10 cm above its node.
  expect_near(model.mesh->positions()[0], {0, 1.5, 0});
  expect_near(model.mesh->positions()[2], {0.1, 1.6, 0});
}

TEST(ReadFbx, TheSkinFollowsTheJointsAsTheFileShowsThem) {
  auto model = read_fbx(bytes_of(k_text), {}).value();
  ASSERT_TRUE(model.skeleton);
  ASSERT_EQ(model.skeleton->joints().size(), 2U);
  EXPECT_EQ(model.skeleton->joints()[1].parent, 0);
  std::fill(model.pose.begin(), model.pose.end(), 0.0);
  const auto posed = document::posed_positions(model);
  // The head is turned by a right angle about x since it was bound: what was 10 cm above it is in front of it.
  expect_near(posed[0], {0, 1.5, 0});
  expect_near(posed[3], {0, 1.5, 0.1});
}

TEST(ReadFbx, AShapeBetweenOthersIsAControlOfItsOwn) {
  const auto model = read_fbx(bytes_of(k_text), {}).value();
  ASSERT_TRUE(model.shapes);
  ASSERT_EQ(model.shapes->shapes().size(), 2U);
  EXPECT_EQ(model.shapes->shapes()[0].parameter.name, "smile");
  const rig::BlendShape& half = model.shapes->shapes()[1];
  EXPECT_EQ(half.parameter.name, "smile_50");
  ASSERT_EQ(half.vertices, (std::vector<std::uint32_t>{2}));
  EXPECT_NEAR(half.deltas[0].x, 0.04, 1e-7);
  // 25 % are half of what is there at 50 %.
  EXPECT_EQ(model.pose[0], 0.0);
  EXPECT_EQ(model.pose[1], 0.5);
  ASSERT_EQ(model.notes.size(), 1U);
  EXPECT_NE(model.notes[0].find("smile_50"), std::string::npos);
}

TEST(ReadFbx, KeysOfAChannelGoThroughItsShapes) {
  const auto model = read_fbx(bytes_of(k_text), {}).value();
  ASSERT_EQ(model.animations.size(), 1U);
  EXPECT_EQ(model.animations[0].name, "Take 001");
  const document::Channel& channel = model.animations[0].channels.at(0);
  EXPECT_EQ(channel.times_s, (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(channel.values, (std::vector<double>{0, 0, 0, 1, 1, 0}));
  // 75 % are half of each.
  const std::vector<double> late = document::sample_channel(channel, 2, 0.75);
  EXPECT_NEAR(late[0], 0.5, 1e-12);
  EXPECT_NEAR(late[1], 0.5, 1e-12);
}

TEST(ReadFbx, RotationsHaveAnotherOrderAndOthersAroundThemOnlyWhereTheyAreActive) {
  const auto upright = [](std::string_view properties) {
    constexpr std::string_view k_turn = R"("Lcl Rotation", "", "A",90,0,0)";
    std::string text(k_text);
    text.replace(text.find(k_turn), k_turn.size(),
                 R"("Lcl Rotation", "", "A",90,90,0
			P: "RotationOrder", "enum", "", "",5
			P: "PreRotation", "Vector3D", "Vector", "",0,0,90
			P: "PostRotation", "Vector3D", "Vector", "",0,0,0)" +
                     std::string(properties));
    auto model = read_fbx(bytes_of(text), {}).value();
    std::fill(model.pose.begin(), model.pose.end(), 0.0);
    // The fourth vertex lies 10 cm along +z of the file above the head.
    const geometry::ModelPoint at = document::posed_positions(model)[3];
    return geometry::ModelPoint(at.x, -at.z, at.y - 1.5) * 10.0;
  };
  // First about x, then about y: +z comes to -y, and stays there.
  expect_near(upright(""), {0, -1, 0});
  // First about y, then about x, as the order says: +z comes to +x; then about z before all: to +y.
  constexpr std::string_view k_active = "\n\t\t\tP: \"RotationActive\", \"bool\", \"\", \"\",1";
  expect_near(upright(k_active), {0, 1, 0});
  // For limits alone it is as if nothing were said.
  expect_near(upright(std::string(k_active) + "\n\t\t\tP: \"RotationSpaceForLimitOnly\", \"bool\", \"\", \"\",1"),
              {0, -1, 0});
}

TEST(ReadFbx, SmallNumbersAndTruthsAreValues) {
  base::ByteWriter out;
  out.append(std::string_view("Kaydara FBX Binary  \0\x1a\0", 23));
  out.write(std::uint32_t{7400});
  const std::string_view values("B\1Z\xfe\x59\xff\xff", 7);
  out.write(static_cast<std::uint32_t>(27 + 13 + 1 + values.size()));
  out.write(std::uint32_t{3});
  out.write(static_cast<std::uint32_t>(values.size()));
  out.write(std::uint8_t{1});
  out.append("X");
  out.append(values);
  out.append(std::string(13, '\0'));
  const auto tree = read_fbx_tree(out.take());
  ASSERT_TRUE(tree.ok()) << tree.error().line();
  const FbxRecord* record = tree->root.find("X");
  ASSERT_NE(record, nullptr);
  EXPECT_EQ(record->whole(0), 1);
  EXPECT_EQ(record->whole(1), -2);
  EXPECT_EQ(record->whole(2), -1);
}

TEST(ReadFbx, FilesOfOtherFormsAreCalledWhatTheyAre) {
  const auto what = [](std::string_view text) {
    const auto bytes = bytes_of(text);
    EXPECT_EQ(format_of_content(bytes)->name, "FBX");
    const auto model = read_fbx(bytes, {});
    return model ? std::string("(no error)") : model.error().line();
  };
  EXPECT_NE(what(std::string_view("Kaydara FBX Binary  \0\x1a\1\0\0\x1d\x4c", 27)).find("high bytes first"),
            std::string::npos);
  EXPECT_NE(what("Kaydara FBX Binary  \xef\xbf\xbd\x1a").find("as if they were text"), std::string::npos);
  EXPECT_NE(what("; FBX 6.1.0 project file\nFBXHeaderExtension:  {\n\tFBXVersion: 6100\n}\nObjects:  {\n\tstray\n")
                .find("6.1"),
            std::string::npos);
}

TEST(ReadFbx, NodesBelowThemselvesAndTooDeepOnesAreRefused) {
  std::string round(k_text);
  const std::string top = "C: \"OO\",1,0";
  round.replace(round.find(top), top.size(), "C: \"OO\",1,2");
  auto refused = read_fbx(bytes_of(round), {});
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().what.find("below themselves"), std::string::npos);
  // A chain whose deepest joint comes first.
  std::string models;
  std::string links;
  for (int i = 0; i < 3000; ++i) {
    models += "\tModel: " + std::to_string(5000 - i) + ", \"Model::j\", \"LimbNode\" {\n\t}\n";
    links += "\tC: \"OO\"," + std::to_string(5000 - i) + "," + std::to_string(i == 2999 ? 0 : 4999 - i) + "\n";
  }
  std::string deep(k_text);
  deep.insert(deep.find("\tModel: 1,"), models);
  deep.insert(deep.find("\tC: \"OO\",1,0"), links);
  refused = read_fbx(bytes_of(deep), {});
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().what.find("below themselves"), std::string::npos);
}

TEST(ReadFbx, OldVersionsAndDamageAreSaidInOneLine) {
  std::string old(k_text);
  old.replace(old.find("7400"), 4, "6100");
  auto refused = read_fbx(bytes_of(old), {});
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().line().find("6.1"), std::string::npos);
  const auto whole = packed();
  for (std::size_t length = 30; length < whole.size(); length += 97) {
    const auto cut = read_fbx(base::Bytes(whole).first(length), {});
    EXPECT_TRUE(cut.ok() || cut.error().line().find('\n') == std::string::npos);
  }
  std::string corner(k_text);
  corner.replace(corner.find("a: 0,1,2,-4"), 11, "a: 0,1,9,-4");
  refused = read_fbx(bytes_of(corner), {});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().place, "mesh face");
}

}  // namespace
}  // namespace penpose::io
