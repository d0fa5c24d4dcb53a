#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "base/message.h"

namespace study::storage {

/// A study on disk that cannot be opened, read or written; what() is for the person at the desk.
class StorageError : public std::runtime_error {
 public:
  enum class Kind {
    Other,
    Busy,  ///< somebody else is writing
    DiskFull,
    Damaged,  ///< or never was a study
    Newer,    ///< written by a later version of this program
    Unknown,  ///< whether it was kept cannot be found out just now
  };

  explicit StorageError(const std::string& what, Kind kind = Kind::Other)
      : std::runtime_error(what), kind_(kind) {}

  /// About a file, whose path is the first argument of @p message.
  explicit StorageError(base::Message message, Kind kind)
      : std::runtime_error(base::describe(message)), kind_(kind), message_(std::move(message)) {}

  Kind kind() const noexcept { return kind_; }

  /// The same as a value; nothing where there are only words.
  const base::Message& message() const noexcept { return message_; }

 private:
  Kind kind_;
  base::Message message_;
};

}  // namespace study::storage
