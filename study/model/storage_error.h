#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "base/message.h"

namespace study::storage {

/// A study on disk cannot be opened, read or written. what() tells the operator what to do.
class StorageError : public std::runtime_error {
 public:
  enum class Kind {
    Other,
    Busy,  ///< another program is writing
    DiskFull,
    Damaged,  ///< the file is damaged, or is not a study
    Newer,    ///< written by a later version of this program
    Unknown,  ///< whether the data were stored cannot be found out now
  };

  explicit StorageError(const std::string& what, Kind kind = Kind::Other)
      : std::runtime_error(what), kind_(kind) {}

  /// @param message  its first argument is the path of the file that could not be used
  explicit StorageError(base::Message message, Kind kind)
      : std::runtime_error(base::describe(message)), kind_(kind), message_(std::move(message)) {}

  Kind kind() const noexcept { return kind_; }

  /// The text of what() as key and arguments; empty if the error was made from a text only.
  const base::Message& message() const noexcept { return message_; }

 private:
  Kind kind_;
  base::Message message_;
};

}  // namespace study::storage
