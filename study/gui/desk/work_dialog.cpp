#include "study/gui/desk/work_dialog.h"

#include <QHBoxLayout>

#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/written_file.h"

namespace study::gui {

WorkDialog::WorkDialog(
    const QString& title, const QString& what, const QString& verb, QWidget* parent)
    : QDialog(parent),
      form_(new QFormLayout),
      line_(bodyLabel({}, this)),
      written_(new WrittenFile(this)),
      more_(new QTextBrowser(this)),
      go_(new QPushButton(verb, this)) {
  setWindowTitle(title);
  setMinimumWidth(760);
  auto* heading = bodyLabel(title, this);
  heading->setProperty("role", QStringLiteral("heading"));
  go_->setProperty("role", QStringLiteral("main"));
  go_->setObjectName(QStringLiteral("go"));
  go_->setDefault(true);
  line_->setObjectName(QStringLiteral("outcome"));
  more_->setObjectName(QStringLiteral("more"));
  more_->setMinimumHeight(200);
  auto* close = new QPushButton(tr("Close"), this);
  close->setAutoDefault(false);
  form_->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  form_->setVerticalSpacing(12);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch(1);
  buttons->addWidget(close);
  buttons->addWidget(go_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(24, 20, 24, 20);
  layout->setSpacing(14);
  layout->addWidget(heading);
  layout->addWidget(quietLabel(what, this));
  layout->addLayout(form_);
  layout->addWidget(line_);
  layout->addWidget(written_);
  layout->addWidget(more_, 1);
  layout->addLayout(buttons);
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  connect(go_, &QPushButton::clicked, this, [this] { work(); });
  clear();
}

void WorkDialog::showOutcome(Outcome outcome, const QString& line, const QString& more) {
  static constexpr const char* kRoles[]{"good", "warn", "bad"};
  static constexpr const char* kSigns[]{"✓  ", "!  ", "✕  "};
  const auto place = static_cast<std::size_t>(outcome);
  setRole(*line_, kRoles[place]);
  line_->setText(QString::fromUtf8(kSigns[place]) + line);
  line_->setVisible(true);
  written_->show(QString());
  showDetails(more);
}

void WorkDialog::showWritten(const QString& path, const QString& line, const QString& more) {
  showOutcome(Outcome::Good, line, more);
  written_->show(path);
  fit();
}

void WorkDialog::showDetails(const QString& more) {
  more_->setPlainText(more);
  more_->setVisible(!more.isEmpty());
  fit();
}

void WorkDialog::fit() {
  layout()->activate();
  const int needed = layout()->totalHeightForWidth(width());
  setMinimumHeight(needed);
  if (!isVisible() || more_->isHidden()) resize(width(), needed);
}

void WorkDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  fit();  // sizes depend on the theme, which applies only from here on
}

void WorkDialog::clear() {
  line_->clear();
  line_->setVisible(false);
  written_->show(QString());
  showDetails(QString());
}

}  // namespace study::gui
