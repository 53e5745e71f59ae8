#include "ui/app/panels/face/face_readings_row.h"

#include <algorithm>

#include "ui/app/canvas/canvas.h"
#include "ui/app/panels/panel_entries.h"
#include "ui/app/session/reading_offer.h"
#include "ui/app/widgets/internal/picture_tile.h"

namespace penpose::app {
namespace {

/// Of a picture, in targets of a pen.
constexpr float k_widest_picture = 3.2F, k_narrowest_picture = 1.5F;
/// So many are shown.
constexpr std::size_t k_most_pictures = 4;

std::size_t shown_count(const ReadingOffer& offer) { return std::min(k_most_pictures, offer.readings().size()); }

/// Found once for an offer, so that a view that is turned meanwhile draws no picture anew.
const PictureFrame& frame_of_offer(PanelContext& context, const EditingSession& editing, const Canvas& canvas,
                                   const ReadingOffer& offer) {
  auto& known = context.own.of<ReadingsFrame>();
  if (known.revision == editing.revision() && known.count == offer.readings().size()) return known.frame;
  known.revision = editing.revision();
  known.count = offer.readings().size();
  const document::Document& document = editing.document();
  std::vector<rig::Pose> poses;
  for (std::size_t i = 0; i < shown_count(offer); ++i) {
    const rig::Pose& pose = offer.readings()[i].pose;
    if (pose.size() == document.pose.size()) poses.push_back(pose);
  }
  const PictureFrame face =
      seen_from(*document.model, context.pictures.frame_of(editing, FacePart::all), canvas.view().camera);
  known.frame = frame_of_differences(*document.model, document.pose, poses, face);
  return known.frame;
}

std::string tip_of_reading(const OfferedReading& one, bool of_face) {
  if (of_face) {
    const auto* named = one.command.get_if<document::NameFaceLine>();
    const bool form = named != nullptr && named->form;
    return one.words + ": the line is " + (form ? "the form of the " : "the ") + feature_words(one.feature) +
           "; press to take it";
  }
  const std::string likely = one.percent ? " (" + std::to_string(*one.percent) + " % likely)" : "";
  return one.words + likely + ": the face shows it; press to take it, and Undo takes it back";
}

}  // namespace

FaceReadingsSize face_readings_size(const PanelContext& context, const ReadingOffer& offer, float wide, float high) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const auto count = static_cast<float>(shown_count(offer));
  const float rest = (count - 1) * style.ItemSpacing.x + 2 * style.WindowPadding.x + 1;
  const float most = std::clamp(high, k_narrowest_picture * context.unit, k_widest_picture * context.unit);
  const float picture = std::clamp((wide - rest) / std::max(1.0F, count), k_narrowest_picture * context.unit, most);
  return {picture, count * picture + rest, picture_tile_height(context, picture)};
}

bool show_face_readings(PanelContext& context, EditingSession& editing, const Canvas& canvas, ReadingOffer& offer,
                        float picture) {
  auto& place = context.own.of<ReadingsPlace>();
  std::optional<std::size_t> shown;
  std::optional<std::size_t> taken;
  const PictureFrame frame = frame_of_offer(context, editing, canvas, offer);
  for (std::size_t i = 0; i < shown_count(offer); ++i) {
    if (i > 0) ImGui::SameLine();
    const OfferedReading& one = offer.readings()[i];
    const PictureTile tile{picture, context.pictures.place_of(editing, one.pose, frame), one.brief()};
    if (picture_tile(context, ("reading " + std::to_string(i + 1)).c_str(), tile)) taken = i;
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) shown = i;
    tooltip(context, tip_of_reading(one, offer.face_line().has_value()).c_str());
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
