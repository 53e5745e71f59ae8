#pragma once

#include "replay/trace/trace_reader.h"

namespace penpose::replay {

/// Any recording as a trace in hid-recorder's text form, recognised by its content (table in recording.cpp). Wrappers
/// may lie around each other: gzip, UTF-16, colours or quotes, another program's text.
///
/// A trace or session passes through byte by byte, as does what nobody recognises. Nothing is read before the first
/// call. Errors: those of `read`, those of the format, and what cannot be read, named with the remedy.
[[nodiscard]] ReadBytes read_recording(ReadBytes read);

}  // namespace penpose::replay
