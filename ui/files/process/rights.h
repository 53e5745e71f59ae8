#pragma once

namespace penpose::files {

/// What a command may still ask of the system; docs/security.md says how that was decided.
enum class Rights {
  all,          ///< the window, and what reads or sets up devices
  no_programs,  ///< starts no program
  reads_only,   ///< nor makes, changes or removes any file: what is open stays so
};

/// Gives up all other rights for good, for this program and all that it starts; does nothing where the kernel has no
/// Landlock, which is no error. Returns whether they are given up.
bool keep_only(Rights rights);

}  // namespace penpose::files
