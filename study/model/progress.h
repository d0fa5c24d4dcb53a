#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace study {

/// Told now and then how far a long piece of work is, and in a few words what is being done. May
/// throw Cancelled: then the work ends there, and leaves nothing half done behind.
/// @param share  of the whole, 0 to 1; kUnknownShare where nobody can say.
using Progress = std::function<void(double share, const std::string& words)>;

inline constexpr double kUnknownShare = -1.0;

/// Somebody did not want to wait any longer.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("It was cancelled; nothing was left behind.") {}
};

/// Tells whoever wants to know.
inline void tell(const Progress& progress, double share, const std::string& words) {
  if (progress) progress(share, words);
}

}  // namespace study
