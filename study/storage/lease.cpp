#include "study/storage/lease.h"

#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "study/storage/statement.h"

namespace study::storage {
namespace {

std::string thisStation() {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  return name.data();
}

std::string thisBoot() {
  std::string boot;
  std::ifstream("/proc/sys/kernel/random/boot_id") >> boot;
  return boot;
}

/// The PID namespace of this process. Containers on one computer have the same boot id, but
/// different process numbers.
std::string thisNamespace() {
  std::error_code ignored;
  return std::filesystem::read_symlink("/proc/self/ns/pid", ignored).string();
}

/// Boot id and start time of a process, which distinguish it from a later process with the same
/// number, and the PID namespace. Empty if there is no such process, or if it has ended and its
/// parent has not taken note of that yet.
std::string processMarkOf(std::int64_t pid) {
  std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
  std::string line;
  if (!std::getline(stat, line)) return {};
  // The process name is in parentheses and may itself contain spaces and parentheses.
  std::istringstream fields(line.substr(line.rfind(')') + 1));
  std::string state;
  fields >> state;
  if (state == "Z" || state == "X") return {};
  std::string began;
  constexpr int kStartTimeField = 19;  // field 22; fields 1 to 3 are skipped above
  for (int i = 0; i < kStartTimeField; ++i) fields >> began;
  return thisBoot() + "/" + began + "@" + thisNamespace();
}

/// The program that wrote a row of the table of leases.
struct Writer {
  std::string station;
  std::int64_t pid = 0;
  std::string token;

  /// "boot id/start time@namespace"; release 0.1 wrote no namespace.
  std::string mark() const { return token.substr(0, token.find('#')); }
  bool isOfThisBoot() const { return mark().starts_with(thisBoot() + "/"); }
  /// Whether this process can look up the process number. A computer that was renamed is still the
  /// same one until it is restarted.
  bool isOnThisComputer() const {
    const auto at = mark().find('@');
    if (at == std::string::npos || !isOfThisBoot()) return station == thisStation();
    return mark().substr(at + 1) == thisNamespace();
  }
};

/// The leases that this process holds. If the row of an ended lease could not be removed, it is
/// still in the table but no longer in this set.
class HeldLeases {
 public:
  std::string make() {
    const std::lock_guard lock(mutex_);
    const std::string token = processMarkOf(getpid()) + "#" + std::to_string(++tokenCount_);
    held_.insert(token);
    return token;
  }
  void release(const std::string& token) {
    const std::lock_guard lock(mutex_);
    held_.erase(token);
  }
  bool isHeld(const std::string& token) {
    const std::lock_guard lock(mutex_);
    return held_.count(token) > 0;
  }

 private:
  std::mutex mutex_;
  std::set<std::string> held_;
  std::uint64_t tokenCount_ = 0;
};

HeldLeases& heldLeases() {
  static HeldLeases all;
  return all;
}

/// Whether the program that wrote a lease's row is still running.
bool isAlive(const Writer& writer) {
  if (!writer.isOnThisComputer()) return true;  // its process cannot be looked up from here
  if (writer.pid == getpid()) return heldLeases().isHeld(writer.token);
  const std::string mark = processMarkOf(writer.pid);
  return mark.substr(0, mark.find('@')) == writer.mark().substr(0, writer.mark().find('@'));
}

/// When a session last stored an event [UTC]. It is shown in place of a heartbeat: a program on
/// another computer can store here only while both use one disk, and network drives are refused
/// (docs/decisions/0063).
std::string lastStored(const Database& database, SessionId session) {
  Statement last(database, "SELECT utc FROM event WHERE session_id = ? ORDER BY seq DESC LIMIT 1");
  last.bindAll(session);
  return last.step() ? last.text(0) : std::string("an unknown day");
}

}  // namespace

Lease::Lease(Database& database, SessionId session, const std::string& utc, From from)
    : database_(&database), session_(session), token_(heldLeases().make()) {
  const auto held = holder(database, session);
  const bool isFree = !held || !held->isAlive;
  if (!isFree && (held->isOnThisComputer || from == From::EndedPrograms)) {
    const std::string orElse =
        held->isOnThisComputer
            ? std::string()
            : fmt::format(
                  " Something was stored there last on {}. If that computer is gone, or "
                  "has another name now, take the session over with a reason: in the "
                  "table of sessions, or by palpate study run FOLDER --take-over \"why\".",
                  lastStored(database, session));
    throw StorageError(
        "This session is open already, on " + held->station + " (process " +
            std::to_string(held->pid) + ", since " + held->since +
            "). Go on there, or close it there first." + orElse,
        StorageError::Kind::Busy);
  }
  Statement take(
      database,
      "INSERT OR REPLACE INTO lease (session_id, station, pid, taken_utc, process) "
      "VALUES (?,?,?,?,?)");
  take.bindAll(session, thisStation(), getpid(), utc, token_);
  take.run();
}

std::optional<Lease::Holder> Lease::holder(const Database& database, SessionId session) {
  Statement held(
      database, "SELECT station, pid, taken_utc, process FROM lease WHERE session_id = ?");
  held.bindAll(session);
  if (!held.step()) return std::nullopt;
  const Writer writer{.station = held.text(0), .pid = held.number(1), .token = held.text(3)};
  return Holder{
      .station = writer.station,
      .pid = writer.pid,
      .since = held.text(2),
      .isAlive = isAlive(writer),
      .isOnThisComputer = writer.isOnThisComputer(),
      .isOfThisBoot = writer.isOfThisBoot()};
}

void Lease::clear(Database& database) {
  database.execute("DELETE FROM lease");
}

void Lease::requireHeld() const {
  Statement held(*database_, "SELECT 1 FROM lease WHERE session_id = ? AND process = ?");
  held.bindAll(session_, token_);
  if (held.step()) return;
  throw StorageError(
      "This session was taken over by another program. Go on there; nothing more is stored here.");
}

Lease::Lease(Lease&& other) noexcept
    : database_(std::exchange(other.database_, nullptr)),
      session_(other.session_),
      token_(std::move(other.token_)) {}

Lease::~Lease() {
  if (database_ == nullptr) return;
  heldLeases().release(token_);  // first, so that isAlive() finds the lease free even if the row
                                 // cannot be removed
  try {
    Statement give(*database_, "DELETE FROM lease WHERE session_id = ? AND process = ?");
    give.bindAll(session_, token_);
    give.run();
  } catch (const StorageError&) {
    // The row stays in the table; the next program that resumes the session replaces it.
  }
}

}  // namespace study::storage
