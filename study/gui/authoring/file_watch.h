#pragma once

#include <map>
#include <utility>

#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QStringList>
#include <QTimer>

namespace study::gui {

/// Emits a signal when one of several files changes or is replaced, as some editors do.
class FileWatch final : public QObject {
  Q_OBJECT

 public:
  explicit FileWatch(QObject* parent = nullptr);

  /// Watches these files and no others. A file that does not exist yet may appear later.
  void watch(const QStringList& files);

 signals:
  /// Emitted once for changes in quick succession.
  void changed();

 private:
  using State = std::pair<qint64, QDateTime>;  ///< size [bytes], last written
  std::map<QString, State> currentStates() const;
  void checkForChanges();
  void watchAll();

  QStringList files_;
  std::map<QString, State> lastStates_;
  QFileSystemWatcher watcher_;
  QTimer settleTimer_;
};

}  // namespace study::gui
