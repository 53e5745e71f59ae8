#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "ui/app/controls/controls.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/panels/panels.h"

namespace penpose::app {

/// A row of the list of controls: one, or the two of a pair.
struct ControlRow {
  std::size_t first = 0;
  std::size_t second = static_cast<std::size_t>(-1);  ///< of a pair: the right one; else none
  [[nodiscard]] bool pair() const { return second != static_cast<std::size_t>(-1); }
};

/// Rows in the order of the parameters, pairs where their first comes. Parameters that `wanted` leaves out are in none;
/// a pair of which one is wanted shows both.
[[nodiscard]] std::vector<ControlRow> control_rows(std::span<const rig::Parameter> parameters,
                                                   const std::vector<bool>& wanted);

/// Sliders, locks and what else there is to a row.
void show_control_row(PanelContext& context, const ControlRow& row, EditingSession& editing, Controls& controls,
                      Dialogs& dialogs);

}  // namespace penpose::app
