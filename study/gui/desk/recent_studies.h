#pragma once

#include <vector>

#include <QDateTime>
#include <QString>

namespace study::gui {

/// A study that was opened on this computer.
struct RecentStudy {
  QString folder;  ///< absolute
  QString title;   ///< when last opened; shown if the folder no longer exists
  QDateTime opened;
};

/// All studies that this user opened, latest first.
std::vector<RecentStudy> recentStudies();

/// Puts a study at the top of the list.
void addRecentStudy(const QString& folder, const QString& title);

/// Removes a study from the list. Its folder is not changed.
void removeRecentStudy(const QString& folder);

/// A report or an export that was written for a study on this computer.
struct WrittenDocument {
  QString study;  ///< folder, absolute
  QString path;
  QDateTime written;
};

/// The documents of a study that still exist, latest first.
std::vector<WrittenDocument> documentsOf(const QString& study);

/// Puts a document at the top of the list, which keeps the latest kMostDocuments documents of all
/// studies together.
void rememberDocument(const QString& study, const QString& path);

inline constexpr int kMostDocuments = 100;

}  // namespace study::gui
