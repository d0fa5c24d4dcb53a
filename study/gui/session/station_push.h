#pragma once

#include <functional>
#include <optional>
#include <string>

#include <QObject>
#include <QTimer>

#include "study/session/arrivals.h"

namespace study::gui {

/// Sends new data from a station to its server: after each session, on request, and again every few
/// minutes while data are waiting. The windows have no connection to a server: a separate process
/// with the lowest priority sends the data and stores a note of the result. This class reads the
/// note and never blocks.
class StationPush final : public QObject {
  Q_OBJECT

 public:
  static constexpr int kRetryInterval = 5 * 60 * 1000;  ///< [ms]

  /// The study must outlive this object.
  /// @param isBusy  returns whether a trial is running; a retry is then postponed by another
  /// period.
  StationPush(
      Study& study,
      std::function<bool()> isBusy,
      int retryInterval = kRetryInterval,
      QObject* parent = nullptr);

  /// Whether the study belongs to a station and the program that sends is installed.
  bool isPossible() const;
  /// Begins to send, unless a push is running already.
  void send();
  bool isSending() const { return watching_.isActive(); }

  /// A sentence on what has arrived at the server, as the last push noted it; empty for a study of
  /// one computer.
  std::string inWords() const;
  /// Whether something has been waiting for more than a day.
  bool isOverdue() const;

 signals:
  /// Sending has begun or ended.
  void changed();

 private:
  bool isWaiting() const;
  void poll();

  Study& study_;
  std::function<bool()> isBusy_;
  QTimer retry_;
  QTimer watching_;    ///< looks for the note that a push stores when it ends
  PushRecord before_;  ///< the note of the previous push
  int pollsLeft_ = 0;  ///< number of polls until a push without a note counts as ended
};

/// "Sessions here: 23. Arrived: 21. Waiting since Tuesday: 2 (no network, or no server)"; empty if
/// there are no sessions.
std::string arrivalsInWords(const Arrivals& arrivals, const std::string& problem);

/// Whether something has been waiting for more than a day.
bool isOverdue(const Arrivals& arrivals);

}  // namespace study::gui
