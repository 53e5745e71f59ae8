#include "ui/render/kept_pictures.h"

#include <algorithm>

namespace penpose::render {
namespace {

constexpr int k_least_side_px = 64;

std::uint64_t px_within(std::uint64_t width, std::uint64_t height, int most_px) {
  const std::uint64_t by = std::max<std::uint64_t>(
      1, (std::max(width, height) + static_cast<std::uint64_t>(most_px) - 1) / static_cast<std::uint64_t>(most_px));
  return (width / by) * (height / by);
}

}  // namespace

std::vector<WantedPicture> wanted_pictures(const document::Look& look, std::span<const LookBatch> batches,
                                           std::uint64_t most_px) {
  std::vector<WantedPicture> all;
  const auto add = [&](const std::optional<document::TextureUse>& use, bool moves) {
    if (!use || use->image >= look.images.size()) return;
    const auto known =
        std::find_if(all.begin(), all.end(), [&](const WantedPicture& one) { return one.image == use->image; });
    if (known != all.end()) {
      known->moves = known->moves || moves;
      return;
    }
    WantedPicture one;
    one.image = use->image;
    one.moves = moves;
    all.push_back(one);
  };
  for (const LookBatch& batch : batches) {
    const document::Surface& surface = look.surfaces[batch.surface];
    add(surface.texture, batch.moves);
    if (!surface.toon) continue;
    add(surface.toon->shade_texture, batch.moves);
    if (surface.toon->outline != document::OutlineWidth::none) add(surface.toon->outline_texture, false);
  }
  std::uint64_t sum = 0;
  const auto measure = [&](WantedPicture& one) {
    const document::Image& image = look.images[one.image];
    one.px = px_within(image.width, image.height, one.most_px);
    sum += one.px;
  };
  for (WantedPicture& one : all) measure(one);
  while (sum > most_px) {
    const auto largest = std::max_element(all.begin(), all.end(), [](const WantedPicture& a, const WantedPicture& b) {
      const auto rank = [](const WantedPicture& one) { return one.moves ? one.px / 4 : one.px; };
      return rank(a) < rank(b);
    });
    if (largest->most_px <= k_least_side_px) break;
    sum -= largest->px;
    largest->most_px /= 2;
    measure(*largest);
  }
  return all;
}

}  // namespace penpose::render
