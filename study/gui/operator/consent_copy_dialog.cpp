#include "study/gui/operator/consent_copy_dialog.h"

#include <filesystem>

#include <QFileDialog>
#include <QFileInfo>

#include "study/gui/widgets/attempt.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/written_file.h"
#include "study/model/new_file.h"
#include "study/report/consent_copy.h"
#include "study/report/marked_text.h"
#include "study/report/pdf_report.h"
#include "study/session/unblinding.h"

namespace study::gui {

bool writeConsentCopy(Study& study, const std::string& participant, const std::string& path) {
  const auto html = report::consentCopy(study, participant, [](const std::string& text) {
    return report::asHtml(QString::fromStdString(text)).toStdString();
  });
  const bool isPdf = std::filesystem::path(path).extension() == ".pdf";
  const auto page = isPdf ? report::asPdf(html, study.protocol().protocol.study.title) : html;
  requireNewFile(path);  // checked first: an entry in the trail cannot be taken back
  const bool isNoted = recordConsentCopy(study, participant);
  writeNewFile(path, page);
  return isNoted;
}

void saveConsentCopy(Study& study, const std::string& participant, QWidget* parent) {
  QString path = QFileDialog::getSaveFileName(
      parent,
      QFileDialog::tr("A copy of what was agreed to"),
      QStringLiteral("consent-%1.pdf").arg(QString::fromStdString(participant)),
      QFileDialog::tr("PDF (*.pdf);;Page (*.html)"),
      nullptr,
      QFileDialog::DontConfirmOverwrite);  // existing files are never overwritten
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".pdf");
  bool isNoted = true;
  const auto write = [&] { isNoted = writeConsentCopy(study, participant, path.toStdString()); };
  if (attempt(parent, MessageTopic::ConsentCopyNotSaved, write)) {
    showWrittenFileMessage(parent, path, isNoted ? QString() : deskText(kCopyNotNoted));
  }
}

}  // namespace study::gui
