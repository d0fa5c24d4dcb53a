#include "study/gui/widgets/written_file.h"

#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPushButton>
#include <QUrl>

#include "study/gui/widgets/message_box.h"

namespace study::gui {

QString shownPath(const QString& path) {
  const QString home = QDir::homePath() + QLatin1Char('/');
  return path.startsWith(home) ? QStringLiteral("~/") + path.mid(home.size()) : path;
}

void openOnDesktop(const QString& path, QWidget* parent) {
  if (QDesktopServices::openUrl(QUrl::fromLocalFile(path))) return;
  auto* box = new MessageBox(MessageTopic::FileNotOpened, {shownPath(path)}, {}, parent);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

void showWrittenFileMessage(QWidget* parent, const QString& path, const QString& more) {
  auto* box = new MessageBox(MessageTopic::FileSaved, {shownPath(path)}, more, parent);
  box->setAttribute(Qt::WA_DeleteOnClose);
  auto* written = new WrittenFile(box);
  written->show(path);
  box->add(*written);
  box->open();
}

WrittenFile::WrittenFile(QWidget* parent) : QWidget(parent) {
  auto* open = new QPushButton(tr("Open"), this);
  auto* folder = new QPushButton(tr("Show in folder"), this);
  for (auto* button : {open, folder}) {
    button->setAutoDefault(false);
    button->setProperty("role", QStringLiteral("tool"));
  }
  setProperty("role", QStringLiteral("plain"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(open);
  layout->addWidget(folder);
  layout->addStretch(1);
  connect(open, &QPushButton::clicked, this, [this] { openOnDesktop(path_, this); });
  connect(folder, &QPushButton::clicked, this, [this] {
    openOnDesktop(QFileInfo(path_).absolutePath(), this);
  });
  show(QString());
}

void WrittenFile::show(const QString& path) {
  path_ = path;
  setVisible(!path.isEmpty());
}

}  // namespace study::gui
