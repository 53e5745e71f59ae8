#include "ui/app/canvas/undrawn_textures.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/panels/panels.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/widgets/internal/widgets.h"

// What was noticed about the model.

namespace penpose::app {

void show_model_notes_dialog(PanelContext& context, const EditingSession& editing, const UndrawnTextures& undrawn) {
  if (begin_dialog(context, "Model notes", 16)) {
    const std::vector<std::string> notes = notes_of(*editing.document().model, undrawn);
    if (notes.empty()) ImGui::TextWrapped("Nothing was noticed: all of the file is shown and can be posed.");
    for (const std::string& note : notes) {
      ImGui::TextWrapped("%s", note.c_str());
      ImGui::Dummy({1, context.gap});
    }
    if (wide_button(context, "Close", -1) || context.accepts) context.actions.run(Action::cancel);
  }
  end_dialog();
}

}  // namespace penpose::app
