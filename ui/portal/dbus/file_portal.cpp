#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "ui/portal/dbus/messages.h"

namespace penpose::portal {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

/// Within so long a portal says that it has taken the question.
constexpr milliseconds k_moment{2000};
constexpr int k_look_ms = 100;

/// One question, of which the thread that asks it and whoever waits for the answer each hold a share: a bus that hangs
/// keeps nobody from ending.
struct Question {
  FileQuestion asked;
  std::string token;
  std::function<void()> wake;
  Clock::time_point began = Clock::now();

  std::mutex guard;
  std::condition_variable ended;
  bool taken = false;     // guarded: a portal has taken it
  bool given_up = false;  // guarded: nobody waits for it, and `wake` may be called no more
  bool done = false;      // guarded
  FileAnswer answer;      // guarded

  bool left() {
    const std::lock_guard hold(guard);
    return given_up;
  }
  void finish(FileAnswer is) {
    const std::lock_guard hold(guard);
    answer = std::move(is);
    done = true;
    ended.notify_all();
    if (!given_up && wake) wake();
  }
};

struct Close {
  void operator()(DBusConnection* bus) const {
    dbus_connection_close(bus);
    dbus_connection_unref(bus);
  }
};
using Bus = std::unique_ptr<DBusConnection, Close>;

/// The session's bus, where there is one: none is started for this.
Bus session_bus() {
  const char* address = std::getenv("DBUS_SESSION_BUS_ADDRESS");
  const char* runtime = std::getenv("XDG_RUNTIME_DIR");
  std::string where;
  if (address != nullptr && *address != 0) {
    where = address;
  } else if (runtime != nullptr && *runtime == '/') {
    where = std::string("unix:path=") + runtime + "/bus";
  } else {
    return nullptr;
  }
  Bus bus(dbus_connection_open_private(where.c_str(), nullptr));
  if (!bus || dbus_bus_register(bus.get(), nullptr) == 0) return nullptr;
  dbus_connection_set_exit_on_disconnect(bus.get(), 0);
  return bus;
}

/// Listens for the answer of a request and for the end of the portal. False: the bus refuses.
bool listen(DBusConnection* bus, const std::string& path) {
  const std::string response =
      "type='signal',interface='org.freedesktop.portal.Request',member='Response',path='" + path + "'";
  dbus_bus_add_match(bus, response.c_str(), nullptr);
  const std::string owner =
      std::string("type='signal',sender='org.freedesktop.DBus',member='NameOwnerChanged',arg0='") + k_service + "'";
  dbus_bus_add_match(bus, owner.c_str(), nullptr);
  return dbus_connection_get_is_connected(bus) != 0;
}

/// Whether a message says that nobody is the portal any more.
bool is_end_of_portal(DBusMessage* message) {
  if (dbus_message_is_signal(message, DBUS_INTERFACE_DBUS, "NameOwnerChanged") == 0) return false;
  const char* name = nullptr;
  const char* before = nullptr;
  const char* after = nullptr;
  if (dbus_message_get_args(message, nullptr, DBUS_TYPE_STRING, &name, DBUS_TYPE_STRING, &before, DBUS_TYPE_STRING,
                            &after, DBUS_TYPE_INVALID) == 0)
    return false;
  return std::string_view(name) == k_service && *before != 0 && *after == 0;
}

/// The object that a reply says stands for the request; empty: the portal refused.
std::string path_of_reply(DBusMessage* reply) {
  const char* path = nullptr;
  if (dbus_message_get_type(reply) != DBUS_MESSAGE_TYPE_METHOD_RETURN ||
      dbus_message_get_args(reply, nullptr, DBUS_TYPE_OBJECT_PATH, &path, DBUS_TYPE_INVALID) == 0)
    return {};
  return path;
}

void close_request(DBusConnection* bus, const std::string& path) {
  const Message close(dbus_message_new_method_call(k_service, path.c_str(), "org.freedesktop.portal.Request", "Close"));
  if (!close) return;
  dbus_message_set_no_reply(close.get(), 1);
  dbus_connection_send(bus, close.get(), nullptr);
  dbus_connection_flush(bus);
}

/// A question on its way over the bus.
class Request {
 public:
  Request(Question& question, DBusConnection* bus)
      : question_(question), bus_(bus), path_(request_path(dbus_bus_get_unique_name(bus), question.token)) {}

  FileAnswer run() {
    const Message call = call_of(question_.asked, question_.token);
    if (!call || !listen(bus_, path_) || dbus_connection_send(bus_, call.get(), &serial_) == 0) return k_none;
    while (dbus_connection_read_write(bus_, k_look_ms) != 0) {
      while (true) {
        const Message message(dbus_connection_pop_message(bus_));
        if (!message) break;
        if (const auto answer = take(message.get())) return *answer;
      }
      const bool late = !taken_ && Clock::now() - question_.began > k_moment;
      if (!late && !question_.left()) continue;
      close_request(bus_, path_);
      return k_none;
    }
    return k_none;
  }

 private:
  inline static const FileAnswer k_none{FileAnswer::Kind::unavailable, {}};

  /// The answer, where the message is one.
  std::optional<FileAnswer> take(DBusMessage* message) {
    if (dbus_message_is_signal(message, "org.freedesktop.portal.Request", "Response") != 0 &&
        dbus_message_has_path(message, path_.c_str()) != 0)
      return answer_of(message);
    if (taken_ && is_end_of_portal(message)) return k_none;
    if (dbus_message_get_reply_serial(message) != serial_) return std::nullopt;
    const std::string said = path_of_reply(message);
    // Old portals name it as they like.
    if (said.empty() || (said != path_ && !listen(bus_, said))) return k_none;
    path_ = said;
    taken_ = true;
    const std::lock_guard hold(question_.guard);
    question_.taken = true;
    return std::nullopt;
  }

  Question& question_;
  DBusConnection* bus_;
  std::string path_;
  dbus_uint32_t serial_ = 0;
  bool taken_ = false;
};

FileAnswer ask_bus(Question& question) {
  const Bus bus = session_bus();
  if (!bus) return {FileAnswer::Kind::unavailable, {}};
  return Request(question, bus.get()).run();
}

class DbusFilePortal : public FilePortal {
 public:
  explicit DbusFilePortal(std::function<void()> wake) : wake_(std::move(wake)) { dbus_threads_init_default(); }
  ~DbusFilePortal() override { give_up(); }

  void ask(const FileQuestion& question) override {
    give_up();
    question_ = std::make_shared<Question>();
    question_->asked = question;
    question_->token = "penpose" + std::to_string(++count_);
    question_->wake = wake_;
    std::thread([shared = question_] { shared->finish(ask_bus(*shared)); }).detach();
  }

  FileAnswer take() override {
    if (!question_) return {};
    FileAnswer answer;
    {
      const std::lock_guard hold(question_->guard);
      // A bus that hangs before it has taken the question is none.
      const bool late = !question_->taken && Clock::now() - question_->began > k_moment + k_moment;
      if (!question_->done && !late) return {};
      answer = question_->done ? question_->answer : FileAnswer{FileAnswer::Kind::unavailable, {}};
      question_->given_up = true;
    }
    question_.reset();
    return answer;
  }

 private:
  /// Closes what is open. Waits for the thread no longer than it needs to look up.
  void give_up() {
    if (!question_) return;
    std::unique_lock hold(question_->guard);
    question_->given_up = true;
    question_->ended.wait_for(hold, milliseconds(3 * k_look_ms), [&] { return question_->done; });
    hold.unlock();
    question_.reset();
  }

  std::function<void()> wake_;
  std::shared_ptr<Question> question_;
  int count_ = 0;
};

}  // namespace

std::unique_ptr<FilePortal> make_file_portal(std::function<void()> wake) {
  return std::make_unique<DbusFilePortal>(std::move(wake));
}

}  // namespace penpose::portal
