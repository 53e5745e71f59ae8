#include "core/portrait/features/find_features.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "core/portrait/features/brows.h"
#include "core/portrait/features/eyes.h"
#include "core/portrait/features/flat_face.h"
#include "core/portrait/features/lip_border.h"
#include "core/portrait/features/mouth_seam.h"
#include "core/portrait/features/nose_and_jaw.h"
#include "core/portrait/surface/face_surface.h"

namespace penpose::portrait {
namespace {

class Collection {
 public:
  explicit Collection(const mesh::TriangleMesh& mesh) : mesh_(mesh) {}
  void add(const char* name, const FoundLine& line) {
    FoundCurve found{{name, {}}, line.sureness};
    for (const mesh::MeshPoint& point : line.points) {
      found.curve.points.push_back(posing::at_mesh_point(point, mesh_.triangles()));
    }
    if (found.curve.points.size() >= 2) curves_.push_back(std::move(found));
  }
  [[nodiscard]] std::vector<FoundCurve> take() { return std::move(curves_); }

 private:
  const mesh::TriangleMesh& mesh_;
  std::vector<FoundCurve> curves_;
};

std::vector<FoundCurve> curves_of(const FlatFace& face, const mesh::TriangleMesh& mesh) {
  Collection found(mesh);
  constexpr std::array<const char*, 2> k_side{"_R", "_L"};
  for (std::size_t side = 0; side < 2; ++side) {
    const std::string end = k_side[side];
    found.add(("eyelid_upper" + end).c_str(), face.upper_lids[side]);
    found.add(("eyelid_lower" + end).c_str(), face.lower_lids[side]);
    found.add(("brow" + end).c_str(), face.brows[side]);
  }
  found.add("lip_upper_inner", face.between_lips);
  found.add("lip_lower_inner", face.between_lips);
  found.add("lip_upper_outer", face.upper_lip);
  found.add("lip_lower_outer", face.lower_lip);
  return found.take();
}

}  // namespace

std::vector<FoundCurve> find_features(const rig::Rig& rig, const mesh::TriangleMesh& mesh,
                                      const intent::WholeModel& whole, double front_yaw_degrees,
                                      const SurfacePaint& paint) {
  const auto surface = FaceSurface::look_at(mesh, whole, front_yaw_degrees);
  if (!surface) return {};
  Collection found(mesh);
  const auto eyes = find_eyes(rig, whole, *surface);
  if (!eyes) {
    if (const auto flat = find_flat_face(rig, whole, *surface, paint)) return curves_of(*flat, mesh);
  }
  double below = surface->place().box.maximum.y;
  if (eyes) {
    found.add("eyelid_upper_R", (*eyes)[0].upper);
    found.add("eyelid_lower_R", (*eyes)[0].lower);
    found.add("eyelid_upper_L", (*eyes)[1].upper);
    found.add("eyelid_lower_L", (*eyes)[1].lower);
    const auto brows = find_brows(rig, whole, *surface, paint, *eyes);
    found.add("brow_R", brows[0]);
    found.add("brow_L", brows[1]);
    below = std::min((*eyes)[0].centre.y, (*eyes)[1].centre.y) - (*eyes)[0].width * 0.3;
  }
  if (const auto seam = find_mouth_seam(rig, whole, *surface, below)) {
    const auto lips = inner_lips(*surface, *seam);
    found.add("lip_upper_inner", lips[0]);
    found.add("lip_lower_inner", lips[1]);
    const auto borders = lip_borders(*surface, *seam);
    found.add("lip_upper_outer", borders[0]);
    found.add("lip_lower_outer", borders[1]);
    if (eyes) {
      const Nose nose = find_nose(*surface, *eyes, *seam);
      found.add("nose_bridge", nose.bridge);
      found.add("nose_base", nose.base);
      const Jaw jaw = find_jaw(*surface, *eyes, *seam);
      found.add("jaw", jaw.jaw);
      found.add("chin", jaw.chin);
    }
  }
  return found.take();
}

}  // namespace penpose::portrait
