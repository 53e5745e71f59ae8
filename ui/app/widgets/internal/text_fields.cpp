#include <algorithm>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <string_view>
#include <utility>

#include "ui/app/widgets/internal/widgets.h"

// Fields that are typed into.

namespace penpose::app {
namespace {

/// Whether the cursor was placed in the field of a dialog that has just taken the keyboard.
struct FieldCursor {
  bool placed = true;
};

/// What a field asks while it is typed into.
struct FieldAsks {
  bool& placed;
  const TextCompleter* complete;
};

/// Puts the cursor at the end of a field that has just taken the keyboard; of a file's name all but its ending is
/// chosen, so that typing writes another name.
void place_cursor(ImGuiInputTextCallbackData& data) {
  const std::string_view text(data.Buf, static_cast<std::size_t>(data.BufTextLen));
  const std::size_t dot = text.rfind('.');
  const bool file = dot != std::string_view::npos && dot > 0 && dot + 4 == text.size() && text[dot + 1] >= 'a';
  data.CursorPos = file ? static_cast<int>(dot) : data.BufTextLen;
  data.SelectionStart = file ? 0 : data.CursorPos;
  data.SelectionEnd = data.CursorPos;
}

int answer_field(ImGuiInputTextCallbackData* data) {
  const auto& asks = *static_cast<FieldAsks*>(data->UserData);
  if (data->EventFlag != ImGuiInputTextFlags_CallbackCompletion) {
    if (!std::exchange(asks.placed, true)) place_cursor(*data);
    return 0;
  }
  const std::string text = (*asks.complete)(data->Buf);
  if (text == data->Buf) return 0;
  data->DeleteChars(0, data->BufTextLen);
  data->InsertChars(0, text.c_str());
  return 0;
}

}  // namespace

void note_field(PanelContext& context, const char* label) {
  note(context, label);
  if (ImGui::IsItemVisible()) context.fields.push_back(context.targets[label]);
  if (ImGui::IsItemActive()) context.typed_into = context.targets[label];
}

void dialog_field(PanelContext& context, const char* label, std::string& text, const char* hint,
                  const TextCompleter* complete) {
  context.has_field = true;
  if (context.field_first) {
    ImGui::SetKeyboardFocusHere();
    context.own.of<FieldCursor>().placed = false;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {8, 0.5F * (context.unit - ImGui::GetFontSize())});
  ImGui::SetNextItemWidth(-1);
  FieldAsks asks{context.own.of<FieldCursor>().placed, complete};
  ImGuiInputTextFlags flags = ImGuiInputTextFlags_CallbackAlways;
  if (complete != nullptr) flags |= ImGuiInputTextFlags_CallbackCompletion;
  ImGui::InputTextWithHint(label, hint, &text, flags, answer_field, &asks);
  note_field(context, label);
  ImGui::PopStyleVar();
}

bool text_field(PanelContext& context, const char* label, std::string& text, float width, const char* hint,
                bool* accepted) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {8, 0.5F * (context.unit - ImGui::GetFontSize())});
  ImGui::SetNextItemWidth(width);
  const bool changed = ImGui::InputTextWithHint(label, hint, &text);
  note_field(context, label);
  if (accepted != nullptr) {
    *accepted = ImGui::IsItemDeactivated() && (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter)) ||
                                               ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter)));
  }
  ImGui::PopStyleVar();
  return changed;
}

}  // namespace penpose::app
