#include "core/io/fbx/fbx_places.h"

#include <utility>

namespace penpose::io {
namespace {

bool is_one(const FbxPlaces::Place& place) { return !place.varies && place.scale == glm::dvec3(1); }
bool is_even(const FbxPlaces::Place& place) {
  return !place.varies && place.scale.x == place.scale.y && place.scale.y == place.scale.z;
}

FbxInherits asked_of(const FbxObject& node) {
  const double type = FbxScene::property(node, "InheritType", 1);
  return type == 0.0 ? FbxInherits::scale_apart : type == 2.0 ? FbxInherits::no_scale : FbxInherits::all;
}

}  // namespace

const FbxPlaces::Place& FbxPlaces::of(const FbxObject& node) {
  if (const auto at = places_.find(node.id); at != places_.end()) return at->second;
  // A node that hangs below itself, or too deep, is its own root here.
  std::vector<const FbxObject*> way{&node};
  while (way.size() <= k_deepest_fbx_node) {
    const FbxObject* above = scene_.parent_of(*way.back());
    if (above == nullptr || above == &node) break;
    way.push_back(above);
    if (places_.contains(above->id)) break;
  }
  for (auto at = way.rbegin(); at != way.rend(); ++at) {
    const FbxObject& one = **at;
    if (places_.contains(one.id)) continue;
    Place place;
    const FbxObject* above = scene_.parent_of(one);
    const auto parent = above == nullptr ? places_.end() : places_.find(above->id);
    FbxLocal local = FbxNodeTransform(one).local();
    place.local = local.matrix();
    place.varies = scaled_.contains(one.id);
    if (parent == places_.end()) {
      place.full = local.matrix();
      place.scale = std::exchange(local.scale, glm::dvec3(1));
      place.unscaled = local.matrix();
      places_.emplace(one.id, place);
      continue;
    }
    const Place& carrier = parent->second;
    place.parent = above;
    place.inherits = asked_of(one);
    if (place.inherits == FbxInherits::scale_apart) place.source = above;
    if (place.inherits == FbxInherits::no_scale) place.source = carrier.source;
    const auto source = place.source == nullptr ? places_.end() : places_.find(place.source->id);
    if ((is_one(carrier) && (source == places_.end() || is_one(source->second))) ||
        (place.inherits == FbxInherits::scale_apart && is_even(carrier))) {
      place.inherits = FbxInherits::all;
      place.source = nullptr;
    }
    if (place.inherits != FbxInherits::all) {
      local.translation *= carrier.scale;
      if (source != places_.end()) {
        local.scale *= source->second.scale;
        place.varies = place.varies || source->second.varies;
      }
    }
    const glm::dmat4& below = place.inherits == FbxInherits::all ? carrier.full : carrier.unscaled;
    place.full = below * local.matrix();
    place.scale = std::exchange(local.scale, glm::dvec3(1));
    place.unscaled = below * local.matrix();
    places_.emplace(one.id, place);
  }
  return places_.at(node.id);
}

}  // namespace penpose::io
