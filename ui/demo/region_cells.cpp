#include "ui/demo/region_cells.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace penpose::demo {
namespace {

/// Weights below this look dark anyway; regions may share such vertices and still be told apart.
constexpr double k_shared_weight = 0.4;

/// Below this weight the black of the border gives way to the skin, so that a border does not show the triangles.

const std::array<render::Color, 9>& palette() {
  static const std::array<render::Color, 9> colors{
      render::from_srgb(0xff5a4f), render::from_srgb(0xffc24a), render::from_srgb(0x45b8ff),
      render::from_srgb(0x8be04e), render::from_srgb(0xd07bff), render::from_srgb(0xff8a2a),
      render::from_srgb(0x35e0c2), render::from_srgb(0xff6fb5), render::from_srgb(0xf2ee5a)};
  return colors;
}

std::string_view without_side(std::string_view name) {
  if (name.ends_with("_L") || name.ends_with("_R")) name.remove_suffix(2);
  return name;
}

using Weights = std::vector<double>;  // one a vertex

struct Picture {
  Weights weights;  ///< the largest of all regions in it
  RegionCell cell;
};

bool fits(const Picture& picture, const Weights& region) {
  for (std::size_t v = 0; v < region.size(); ++v) {
    if (std::min(region[v], picture.weights[v]) > k_shared_weight) return false;
  }
  return true;
}

void lay(Picture& picture, const Weights& region, const Legend& legend) {
  for (std::size_t v = 0; v < region.size(); ++v) {
    if (region[v] <= picture.weights[v]) continue;
    picture.weights[v] = region[v];
    picture.cell.overlay[v] = {legend.color.r, legend.color.g, legend.color.b, static_cast<float>(region[v])};
  }
  picture.cell.legends.push_back(legend);
}

}  // namespace

std::vector<RegionCell> region_cells(const document::Model& model) {
  std::vector<Picture> pictures;
  const std::size_t vertices = model.mesh->vertex_count();
  if (!model.deformers) return {};
  const auto deformers = model.deformers->deformers();
  std::vector<std::string_view> names;
  for (const auto& deformer : deformers) {
    const std::string_view name = without_side(deformer->sketch().name);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    Weights region(vertices, 0.0);
    for (const auto& deformer : deformers) {
      if (without_side(deformer->sketch().name) != names[i]) continue;
      for (std::size_t k = 0; k < deformer->vertices().size(); ++k) {
        double& weight = region[deformer->vertices()[k]];
        weight = std::max(weight, deformer->weights()[k]);
      }
    }
    auto place = std::find_if(pictures.begin(), pictures.end(), [&](const Picture& p) { return fits(p, region); });
    if (place == pictures.end()) {
      Picture blank{Weights(vertices, 0.0), {}};
      blank.cell.overlay.assign(vertices, render::Color{0, 0, 0, 0});
      pictures.push_back(std::move(blank));
      place = pictures.end() - 1;
    }
    lay(*place, region, {std::string(names[i]), palette()[i % palette().size()]});
  }
  std::vector<RegionCell> cells;
  cells.reserve(pictures.size());
  for (Picture& picture : pictures) cells.push_back(std::move(picture.cell));
  return cells;
}

}  // namespace penpose::demo
