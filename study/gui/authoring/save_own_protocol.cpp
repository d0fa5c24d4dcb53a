#include "study/gui/authoring/save_own_protocol.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QRegularExpression>
#include <QSaveFile>

#include "protocols/reading/protocol_file.h"
#include "questionnaires/json/document.h"
#include "study/gui/widgets/attempt.h"
#include "study/gui/widgets/message_box.h"
#include "study/gui/widgets/studio_settings.h"
#include "study/model/user_error.h"

namespace study::gui {
namespace {

constexpr qsizetype kLongestId = 64;  // [characters], of isValidId()

/// @p words as an id: "Our punch, 2nd try" → "our-punch-2nd-try".
QString asId(const QString& words) {
  static const QRegularExpression kOthers(QStringLiteral("[^a-z0-9._]+"));
  static const QRegularExpression kEnds(QStringLiteral("^[-._]+|-+$"));
  const auto id = words.toLower().replace(kOthers, QStringLiteral("-")).left(kLongestId);
  return QString(id).remove(kEnds);
}

}  // namespace

void writeProtocol(const QString& file, const std::string& text) {
  QSaveFile saved(file);  // replaces the file at once, or leaves it as it is
  const auto bytes = QByteArray::fromStdString(text);
  if (!saved.open(QIODevice::WriteOnly) || saved.write(bytes) != bytes.size() || !saved.commit()) {
    throw UserError(QObject::tr("Could not save %1: %2. Choose another folder or name.")
                        .arg(file, saved.errorString())
                        .toStdString());
  }
}

QString saveAsOwn(const protocols::LoadedProtocol& shipped, QWidget* parent) {
  auto title = QString::fromStdString(shipped.protocol.study.title);
  for (;;) {  // after a failure with the title that was typed
    const auto typed = askForText(parent, MessageTopic::OwnTitle, {}, title);
    if (!typed) return {};
    title = typed->trimmed();
    const auto name = asId(title).isEmpty() ? QStringLiteral("my-protocol") : asId(title);
    auto file = QFileDialog::getSaveFileName(
        parent,
        QObject::tr("Save as a protocol of your own"),
        QDir(protocolFolder()).filePath(name + QStringLiteral(".json")),
        QObject::tr("Protocols (*.json)"));
    if (file.isEmpty()) return {};
    if (QFileInfo(file).suffix().isEmpty()) file += QStringLiteral(".json");
    const auto id = asId(QFileInfo(file).completeBaseName());
    const bool isSaved = attempt(parent, MessageTopic::OwnProtocolNotSaved, [&] {
      writeProtocol(
          file,
          protocols::withName(
              shipped.text, (id.isEmpty() ? name : id).toStdString(), title.toStdString()));
    });
    if (!isSaved) continue;
    rememberProtocolFolder(file);
    return file;
  }
}

}  // namespace study::gui
