#include "study/gui/widgets/path_field.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPushButton>
#include <QStandardPaths>

namespace study::gui {

QString unusedPath(const QString& start, const QString& extension) {
  QString path = start + extension;
  for (int number = 2; QFileInfo::exists(path); ++number) {
    path = QStringLiteral("%1-%2%3").arg(start).arg(number).arg(extension);
  }
  return path;
}

QString documentsFolder() {
  const auto documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  return QFileInfo(documents).isDir() ? documents : QDir::homePath();
}

PathField::PathField(Kind kind, const QString& name, const QString& filter, QWidget* parent)
    : QWidget(parent),
      kind_(kind),
      name_(name),
      filter_(filter),
      start_(documentsFolder()),
      line_(new QLineEdit(this)) {
  auto* choose = new QPushButton(tr("Choose…"), this);
  choose->setAccessibleName(tr("Choose: %1").arg(name));
  choose->setProperty("role", QStringLiteral("tool"));
  line_->setAccessibleName(name);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(line_, 1);
  row->addWidget(choose);
  // A form layout gives a row less height than its button needs without a minimum.
  choose->ensurePolished();
  setMinimumHeight(choose->sizeHint().height());
  setFocusProxy(line_);
  connect(choose, &QPushButton::clicked, this, &PathField::choose);
  connect(line_, &QLineEdit::textChanged, this, [this] {
    line_->setToolTip(path());  // a long one is not seen whole
    emit pathChanged(path());
  });
}

void PathField::choose() {
  const QString before = path().isEmpty() ? start_ : path();
  QString chosen;
  switch (kind_) {
    case Kind::ExistingFile:
      chosen = QFileDialog::getOpenFileName(this, name_, before, filter_);
      break;
    case Kind::ExistingFolder:
      chosen = QFileDialog::getExistingDirectory(this, name_, before);
      break;
    case Kind::NewFile:
    case Kind::NewFolder:
      // No confirmation: the work refuses to overwrite a file and says so.
      chosen = QFileDialog::getSaveFileName(
          this, name_, before, filter_, nullptr, QFileDialog::DontConfirmOverwrite);
      break;
  }
  if (!chosen.isEmpty()) setPath(chosen);
}

}  // namespace study::gui
