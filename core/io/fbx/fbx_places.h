#pragma once

#include <cstdint>
#include <map>
#include <set>

#include "core/io/fbx/fbx_scene.h"

namespace penpose::io {

/// How a node takes the scale of what it hangs below.
enum class FbxInherits {
  all,          ///< as any matrix (RSrs)
  scale_apart,  ///< axis by axis, and behind all rotations (RrSs)
  no_scale      ///< without that of the node right above it (Rrs)
};

/// Where nodes are as the file shows them, in its own axes and unit, and how their scales go along.
class FbxPlaces {
 public:
  /// `scaled`: nodes whose scale has keys.
  FbxPlaces(const FbxScene& scene, std::set<std::int64_t> scaled) : scene_(scene), scaled_(std::move(scaled)) {}

  struct Place {
    glm::dmat4 local{1};     ///< in the node above, by itself
    glm::dmat4 full{1};      ///< of what it carries
    glm::dmat4 unscaled{1};  ///< without its own scale, for what does not take it
    glm::dvec3 scale{1};     ///< its own, and that which it takes apart
    bool varies = false;     ///< the scale has keys
    FbxInherits inherits = FbxInherits::all;
    const FbxObject* parent = nullptr;
    const FbxObject* source = nullptr;  ///< the node whose scale it takes apart; null: none
  };
  /// How it inherits is `all` wherever that comes to the same.
  const Place& of(const FbxObject& node);

 private:
  const FbxScene& scene_;
  std::set<std::int64_t> scaled_;
  std::map<std::int64_t, Place> places_;
};

}  // namespace penpose::io
