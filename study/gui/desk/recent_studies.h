#pragma once

#include <vector>

#include <QDateTime>
#include <QString>

namespace study::gui {

/// A study that was opened on this computer.
struct RecentStudy {
  QString folder;  ///< absolute
  QString title;   ///< as it was when it was opened last; told where the folder is gone
  QDateTime opened;
};

/// Those that this person opened, the last one first; at most kMostRecent.
std::vector<RecentStudy> recentStudies();

/// Puts a study first.
void rememberStudy(const QString& folder, const QString& title);

/// Takes a study off the list; its folder stays as it is.
void forgetStudy(const QString& folder);

inline constexpr int kMostRecent = 20;

}  // namespace study::gui
