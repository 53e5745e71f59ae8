#pragma once

#include <string_view>

#include "replay/trace/trace_reader.h"

namespace penpose::replay {

/// The most of a file's front that is looked at to recognise it.
inline constexpr std::size_t k_front = std::size_t{1} << 16;

/// A form in which people have recordings: another program's text or bytes, or a wrapper around any other form.
struct RecordingFormat {
  std::string_view name;  ///< as people call it: "usbhid-dump", "gzip"

  /// Of bytes: whether a file is of the format that begins with these, k_front of them or all of a shorter file. Null
  /// for formats of text.
  bool (*recognises)(base::Bytes front);
  /// Of text: whether a line, without its end and without colours, indentation and quotes, is one that no other text
  /// has. The first such line of a file decides. Null for formats of bytes.
  bool (*marks)(std::string_view line);

  /// The file's bytes as those of a trace, or of the form inside a wrapper. Memory does not grow with the file. Errors
  /// come out of what it returns: those of `read`, and its own with their place in the file. Null: see `refusal`.
  ReadBytes (*convert)(ReadBytes read);
  /// Of a format that is known but cannot be read: what it is and what to do instead. Null as well as `convert`: it is
  /// a trace already.
  base::Error (*refusal)();
};

}  // namespace penpose::replay
