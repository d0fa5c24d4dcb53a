#pragma once

#include <map>
#include <utility>

#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QStringList>
#include <QTimer>

namespace study::gui {

/// Tells when one of some files has changed, also where an editor puts a new file in its place.
class FileWatch final : public QObject {
  Q_OBJECT

 public:
  explicit FileWatch(QObject* parent = nullptr);

  /// Watches these, and no others any more. One that is not there is watched for.
  void watch(const QStringList& files);

 signals:
  /// Once for changes that follow each other at once.
  void changed();

 private:
  using State = std::pair<qint64, QDateTime>;  ///< size, last written
  std::map<QString, State> look() const;
  void lookAgain();
  void watchAll();

  QStringList files_;
  std::map<QString, State> before_;
  QFileSystemWatcher watcher_;
  QTimer settled_;
};

}  // namespace study::gui
