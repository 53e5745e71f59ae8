#include <algorithm>
#include <array>
#include <type_traits>

#include "ui/app/owners.h"
#include "ui/app/panels/panels.h"

namespace penpose::app {

// Each stands in a file of this folder. A new one is that file, a line here and a row below.
void show_open_dialog(PanelContext&, Files&, Leaving&, Preferences&, Dialogs&);
void show_save_dialog(PanelContext&, Files&, Leaving&, Preferences&, Dialogs&);
void show_export_dialog(PanelContext&, Files&, Notices&, Preferences&, Dialogs&);
void show_recent_dialog(PanelContext&, Leaving&, Preferences&);
void show_recover_dialog(PanelContext&, Recovery&);
void show_steps_dialog(PanelContext&);
void show_tablet_dialog(PanelContext&, HandDesk&, Bindings&, Preferences&, Dialogs&);
void show_pad_dialog(PanelContext&, EditingSession&, HandDesk&, Bindings&, Preferences&, Dialogs&);
void show_sessions_dialog(PanelContext&, Files&, Recording&, Notices&, Dialogs&);
void show_unsaved_dialog(PanelContext&, Leaving&, Dialogs&);
void show_older_session_dialog(PanelContext&, Files&, Notices&, Dialogs&);
void show_drawn_again_dialog(PanelContext&, Dialogs&);
void show_number_dialog(PanelContext&, EditingSession&, Controls&, Notices&, Dialogs&);
void show_key_dialog(PanelContext&, Keys&, Dialogs&);
void show_radial_dialog(PanelContext&, Preferences&, Dialogs&);
void show_shortcuts_dialog(PanelContext&, EditingSession&, Playback&, Preferences&, Leaving&, Dialogs&, PanelState&);
void show_search_dialog(PanelContext&, EditingSession&, Playback&, Preferences&, Leaving&, Dialogs&, PanelState&);
void show_history_dialog(PanelContext&, EditingSession&, Playback&, Dialogs&);
void show_film_dialog(PanelContext&, EditingSession&, Playback&, FilmWriter&, Files&, Dialogs&);
void show_backdrop_dialog(PanelContext&, ReferenceDesk&, Files&, Preferences&, Dialogs&);
void show_preferences_dialog(PanelContext&, const EditingSession&, Playback&, Preferences&, const Recording&,
                             const SystemDialogs&, Dialogs&, PanelState&, PoseShelf&);
void show_keyboard_dialog(PanelContext&, Preferences&, Dialogs&);
void show_sound_dialog(PanelContext&, EditingSession&, SoundTrack&, Files&, Preferences&, Dialogs&);
void show_bookmark_dialog(PanelContext&, EditingSession&, const Playback&, Dialogs&);
void show_clips_dialog(PanelContext&, EditingSession&, Playback&, Dialogs&);
void show_drop_dialog(PanelContext&, DropDesk&);
void show_cameras_dialog(PanelContext&, EditingSession&, CameraDesk&, Dialogs&);
void show_first_pass_dialog(PanelContext&, EditingSession&, SoundTrack&, KeptMouths&, FirstPass&, Files&, Preferences&,
                            Dialogs&);
void show_model_notes_dialog(PanelContext&, const EditingSession&, const UndrawnTextures&);
void show_add_character_dialog(PanelContext&, Files&, Notices&, Preferences&, Dialogs&);
void show_characters_dialog(PanelContext&, Cast&, Files&, Dialogs&);

namespace {

struct DialogRow {
  Dialog dialog;
  void (*show)(PanelContext& context, App& app);
};

template <typename... Owners>
void call_dialog(PanelContext& context, App& app, void (*dialog)(PanelContext&, Owners&...)) {
  dialog(context, app.of<std::remove_const_t<Owners>>()...);
}

/// A dialog with the owners that it takes.
template <auto dialog>
void show(PanelContext& context, App& app) {
  call_dialog(context, app, dialog);
}

constexpr std::array k_dialogs{
    DialogRow{Dialog::open, show<show_open_dialog>},
    DialogRow{Dialog::save, show<show_save_dialog>},
    DialogRow{Dialog::export_as, show<show_export_dialog>},
    DialogRow{Dialog::recent, show<show_recent_dialog>},
    DialogRow{Dialog::recover, show<show_recover_dialog>},
    DialogRow{Dialog::steps, show<show_steps_dialog>},
    DialogRow{Dialog::tablet, show<show_tablet_dialog>},
    DialogRow{Dialog::pad, show<show_pad_dialog>},
    DialogRow{Dialog::sessions, show<show_sessions_dialog>},
    DialogRow{Dialog::unsaved, show<show_unsaved_dialog>},
    DialogRow{Dialog::older_session, show<show_older_session_dialog>},
    DialogRow{Dialog::drawn_again, show<show_drawn_again_dialog>},
    DialogRow{Dialog::number, show<show_number_dialog>},
    DialogRow{Dialog::key_name, show<show_key_dialog>},
    DialogRow{Dialog::radial, show<show_radial_dialog>},
    DialogRow{Dialog::shortcuts, show<show_shortcuts_dialog>},
    DialogRow{Dialog::search, show<show_search_dialog>},
    DialogRow{Dialog::history, show<show_history_dialog>},
    DialogRow{Dialog::film, show<show_film_dialog>},
    DialogRow{Dialog::backdrop, show<show_backdrop_dialog>},
    DialogRow{Dialog{"preferences"}, show<show_preferences_dialog>},
    DialogRow{Dialog{"keyboard"}, show<show_keyboard_dialog>},
    DialogRow{Dialog::sound, show<show_sound_dialog>},
    DialogRow{Dialog{"bookmark"}, show<show_bookmark_dialog>},
    DialogRow{Dialog{"add character"}, show<show_add_character_dialog>},
    DialogRow{Dialog{"characters"}, show<show_characters_dialog>},
    DialogRow{Dialog{"clips"}, show<show_clips_dialog>},
    DialogRow{Dialog{"model notes"}, show<show_model_notes_dialog>},
    DialogRow{Dialog{"drop"}, show<show_drop_dialog>},
    DialogRow{Dialog{"cameras"}, show<show_cameras_dialog>},
    DialogRow{Dialog{"first pass"}, show<show_first_pass_dialog>},
};

}  // namespace

void show_dialog(PanelContext& context, App& app) {
  const Dialogs& dialogs = app.of<Dialogs>();
  const Dialog dialog = dialogs.open();
  const auto row =
      std::find_if(k_dialogs.begin(), k_dialogs.end(), [&](const DialogRow& one) { return one.dialog == dialog; });
  if (row == k_dialogs.end()) return;
  row->show(context, app);
  if (context.cancels && dialogs.open() == dialog) context.actions.run(Action::cancel);
}

}  // namespace penpose::app
