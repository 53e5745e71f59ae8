#include "ui/app/action_rows.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/document/time/timeline.h"
#include "ui/app/app.h"
#include "ui/app/input/side_pairs.h"
#include "ui/app/session/frames.h"
#include "ui/app/session/pose_clipboard.h"
#include "ui/app/view/backdrop.h"

// What actions do, a row each. They reach the app as panels do.

namespace penpose::app {
namespace {

struct Row {
  Action action;
  void (*run)(App& app);
};

void open_dialog(App& app, Dialog dialog) {
  app.panels().search_text.clear();
  app.panels().search_chosen = 0;
  app.panels().dialog = dialog;
}

/// Sets the pose that is made of the one there is.
template <typename Make>
void change_pose(App& app, const char* unchanged, const Make& make) {
  Workspace& workspace = app.workspace();
  const document::Document& document = workspace.document();
  const auto parameters = document.model->rig->parameters();
  const auto command =
      values_between(parameters, document.pose, make(parameters, document::weight_count(*document.model)));
  if (command.values.empty()) return app.tell(unchanged);
  workspace.perform(command);
}

void copy_side(App& app, bool from_left) {
  change_pose(app, "both sides are the same already", [&](auto parameters, std::size_t count) {
    return copied_over(parameters, app.workspace().two_sided_pairs(), app.workspace().document().pose, count,
                       from_left);
  });
}

void step(App& app, int frames) { app.go_to(step_frame(app.panels().time_s, frames, app.panels().rate)); }

template <typename Enum>
Enum next_of(Enum value, int count) {
  return static_cast<Enum>((static_cast<int>(value) + 1) % count);
}

constexpr std::array k_rows{
    Row{Action::undo, [](App& app) { app.undo(); }},
    Row{Action::redo, [](App& app) { app.redo(); }},
    Row{Action::shortcuts, [](App& app) { open_dialog(app, Dialog::shortcuts); }},
    Row{Action::search, [](App& app) { open_dialog(app, Dialog::search); }},
    Row{Action::history, [](App& app) { open_dialog(app, Dialog::history); }},
    Row{Action::library,
        [](App& app) {
          app.panels().shown = true;
          app.panels().poses_tab = !app.panels().poses_tab;
          app.panels().controls_tab = false;
        }},
    Row{Action::film,
        [](App& app) {
          app.panels().file_name.clear();
          open_dialog(app, Dialog::film);
        }},
    Row{Action::previous_frame, [](App& app) { step(app, -1); }},
    Row{Action::next_frame, [](App& app) { step(app, 1); }},
    Row{Action::copy_key,
        [](App& app) {
          app.panels().clipboard = copied_pose(app.workspace().document(), app.panels().time_s);
          app.tell("the pose is copied: Paste keys it at another moment");
        }},
    Row{Action::paste_key,
        [](App& app) {
          if (!app.panels().clipboard) return app.tell("there is no pose to paste: copy one first");
          paste_pose(app.workspace(), *app.panels().clipboard, app.panels().time_s);
        }},
    Row{Action::loop_from, [](App& app) { app.panels().loop.begin_at(app.panels().time_s); }},
    Row{Action::loop_to, [](App& app) { app.panels().loop.end_at(app.panels().time_s); }},
    Row{Action::loop_off, [](App& app) { app.panels().loop = {}; }},
    Row{Action::perform, [](App& app) { app.panels().performs = !app.panels().performs; }},
    Row{Action::auto_key, [](App& app) { app.panels().auto_key = !app.panels().auto_key; }},
    Row{Action::mirror_strokes, [](App& app) { app.panels().mirrors = !app.panels().mirrors; }},
    Row{Action::flip_pose,
        [](App& app) {
          change_pose(app, "both sides are the same: nothing to exchange", [&](auto parameters, std::size_t count) {
            return flipped(parameters, side_pairs(parameters), app.workspace().document().pose, count);
          });
        }},
    Row{Action::copy_to_right, [](App& app) { copy_side(app, true); }},
    Row{Action::copy_to_left, [](App& app) { copy_side(app, false); }},
    Row{Action::stabiliser,
        [](App& app) {
          constexpr std::array k_said{"lines are shown as they are drawn", "lines are smoothed a little to the eye",
                                      "lines are smoothed much to the eye"};
          app.settings().stabiliser = next_of(app.settings().stabiliser, 3);
          app.settings_changed();
          app.tell(k_said[static_cast<std::size_t>(app.settings().stabiliser)]);
        }},
    Row{Action::moved_only, [](App& app) { app.panels().moved_only = !app.panels().moved_only; }},
    Row{Action::tour_pose, [](App& app) { app.ask_to_open("tour:pose"); }},
    Row{Action::tour_rig, [](App& app) { app.ask_to_open("tour:rig"); }},
    Row{Action::tour_animate, [](App& app) { app.ask_to_open("tour:animate"); }},
    Row{Action::backdrop,
        [](App& app) {
          const auto& backdrop = app.panels().backdrop;
          if (!backdrop) return open_dialog(app, Dialog::backdrop);
          backdrop->adjusting = !backdrop->adjusting;
        }},
    Row{Action::backdrop_off, [](App& app) { app.panels().backdrop.reset(); }},
    Row{Action::flat_view, [](App& app) { app.set_flat(!app.flat()); }},
    Row{Action::set_front, [](App& app) { app.set_front(); }},
    Row{Action::density,
        [](App& app) {
          app.settings().density = next_of(app.settings().density, 3);
          app.settings_changed();
        }},
};

}  // namespace

bool run_row(App& app, Action action) {
  const auto row = std::find_if(k_rows.begin(), k_rows.end(), [&](const Row& one) { return one.action == action; });
  if (row == k_rows.end()) return false;
  row->run(app);
  return true;
}

}  // namespace penpose::app
