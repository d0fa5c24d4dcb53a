#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "study/storage/event_log.h"
#include "study/storage/statement.h"

namespace study::storage {

/// A queue of events in a temporary file, because the events of a large study do not fit into
/// memory. The owner of this object removes the file.
class EventSpool {
 public:
  /// Creates the file. @throws StorageError
  explicit EventSpool(const std::string& path);

  /// Appends an event.
  void put(const StoredEvent& event);
  std::size_t count() const noexcept { return count_; }
  /// Calls @p take with every event, in order.
  void forEach(const std::function<void(const StoredEvent& event)>& take) const;

 private:
  Database database_;
  std::size_t count_ = 0;
};

}  // namespace study::storage
