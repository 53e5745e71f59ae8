#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"

namespace penpose::cli {

/// The whole file. Errors: it does not exist, may not be read, or is no regular file or pipe.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> read_file(const std::string& path);

/// Writes all bytes to a temporary file beside `path` and renames it, so that `path` holds either its old or its new
/// content. Who may read it stays as it was; a link stays one, and what is no plain file is written to as it is.
[[nodiscard]] base::Status write_file(const std::string& path, base::Bytes bytes);

/// The file that a chain of symbolic links ends at, whether it exists or not; `path` itself where it is no link.
[[nodiscard]] std::string link_target(std::string path);

/// A new name is in its folder only once the folder is on the disk too; some file systems cannot say.
void flush_folder_of(const std::string& path);

/// Prints "penpose: FILE: PLACE: WHAT; REMEDY" as one line on standard error and returns the exit status of a failure.
int report(const base::Error& error, const std::string& file = {});

/// Prints what a reader or writer has to say of a file on standard error, one line as an error is.
void warn(const std::string& note, const std::string& file);

}  // namespace penpose::cli
