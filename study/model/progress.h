#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace study {

/// Called repeatedly during long work. May throw Cancelled: then the work stops and leaves no
/// unfinished files.
/// @param share  part of the work that is done, 0 to 1; kUnknownShare if it cannot be computed
/// @param words  a description of the present task
using Progress = std::function<void(double share, const std::string& words)>;

inline constexpr double kUnknownShare = -1.0;

/// Thrown by a Progress function to stop the work.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("It was cancelled; nothing was left behind.") {}
};

/// Calls @p progress if there is one.
inline void announceProgress(const Progress& progress, double share, const std::string& words) {
  if (progress) progress(share, words);
}

}  // namespace study
