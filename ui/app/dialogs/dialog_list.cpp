#include <algorithm>
#include <array>

#include "ui/app/panels/panels.h"

namespace penpose::app {

// Each stands in a file of this folder. A new one is that file, a line here and a row below.
void show_open_dialog(PanelContext& context);
void show_save_dialog(PanelContext& context);
void show_export_dialog(PanelContext& context);
void show_recent_dialog(PanelContext& context);
void show_recover_dialog(PanelContext& context);
void show_steps_dialog(PanelContext& context);
void show_tablet_dialog(PanelContext& context);
void show_pad_dialog(PanelContext& context);
void show_sessions_dialog(PanelContext& context);
void show_unsaved_dialog(PanelContext& context);
void show_number_dialog(PanelContext& context);
void show_key_dialog(PanelContext& context);
void show_radial_dialog(PanelContext& context);
void show_shortcuts_dialog(PanelContext& context);
void show_search_dialog(PanelContext& context);
void show_history_dialog(PanelContext& context);
void show_film_dialog(PanelContext& context);
void show_backdrop_dialog(PanelContext& context);

namespace {

struct DialogRow {
  Dialog dialog;
  void (*show)(PanelContext& context);
};

constexpr std::array k_dialogs{
    DialogRow{Dialog::open, show_open_dialog},         DialogRow{Dialog::save, show_save_dialog},
    DialogRow{Dialog::export_as, show_export_dialog},  DialogRow{Dialog::recent, show_recent_dialog},
    DialogRow{Dialog::recover, show_recover_dialog},   DialogRow{Dialog::steps, show_steps_dialog},
    DialogRow{Dialog::tablet, show_tablet_dialog},     DialogRow{Dialog::pad, show_pad_dialog},
    DialogRow{Dialog::sessions, show_sessions_dialog}, DialogRow{Dialog::unsaved, show_unsaved_dialog},
    DialogRow{Dialog::number, show_number_dialog},     DialogRow{Dialog::key_name, show_key_dialog},
    DialogRow{Dialog::radial, show_radial_dialog},     DialogRow{Dialog::shortcuts, show_shortcuts_dialog},
    DialogRow{Dialog::search, show_search_dialog},     DialogRow{Dialog::history, show_history_dialog},
    DialogRow{Dialog::film, show_film_dialog},         DialogRow{Dialog::backdrop, show_backdrop_dialog},
};

}  // namespace

void show_dialog(PanelContext& context) {
  const Dialog dialog = context.app.dialogs().open();
  const auto row =
      std::find_if(k_dialogs.begin(), k_dialogs.end(), [&](const DialogRow& one) { return one.dialog == dialog; });
  if (row == k_dialogs.end()) return;
  row->show(context);
  if (context.cancels && context.app.dialogs().open() == dialog) context.app.do_action(Action::cancel);
}

}  // namespace penpose::app
