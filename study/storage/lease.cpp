#include "study/storage/lease.h"

#include <unistd.h>

#include <array>
#include <fstream>
#include <sstream>
#include <utility>

#include "study/storage/statement.h"
#include "study/storage/transaction.h"

namespace study::storage {
namespace {

std::string thisStation() {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  return name.data();
}

/// What tells a process from a later one with the same number: when it began, and after which boot.
/// Empty where there is no such process.
std::string marksOf(std::int64_t pid) {
  std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
  std::string line;
  if (!std::getline(stat, line)) return {};
  std::istringstream fields(line.substr(line.rfind(')') + 1));  // the name before may hold anything
  std::string began;
  constexpr int kBegan = 20;  // the 22nd field in all
  for (int i = 0; i < kBegan; ++i) fields >> began;
  std::string boot;
  std::ifstream("/proc/sys/kernel/random/boot_id") >> boot;
  return boot + "/" + began;
}

}  // namespace

Lease::Lease(Database& database, SessionId session, const std::string& utc)
    : database_(&database), session_(session) {
  Transaction transaction(database);
  Statement held(
      database, "SELECT station, pid, taken_utc, process FROM lease WHERE session_id = ?");
  held.bind(1, static_cast<std::int64_t>(session));
  if (held.step()) {
    const bool isElsewhere = held.text(0) != thisStation();
    if (isElsewhere || marksOf(held.number(1)) == held.text(3)) {
      throw StorageError(
          "This session is open already, on " + held.text(0) + " (process " +
              std::to_string(held.number(1)) + ", since " + held.text(2) +
              "). Go on there, or close it there first.",
          StorageError::Kind::Busy);
    }
  }
  Statement take(
      database,
      "INSERT OR REPLACE INTO lease (session_id, station, pid, taken_utc, process) "
      "VALUES (?,?,?,?,?)");
  take.bind(1, static_cast<std::int64_t>(session))
      .bind(2, thisStation())
      .bind(3, std::int64_t{getpid()})
      .bind(4, utc)
      .bind(5, marksOf(getpid()));
  take.run();
  transaction.commit();
}

Lease::Lease(Lease&& other) noexcept
    : database_(std::exchange(other.database_, nullptr)), session_(other.session_) {}

Lease::~Lease() {
  if (database_ == nullptr) return;
  try {
    Statement give(*database_, "DELETE FROM lease WHERE session_id = ?");
    give.bind(1, static_cast<std::int64_t>(session_));
    give.run();
  } catch (const StorageError&) {
    // It stays behind, and is taken over when this process is gone.
  }
}

}  // namespace study::storage
