#include "ui/app/face/neutral_face.h"

#include "ui/app/notices.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

void keep_neutral(EditingSession& editing, Notices& notices) {
  const bool drawn = editing.document().face != nullptr;
  if (!drawn && !editing.document().neutral)
    return notices.tell("draw the face at rest first, then say that this is your neutral face");
  if (!editing.perform(document::SetNeutral{drawn})) return;
  notices.tell(drawn ? "this is your neutral face now: drawings to come are read in its proportions"
                     : "your neutral face is forgotten");
}

}  // namespace penpose::app
