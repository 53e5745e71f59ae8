#pragma once

#include <cstdio>
#include <string>

#include "core/base/result.h"
#include "replay/trace/trace_reader.h"
#include "ui/files/open_file.h"

namespace penpose::files {

/// Opens a trace or a session that the user names. Errors: as of open_input.
[[nodiscard]] inline base::Result<File> open_trace(const std::string& path) { return open_input(path); }

/// The most that is read of a trace: days of drawing.
inline constexpr std::uint64_t k_most_trace_bytes = std::uint64_t{1} << 31;
/// The same of one that comes through a pipe, which may never end.
inline constexpr std::uint64_t k_most_piped_bytes = std::uint64_t{1} << 30;

/// Reads an open file from where it stands; the file must outlive what is returned. Errors: the disk, and more bytes
/// than these.
[[nodiscard]] replay::ReadBytes read_from_file(std::FILE* file);

/// The same for a recording of any kind (replay/recording), as the trace that it comes to. Errors: also those of its
/// form.
[[nodiscard]] replay::ReadBytes read_recording_file(std::FILE* file);

}  // namespace penpose::files
