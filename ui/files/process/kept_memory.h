#pragma once

namespace penpose::files {

/// For programs that draw: what is freed goes back to the system at once where it is large, as an unpacked picture is,
/// and threads that allocate little share one heap. Otherwise some tens of megabytes stay set aside for each thread.
/// Call it before other threads start.
void keep_little_memory();

/// What was freed goes back to the system, after much was allocated that nobody asks for again.
void give_back_memory();

}  // namespace penpose::files
