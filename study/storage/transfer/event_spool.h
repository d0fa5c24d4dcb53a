#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "study/storage/event_log.h"
#include "study/storage/statement.h"

namespace study::storage {

/// Events that wait in a file of their own, in the order in which they came: those of a large study
/// do not fit into memory. The file is of no use to anything else, and its owner removes it.
class EventSpool {
 public:
  /// Makes the file. @throws StorageError
  explicit EventSpool(const std::string& path);

  void put(const StoredEvent& event);
  std::size_t count() const noexcept { return count_; }
  void forEach(const std::function<void(const StoredEvent& event)>& take) const;

 private:
  Database database_;
  Statement insert_;
  std::size_t count_ = 0;
};

}  // namespace study::storage
