#include <filesystem>
#include <string>

#include "ui/app/dialogs/dialogs.h"
#include "ui/app/files/drop_desk.h"
#include "ui/app/panels/panels.h"
#include "ui/app/widgets/internal/widgets.h"

// The card of a file that was dropped: what it is, and what will happen. Return does the first.

namespace penpose::app {

void show_drop_dialog(PanelContext& context, DropDesk& drops) {
  if (begin_dialog(context, "Dropped", 12)) {
    const std::string path = drops.path();
    const std::string name = std::filesystem::path(path).filename().string();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::TextUnformatted(fitted_text(name, width).c_str());
    ImGui::TextDisabled("is %s", std::string(words_of(drops.kind())).c_str());
    if (drops.more() > 0) ImGui::TextDisabled("%zu more wait behind it", drops.more());
    bool usual = true;
    bool answered = false;
    for (const DropDeed deed : deeds_of(drops.kind())) {
      if (answered) break;
      const DropDeedWords words = words_of(deed);
      const std::string label = std::string(words.label) + "##drop";
      const bool pressed = usual ? primary_button(context, label.c_str(), -1, words.tip)
                                 : wide_button(context, label.c_str(), -1, false, words.tip);
      answered = pressed || (usual && context.accepts);
      usual = false;
      if (answered) drops.answer(deed);
    }
    if (!answered && (wide_button(context, "Cancel##drop", -1) || context.cancels)) drops.cancel();
  }
  end_dialog();
}

}  // namespace penpose::app
