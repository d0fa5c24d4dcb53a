#include "study/storage/transfer/event_spool.h"

#include <array>
#include <string_view>

#include <fmt/format.h>

namespace study::storage {
namespace {

constexpr std::int32_t kApplicationId = 0x50414c53;  // "PALS"

// The columns of study.db without its constraints, because sequence numbers repeat.
constexpr std::array<std::string_view, 1> kSteps{R"sql(
  CREATE TABLE event (
    place INTEGER PRIMARY KEY, seq INTEGER, session_id INTEGER, step INTEGER, attempt INTEGER, utc TEXT,
    monotonic_ns INTEGER, actor TEXT, kind TEXT, detail TEXT, hash BLOB, content_hash BLOB, sealed BLOB) STRICT;
)sql"};

}  // namespace

EventSpool::EventSpool(const std::string& path)
    : database_(Database::create(
          path, {.applicationId = kApplicationId, .name = "a list of events", .steps = kSteps})) {
  database_.execute("BEGIN");  // never committed, so that no write waits for the disk
}

void EventSpool::put(const StoredEvent& event) {
  insertEvent(database_, event);
  ++count_;
}

void EventSpool::forEach(const std::function<void(const StoredEvent& event)>& take) const {
  Statement select(database_, fmt::format("SELECT {} FROM event ORDER BY place", kEventColumns));
  while (select.step()) take(storedEventIn(select));
}

}  // namespace study::storage
