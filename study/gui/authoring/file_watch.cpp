#include "study/gui/authoring/file_watch.h"

#include <QDir>
#include <QFileInfo>

namespace study::gui {
namespace {

constexpr int kSettleTime = 150;  // [ms]: editors write a file in several steps

}  // namespace

FileWatch::FileWatch(QObject* parent) : QObject(parent) {
  settleTimer_.setSingleShot(true);
  settleTimer_.setInterval(kSettleTime);
  const auto wait = [this] { settleTimer_.start(); };
  connect(&watcher_, &QFileSystemWatcher::fileChanged, this, wait);
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, wait);
  connect(&settleTimer_, &QTimer::timeout, this, &FileWatch::checkForChanges);
}

void FileWatch::watch(const QStringList& files) {
  const QStringList old = watcher_.files() + watcher_.directories();
  if (!old.isEmpty()) watcher_.removePaths(old);
  files_ = files;
  lastStates_ = currentStates();
  watchAll();
}

void FileWatch::watchAll() {
  for (const auto& file : files_) {
    const QFileInfo info(file);
    if (info.exists()) watcher_.addPath(file);
    if (info.dir().exists()) watcher_.addPath(info.absolutePath());
  }
}

std::map<QString, FileWatch::State> FileWatch::currentStates() const {
  std::map<QString, State> now;
  for (const auto& file : files_) {
    const QFileInfo info(file);
    now[file] = {info.exists() ? info.size() : -1, info.lastModified()};
  }
  return now;
}

void FileWatch::checkForChanges() {
  watchAll();  // a replaced file has to be added again
  const auto now = currentStates();
  if (now == lastStates_) return;
  lastStates_ = now;
  emit changed();
}

}  // namespace study::gui
