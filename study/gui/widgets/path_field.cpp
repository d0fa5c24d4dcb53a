#include "study/gui/widgets/path_field.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPainter>
#include <QPushButton>
#include <QStandardPaths>
#include <QStyleOptionFrame>

namespace study::gui {
namespace {

/// A line edit that leaves out the middle of a long path as long as it is not edited: the disk and
/// the file's name are seen.
class PathLine final : public QLineEdit {
 public:
  using QLineEdit::QLineEdit;

 protected:
  void paintEvent(QPaintEvent* event) override {
    QStyleOptionFrame option;
    initStyleOption(&option);
    constexpr int kPadding = 2;  // [px], as in Qt's own
    const QRect room = style()
                           ->subElementRect(QStyle::SE_LineEditContents, &option, this)
                           .adjusted(kPadding, 0, -kPadding, 0);
    const bool isShort = fontMetrics().horizontalAdvance(text()) <= room.width();
    if (hasFocus() || isShort) return QLineEdit::paintEvent(event);
    QPainter painter(this);
    style()->drawPrimitive(QStyle::PE_PanelLineEdit, &option, &painter, this);
    painter.setPen(
        palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::Text));
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter, elided(room.width()));
  }

 private:
  /// The folder loses its middle, and the file's name is whole as long as there is room for it.
  QString elided(int width) const {
    const auto name = text().mid(text().lastIndexOf(QLatin1Char('/')));
    const int left = width - fontMetrics().horizontalAdvance(name);
    const auto folder = text().chopped(name.size());
    if (left < fontMetrics().horizontalAdvance(QStringLiteral("/…/…")))
      return fontMetrics().elidedText(text(), Qt::ElideMiddle, width);
    return fontMetrics().elidedText(folder, Qt::ElideMiddle, left) + name;
  }
};

}  // namespace

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
      line_(new PathLine(this)) {
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
