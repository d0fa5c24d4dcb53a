#include "study/gui/desk/recent_studies.h"

#include <algorithm>

#include <QDir>
#include <QFileInfo>

#include "study/gui/widgets/studio_settings.h"

namespace study::gui {
namespace {

constexpr const char* kRecentKey = "recent-studies";
constexpr const char* kDocumentsKey = "written-documents";

void store(const std::vector<RecentStudy>& studies) {
  auto settings = studioSettings();
  settings.remove(QLatin1String(kRecentKey));
  settings.beginWriteArray(QLatin1String(kRecentKey));
  for (int i = 0; i < static_cast<int>(studies.size()); ++i) {
    const auto& study = studies[static_cast<std::size_t>(i)];
    settings.setArrayIndex(i);
    settings.setValue(QStringLiteral("folder"), study.folder);
    settings.setValue(QStringLiteral("title"), study.title);
    settings.setValue(QStringLiteral("opened"), study.opened);
  }
  settings.endArray();
}

QString plainFolder(const QString& folder) {
  return QDir::cleanPath(QDir(folder).absolutePath());
}

std::vector<WrittenDocument> allDocuments() {
  auto settings = studioSettings();
  std::vector<WrittenDocument> documents;
  const int count = settings.beginReadArray(QLatin1String(kDocumentsKey));
  for (int i = 0; i < std::min(count, kMostDocuments); ++i) {
    settings.setArrayIndex(i);
    documents.push_back(
        {.study = settings.value(QStringLiteral("study")).toString(),
         .path = settings.value(QStringLiteral("path")).toString(),
         .written = settings.value(QStringLiteral("written")).toDateTime()});
  }
  settings.endArray();
  return documents;
}

std::vector<RecentStudy> recentStudiesExcept(const QString& folder) {
  auto studies = recentStudies();
  std::erase_if(studies, [&](const RecentStudy& study) { return study.folder == folder; });
  return studies;
}

}  // namespace

std::vector<RecentStudy> recentStudies() {
  auto settings = studioSettings();
  std::vector<RecentStudy> studies;
  const int count = settings.beginReadArray(QLatin1String(kRecentKey));
  for (int i = 0; i < count; ++i) {
    settings.setArrayIndex(i);
    studies.push_back(
        {.folder = settings.value(QStringLiteral("folder")).toString(),
         .title = settings.value(QStringLiteral("title")).toString(),
         .opened = settings.value(QStringLiteral("opened")).toDateTime()});
  }
  settings.endArray();
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
  auto settings = studioSettings();
  settings.remove(QLatin1String(kDocumentsKey));
  settings.beginWriteArray(QLatin1String(kDocumentsKey));
  for (int i = 0; i < static_cast<int>(documents.size()); ++i) {
    const auto& document = documents[static_cast<std::size_t>(i)];
    settings.setArrayIndex(i);
    settings.setValue(QStringLiteral("study"), document.study);
    settings.setValue(QStringLiteral("path"), document.path);
    settings.setValue(QStringLiteral("written"), document.written);
  }
  settings.endArray();
}

}  // namespace study::gui
