#include "study/gui/desk/recent_studies.h"

#include <algorithm>

#include <QDir>
#include <QFileInfo>

#include "study/gui/widgets/studio_settings.h"

namespace study::gui {
namespace {

constexpr const char* kRecentKey = "recent-studies";
constexpr const char* kDocumentsKey = "written-documents";

/// Calls @p read for each entry of a list in the settings, with the settings at that entry.
template <class Read>
void readList(const char* key, Read read) {
  auto settings = studioSettings();
  const int count = settings.beginReadArray(QLatin1String(key));
  for (int i = 0; i < count; ++i) {
    settings.setArrayIndex(i);
    read(settings);
  }
  settings.endArray();
}

/// Replaces a list in the settings; @p write writes one entry.
template <class Entry, class Write>
void writeList(const char* key, const std::vector<Entry>& entries, Write write) {
  auto settings = studioSettings();
  settings.remove(QLatin1String(key));
  settings.beginWriteArray(QLatin1String(key));
  for (int i = 0; const auto& entry : entries) {
    settings.setArrayIndex(i++);
    write(settings, entry);
  }
  settings.endArray();
}

void store(const std::vector<RecentStudy>& studies) {
  writeList(kRecentKey, studies, [](QSettings& settings, const RecentStudy& study) {
    settings.setValue(QStringLiteral("folder"), study.folder);
    settings.setValue(QStringLiteral("title"), study.title);
    settings.setValue(QStringLiteral("opened"), study.opened);
  });
}

QString plainFolder(const QString& folder) {
  return QDir::cleanPath(QDir(folder).absolutePath());
}

std::vector<WrittenDocument> allDocuments() {
  std::vector<WrittenDocument> documents;
  readList(kDocumentsKey, [&](const QSettings& settings) {
    documents.push_back(
        {.study = settings.value(QStringLiteral("study")).toString(),
         .path = settings.value(QStringLiteral("path")).toString(),
         .written = settings.value(QStringLiteral("written")).toDateTime()});
  });
  return documents;
}

std::vector<RecentStudy> recentStudiesExcept(const QString& folder) {
  auto studies = recentStudies();
  std::erase_if(studies, [&](const RecentStudy& study) { return study.folder == folder; });
  return studies;
}

}  // namespace

std::vector<RecentStudy> recentStudies() {
  std::vector<RecentStudy> studies;
  readList(kRecentKey, [&](const QSettings& settings) {
    studies.push_back(
        {.folder = settings.value(QStringLiteral("folder")).toString(),
         .title = settings.value(QStringLiteral("title")).toString(),
         .opened = settings.value(QStringLiteral("opened")).toDateTime()});
  });
  return studies;
}

void addRecentStudy(const QString& folder, const QString& title) {
  const QString plain = plainFolder(folder);
  auto studies = recentStudiesExcept(plain);
  studies.insert(
      studies.begin(),
      {.folder = plain, .title = title, .opened = QDateTime::currentDateTimeUtc()});
  store(studies);
}

void removeRecentStudy(const QString& folder) {
  store(recentStudiesExcept(plainFolder(folder)));
}

std::vector<WrittenDocument> documentsOf(const QString& study) {
  auto documents = allDocuments();
  std::erase_if(documents, [folder = plainFolder(study)](const WrittenDocument& document) {
    return document.study != folder || !QFileInfo::exists(document.path);
  });
  return documents;
}

void rememberDocument(const QString& study, const QString& path) {
  auto documents = allDocuments();
  const QString plain = QFileInfo(path).absoluteFilePath();
  std::erase_if(documents, [&](const WrittenDocument& document) { return document.path == plain; });
  documents.insert(
      documents.begin(),
      {.study = plainFolder(study), .path = plain, .written = QDateTime::currentDateTimeUtc()});
  if (documents.size() > kMostDocuments) documents.resize(kMostDocuments);
  writeList(kDocumentsKey, documents, [](QSettings& settings, const WrittenDocument& document) {
    settings.setValue(QStringLiteral("study"), document.study);
    settings.setValue(QStringLiteral("path"), document.path);
    settings.setValue(QStringLiteral("written"), document.written);
  });
}

}  // namespace study::gui
