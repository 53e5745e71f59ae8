#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"

namespace penpose::files {

// The most bytes that a reader takes of one file; what is larger is no such file, or would fill the memory.
inline constexpr std::uint64_t k_most_model_bytes = std::uint64_t{1} << 31;
inline constexpr std::uint64_t k_most_track_bytes = std::uint64_t{1} << 29;
inline constexpr std::uint64_t k_most_text_bytes = std::uint64_t{1} << 26;  ///< what people write or sketch
inline constexpr std::uint64_t k_most_picture_bytes = std::uint64_t{1} << 28;
inline constexpr std::uint64_t k_most_settings_bytes = std::uint64_t{1} << 20;

/// The whole of what the user names: a plain file, a pipe, or "-" for standard input. Errors: as of open_input, and
/// more than `most` bytes.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> read_file(const std::string& path,
                                                                std::uint64_t most = k_most_model_bytes);

/// The whole of a plain file, and of nothing else. Errors: as of open_plain, and more than `most` bytes.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> read_plain_file(const std::string& path,
                                                                      std::uint64_t most = k_most_model_bytes);

/// The whole of a plain file that another one in `folder` names. Errors: as of open_beside, and more than `most` bytes.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> read_beside(const std::string& folder, const std::string& name,
                                                                  std::uint64_t most = k_most_model_bytes);

/// Writes all bytes to a file without a name and gives it that of `path`, so that `path` holds either its old or its
/// new content. Who may read it stays as it was; a link of one's own stays one, what is no plain file is written to as
/// it is, and "-" is standard output.
[[nodiscard]] base::Status write_file(const std::string& path, base::Bytes bytes);

/// The file that a chain of symbolic links ends at, whether it exists or not; `path` itself where it is no link.
[[nodiscard]] std::string link_target(std::string path);

/// A new name is in its folder only once the folder is on the disk too; some file systems cannot say.
void flush_folder_of(const std::string& path);

/// Prints "penpose: FILE: PLACE: WHAT; REMEDY" as one line on standard error and returns the exit status of a failure.
int report(const base::Error& error, const std::string& file = {});

/// Prints what a reader or writer has to say of a file on standard error, one line as an error is.
void warn(const std::string& note, const std::string& file);

}  // namespace penpose::files
