#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "ui/app/panels/timeline/timeline_strip.h"
#include "ui/app/playback/sheet/sheet_rows.h"

// What the sheet and the curves have in common. Private to the timeline.

namespace penpose::app {

/// The rows of the document as they are folded. Valid until the document changes.
[[nodiscard]] const std::vector<SheetRow>& rows_of(const TimelineOwners& with);
/// Their names at the left: a touch of a group folds it, of a control chooses its curve. A wheel or a drag scrolls.
void show_row_names(PanelContext& context, const TimelineOwners& with, std::span<const SheetRow> rows, float row_height,
                    float height);

/// A bar above the selected keys, from the first of them to the last.
void show_selection_bar(PanelContext& context, const TimelineOwners& with, const Strip& strip);
/// The end of the bar that is below the pointer: true the last, false the first.
[[nodiscard]] std::optional<bool> selection_end_below(const PanelContext& context, const TimelineOwners& with,
                                                      const Strip& strip, ImVec2 at);
/// About which moment, and by how much, keys are scaled whose last one (else whose first one) comes to a moment.
[[nodiscard]] std::pair<double, double> scaled_selection(const KeySelection& keys, double to_s, bool last, int rate);

}  // namespace penpose::app
