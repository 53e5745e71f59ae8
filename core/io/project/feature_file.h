#pragma once

#include <string>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/base/state_hash.h"
#include "core/document/model.h"

namespace penpose::io {

/// The number of the form of files of features; others are refused by it.
inline constexpr int k_feature_format = 1;

/// Features of the face as somebody corrected them (Model::features), for every model of the same mesh.
struct FeatureFile {
  base::Hash128 mesh;  ///< document::hash_topology
  std::vector<document::NamedCurve> features;
};

/// Reads {"penpose_features": 1, "mesh": HEX, "features": [{"name": NAME, "points": [[triangle, b0, b1, b2], ...]}]}
/// for a mesh. A feature without points is one that the face does not have. Errors (place: JSON pointer): no such file,
/// another format, a member of another form, another mesh, a point that is not on it, two features of one name.
[[nodiscard]] base::Result<FeatureFile> read_features(base::Bytes bytes, const mesh::TriangleMesh& mesh);

/// The JSON of the file, a feature a line, which reads back as the same.
[[nodiscard]] std::string write_features(const FeatureFile& file);

}  // namespace penpose::io
