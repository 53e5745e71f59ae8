#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "ui/app/panels/side/row_menu.h"

namespace penpose::app {

/// A row of the list of controls: one, or the two of a pair.
struct ControlRow {
  std::size_t first = 0;
  std::size_t second = static_cast<std::size_t>(-1);  ///< of a pair: the right one; else none
  [[nodiscard]] bool pair() const { return second != static_cast<std::size_t>(-1); }
  friend bool operator==(const ControlRow&, const ControlRow&) = default;
};

/// Rows in the order of the parameters, pairs where their first comes. Parameters that `wanted` leaves out are in none;
/// a pair of which one is wanted shows both.
[[nodiscard]] std::vector<ControlRow> control_rows(std::span<const rig::Parameter> parameters,
                                                   const std::vector<bool>& wanted);
/// The names of its controls.
[[nodiscard]] ControlNames names_in(const ControlRow& row, std::span<const rig::Parameter> parameters);
/// What both of a row, or the one, do.
[[nodiscard]] std::string words_in(const ControlRow& row, std::span<const document::ControlWords> words);

/// How the rows of a list look.
struct ControlRowLook {
  float name = 0;            ///< px of the column of names; 0: too narrow, they stand on sliders and above pairs
  std::vector<double> seen;  ///< values of the frame before, one a parameter: numbers stand beside what changes
};
/// The column of names in a list that is so wide, px, where rows say that much; 0: there is no room for one.
[[nodiscard]] float name_column(const PanelContext& context, float room, float longest);
/// How wide a list would be in which all names are whole, px.
[[nodiscard]] float whole_rows_width(const PanelContext& context, float longest);

/// Sliders of a row, its name, and on it what else there is to a row: a touch of the name, or a long press anywhere,
/// opens its menu. `group`: all that are listed with it.
void show_control_row(PanelContext& context, const ControlRow& row, const ControlRowLook& look, const RowGroup& group,
                      const RowOwners& with);

}  // namespace penpose::app
