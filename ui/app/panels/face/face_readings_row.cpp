#include "ui/app/panels/face/face_readings_row.h"

#include <algorithm>

#include "ui/app/panels/panel_entries.h"
#include "ui/app/session/reading_offer.h"
#include "ui/app/widgets/internal/picture_tile.h"

namespace penpose::app {
namespace {

/// Of a picture, in targets of a pen.
constexpr float k_widest_picture = 2.8F, k_narrowest_picture = 1.5F;

/// What the pictures show: the part of the face that all of the readings are about, else all of it.
FacePart part_shown(const ReadingOffer& offer) {
  const FacePart part = part_of(offer.readings().front().feature);
  const auto same = [&](const OfferedReading& one) { return part_of(one.feature) == part; };
  return std::all_of(offer.readings().begin(), offer.readings().end(), same) ? part : FacePart::all;
}

}  // namespace

FaceReadingsSize face_readings_size(const PanelContext& context, const ReadingOffer& offer, float wide) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const auto count = static_cast<float>(offer.readings().size());
  const float rest = (count - 1) * style.ItemSpacing.x + 2 * style.WindowPadding.x + 1;
  const float picture = std::clamp((wide - rest) / std::max(1.0F, count), k_narrowest_picture * context.unit,
                                   k_widest_picture * context.unit);
  return {picture, count * picture + rest, picture_tile_height(context, picture)};
}

bool show_face_readings(PanelContext& context, EditingSession& editing, ReadingOffer& offer, float picture) {
  auto& place = context.own.of<ReadingsPlace>();
  std::optional<std::size_t> shown;
  std::optional<std::size_t> taken;
  const FacePart part = part_shown(offer);
  for (std::size_t i = 0; i < offer.readings().size(); ++i) {
    if (i > 0) ImGui::SameLine();
    const OfferedReading& one = offer.readings()[i];
    const document::PoseKey key{0, one.pose, {}};
    const PictureTile tile{picture, context.pictures.place_of(editing.document(), key, part), one.words};
    if (picture_tile(context, ("reading " + std::to_string(i + 1)).c_str(), tile)) taken = i;
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) shown = i;
    tooltip(context, ("The line is the " + one.words + ": the face shows it; press to take it").c_str());
  }
  // What was just taken is to be seen before the pen, which is still there, shows what it took the place of.
  if (place.taken != shown) place.taken.reset();
  offer.show(editing, place.taken ? std::nullopt : shown);
  if (taken) {
    offer.take(editing, *taken);
    place.taken = taken;
  }
  return taken.has_value();
}

}  // namespace penpose::app
