#include "study/gui/widgets/written_file.h"

#include <QDesktopServices>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPushButton>
#include <QUrl>

namespace study::gui {

void openOnDesktop(const QString& path) {
  QDesktopServices::openUrl(QUrl::fromLocalFile(path));
}

WrittenFile::WrittenFile(QWidget* parent) : QWidget(parent) {
  auto* open = new QPushButton(tr("Open"), this);
  auto* folder = new QPushButton(tr("Show in folder"), this);
  open->setObjectName(QStringLiteral("open-written"));
  folder->setObjectName(QStringLiteral("show-in-folder"));
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
  connect(open, &QPushButton::clicked, this, [this] { openOnDesktop(path_); });
  connect(folder, &QPushButton::clicked, this, [this] {
    openOnDesktop(QFileInfo(path_).absolutePath());
  });
  show(QString());
}

void WrittenFile::show(const QString& path) {
  path_ = path;
  setVisible(!path.isEmpty());
}

}  // namespace study::gui
