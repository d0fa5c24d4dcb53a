#pragma once

#include <functional>
#include <optional>
#include <string>

#include <QObject>
#include <QTimer>

#include "study/session/arrivals.h"

namespace study::gui {

/// Sends what is new from a station to its server: after each session, on request, and again every
/// few minutes while something waits. The windows have no connection to a server: a process of its
/// own with the lowest priority sends and notes what became of it, and nothing waits for it.
class StationPush final : public QObject {
  Q_OBJECT

 public:
  static constexpr int kRetryEvery = 5 * 60 * 1000;  ///< [ms]

  /// The study must outlive this.
  /// @param isBusy  whether a trial runs, which nothing may disturb: a retry then waits for the
  /// next turn.
  StationPush(
      Study& study,
      std::function<bool()> isBusy,
      int retryEvery = kRetryEvery,
      QObject* parent = nullptr);

  /// Whether the study is a station's and the program that sends is installed.
  bool isPossible() const;
  /// Begins to send, unless that is being done already.
  void send();
  bool isSending() const { return watching_.isActive(); }

  /// What has arrived, as last noted; empty for a study of one computer.
  std::string inWords() const;
  /// Whether something has been waiting for more than a day.
  bool isOverdue() const;

 signals:
  /// Sending has begun or ended.
  void changed();

 private:
  bool isWaiting() const;
  void look();

  Study& study_;
  std::function<bool()> isBusy_;
  QTimer retry_;
  QTimer watching_;    ///< for the note that a push leaves when it ends
  NotedPush before_;   ///< the note of the push before
  int looksLeft_ = 0;  ///< until a push that leaves no note counts as ended
};

/// "23 sessions here, 21 arrived, 2 waiting since Tuesday: no network, or no server"; empty if
/// there are no sessions.
std::string arrivalsInWords(const Arrivals& arrivals, const std::string& problem);

/// Whether something has been waiting for more than a day.
bool isOverdue(const Arrivals& arrivals);

}  // namespace study::gui
