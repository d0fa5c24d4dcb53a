#include "study/session/arrivals.h"

#include <exception>
#include <sstream>

#include "base/search.h"
#include "study/storage/station_store.h"
#include "study/storage/transfer/session_facts.h"

namespace study {
namespace {

std::string listOf(const std::string& study) {
  return "collected-" + study;
}

std::string listOfReceipts(const std::string& study, const std::string& station) {
  return "receipts-" + study + "-" + station;
}

}  // namespace

Arrivals arrivalsBy(Study& study, std::int64_t event) {
  const auto marks = storage::lastSessionEvents(study.database());
  Arrivals arrivals{
      .all = static_cast<std::int64_t>(marks.size()), .arrived = 0, .waitingSince = {}};
  for (const auto& mark : marks) {
    if (mark.lastEvent <= event) {
      ++arrivals.arrived;
    } else if (mark.isSimulated) {
      continue;
    } else if (arrivals.waitingSince.empty() || mark.utc < arrivals.waitingSince) {
      arrivals.waitingSince = mark.utc;
    }
  }
  return arrivals;
}

PushRecord lastPush(const std::string& study, const std::string& station) {
  const auto store = storage::StationStore::find(storage::StationStore::defaultFolder());
  PushRecord last;
  if (!store) return last;
  for (const auto& line : store->lines(listOf(study))) {
    std::istringstream words(line);
    PushRecord noted;
    std::string of;
    if (!(words >> noted.utc >> of >> noted.lastEvent) || of != station) continue;
    words >> noted.problem;
    last = noted;
  }
  return last;
}

void recordPush(
    const std::string& study, const std::string& station, const PushRecord& push) noexcept {
  try {
    auto line = push.utc + " " + station + " " + std::to_string(push.lastEvent);
    if (!push.problem.empty()) line += " " + push.problem;
    storage::StationStore::openOrCreate(storage::StationStore::defaultFolder())
        .append(listOf(study), line);
  } catch (const std::exception&) {
    return;
  }
}

void recordErasureReceipt(
    const std::string& study, const std::string& station, const ErasureReceipt& receipt) noexcept {
  try {
    const auto store = storage::StationStore::openOrCreate(storage::StationStore::defaultFolder());
    const auto list = listOfReceipts(study, station);
    const auto line = receipt.utc + " " + std::to_string(receipt.session) + " " +
                      std::to_string(receipt.left) + " " + receipt.participant;
    const auto noted = store.lines(list);
    if (!base::contains(noted, line)) store.append(list, line);
  } catch (const std::exception&) {
    return;
  }
}

std::vector<ErasureReceipt> receiptsOf(const std::string& study, const std::string& station) {
  std::vector<ErasureReceipt> receipts;
  const auto store = storage::StationStore::find(storage::StationStore::defaultFolder());
  if (!store) return receipts;
  for (const auto& line : store->lines(listOfReceipts(study, station))) {
    std::istringstream words(line);
    ErasureReceipt receipt;
    if (!(words >> receipt.utc >> receipt.session >> receipt.left >> std::ws)) continue;
    std::getline(words, receipt.participant);
    // A server that was restored erases a session again.
    std::erase_if(receipts, [&](const ErasureReceipt& earlier) {
      return earlier.session == receipt.session && earlier.participant == receipt.participant;
    });
    receipts.push_back(std::move(receipt));
  }
  return receipts;
}

}  // namespace study
