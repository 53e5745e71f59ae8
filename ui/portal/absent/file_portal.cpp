#include "ui/portal/portal.h"

namespace penpose::portal {

std::unique_ptr<FilePortal> make_file_portal(std::function<void()> /*wake*/) { return nullptr; }

}  // namespace penpose::portal
