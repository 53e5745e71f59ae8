#include <algorithm>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <string>
#include <string_view>
#include <utility>

#include "ui/app/widgets/internal/widgets.h"

// Fields that are typed into.

namespace penpose::app {
namespace {

/// Of the dialog's field that was shown last.
struct ShownField {
  bool placed = true;  ///< whether its cursor was placed since it took the keyboard
  std::string label;
  std::string text;  ///< as it was shown
};

/// What a field asks while it is typed into.
struct FieldAsks {
  bool& placed;
  const TextCompleter* complete;
  const std::string* other;  ///< what the text became without being typed, or null
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

void write(ImGuiInputTextCallbackData& data, const std::string& text) {
  if (text == data.Buf) return;
  data.DeleteChars(0, data.BufTextLen);
  data.InsertChars(0, text.c_str());
}

int answer_field(ImGuiInputTextCallbackData* data) {
  const auto& asks = *static_cast<FieldAsks*>(data->UserData);
  if (data->EventFlag == ImGuiInputTextFlags_CallbackCompletion) {
    write(*data, (*asks.complete)(data->Buf));
    return 0;
  }
  // A field that is typed into keeps its own text.
  if (asks.other != nullptr) write(*data, *asks.other);
  if (!std::exchange(asks.placed, true)) place_cursor(*data);
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
  ShownField& shown = context.own.of<ShownField>();
  if (context.field_first) {
    ImGui::SetKeyboardFocusHere();
    shown.placed = false;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {8, 0.5F * (context.unit - ImGui::GetFontSize())});
  ImGui::SetNextItemWidth(-1);
  const std::string now = text;
  FieldAsks asks{shown.placed, complete, shown.label == label && shown.text != now ? &now : nullptr};
  ImGuiInputTextFlags flags = ImGuiInputTextFlags_CallbackAlways;
  if (complete != nullptr) flags |= ImGuiInputTextFlags_CallbackCompletion;
  ImGui::InputTextWithHint(label, hint, &text, flags, answer_field, &asks);
  shown.label = label;
  shown.text = text;
  note_field(context, label);
  ImGui::PopStyleVar();
}

bool text_field(PanelContext& context, const char* label, std::string& text, float width, const char* hint,
                bool* accepted) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {8, 0.5F * (context.unit - ImGui::GetFontSize())});
  ImGui::SetNextItemWidth(width);
  // A value is typed over as a whole.
  const ImGuiInputTextFlags flags = accepted != nullptr ? ImGuiInputTextFlags_AutoSelectAll : ImGuiInputTextFlags_None;
  const bool changed = ImGui::InputTextWithHint(label, hint, &text, flags);
  note_field(context, label);
  if (accepted != nullptr) {
    *accepted = ImGui::IsItemDeactivated() && (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter)) ||
                                               ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter)));
  }
  ImGui::PopStyleVar();
  return changed;
}

}  // namespace penpose::app
