#include "core/io/project/feature_file.h"

#include <gtest/gtest.h>

#include "core/document/model_hash.h"
#include "tests/support/models/sheet_model.h"

namespace penpose::io {
namespace {

FeatureFile some_features() {
  return {document::hash_topology(*tests::sheet_model().mesh),
          {{"brow_L", {{0, {0.25, 0.5, 0.25}}, {3, {1, 0, 0}}}}, {"a \"jaw\"\n", {}}}};
}

base::Error error_of(const std::string& text) {
  const auto file = read_features(base::as_bytes(text), *tests::sheet_model().mesh);
  return file ? base::Error{"", "(no error)", ""} : file.error();
}

/// The text of some_features with something in it replaced.
std::string with(const std::string& old, const std::string& other) {
  std::string text = write_features(some_features());
  const auto at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old << " in " << text;
  return text.replace(at, old.size(), other);
}

TEST(FeatureFile, ReadsBackAsItWas) {
  const FeatureFile file = some_features();
  const auto again = read_features(base::as_bytes(write_features(file)), *tests::sheet_model().mesh);
  ASSERT_TRUE(again.ok()) << again.error().line();
  EXPECT_EQ(again->mesh, file.mesh);
  ASSERT_EQ(again->features.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(again->features[i].name, file.features[i].name);
    EXPECT_EQ(again->features[i].points, file.features[i].points);
  }
}

TEST(FeatureFile, AFaultIsOneLineWithItsPlaceAndWhatToDo) {
  EXPECT_EQ(error_of("{}").what, "these are no features");
  EXPECT_EQ(error_of(with("\"penpose_features\": 1", "\"penpose_features\": 2")).place, "/penpose_features");
  EXPECT_EQ(error_of(with("\"mesh\": \"", "\"mesh\": \"x")).place, "/mesh");
  FeatureFile other = some_features();
  other.mesh = {1, 2};
  EXPECT_EQ(error_of(write_features(other)).what, "the features are of another mesh");
  EXPECT_EQ(error_of(with("\"points\":[]", "\"points\":3")).place, "/features/1");
  EXPECT_EQ(error_of(with("[0,", "[-1,")).place, "/features/0/points/0");
  EXPECT_EQ(error_of(with("[3,", "[3000000,")).place, "/features/0/points/1");
  EXPECT_EQ(error_of(with("[3,1", "[3,2")).place, "/features/0/points/1");
  FeatureFile twice = some_features();
  twice.features.back().name = "brow_L";
  EXPECT_EQ(error_of(write_features(twice)).place, "/features/1/name");
  twice = some_features();
  twice.features.front().points.pop_back();
  EXPECT_EQ(error_of(write_features(twice)).place, "/features/0/points");
  EXPECT_EQ(error_of(with("\"features\": [", "\"features\": 7, \"others\": [")).place, "/features");
  for (const std::string& text : {std::string("{}"), std::string("["), write_features(twice)}) {
    const base::Error error = error_of(text);
    EXPECT_FALSE(error.remedy.empty()) << text;
    EXPECT_EQ(error.line("f.json").find('\n'), std::string::npos);
  }
}

TEST(FeatureFile, AMeshIsKnownByItsTrianglesAndNotByItsForm) {
  const auto sheet = tests::sheet_model().mesh;
  mesh::MeshSource source;
  for (const geometry::ModelPoint& p : sheet->positions())
    source.positions.push_back(p * 2.0 + geometry::ModelPoint(0, 1, 0));
  source.triangles.assign(sheet->triangles().begin(), sheet->triangles().end());
  mesh::MeshSource turned = source;
  std::swap(turned.triangles[0], turned.triangles[1]);
  const base::Hash128 hash = document::hash_topology(*sheet);
  EXPECT_EQ(hash, document::hash_topology(*mesh::TriangleMesh::build(source).value()));
  EXPECT_FALSE(hash == document::hash_topology(*mesh::TriangleMesh::build(turned).value()));
}

}  // namespace
}  // namespace penpose::io
