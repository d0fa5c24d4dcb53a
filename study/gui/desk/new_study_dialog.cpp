#include "study/gui/desk/new_study_dialog.h"

#include <cstdint>
#include <optional>

#include <QDir>
#include <QHBoxLayout>
#include <QRegularExpressionValidator>

#include "protocols/load_protocol.h"
#include "study/gui/authoring/preview_window.h"
#include "study/gui/authoring/texts_dialog.h"
#include "study/gui/widgets/attempt.h"
#include "study/gui/widgets/studio_settings.h"
#include "study/session/study.h"

namespace study::gui {

NewStudyDialog::NewStudyDialog(QWidget* parent)
    : WorkDialog(
          tr("New study"),
          tr("A study is a folder that holds its protocol, its answers and what was felt. Once a "
             "participant has begun, a change makes a new version of the protocol."),
          tr("Create study"),
          parent),
      protocol_(new QComboBox(this)),
      file_(new PathField(
          PathField::Kind::ExistingFile, tr("Protocol file"), tr("Protocols (*.json)"), this)),
      folder_(new PathField(PathField::Kind::NewFolder, tr("New folder"), {}, this)),
      advanced_(new QCheckBox(tr("More options"), this)),
      seed_(new QLineEdit(this)),
      checkProtocolButton_(new QPushButton(tr("Check protocol…"), this)),
      previewButton_(new QPushButton(tr("Preview…"), this)),
      fillButton_(new QPushButton(tr("Fill in the texts…"), this)) {
  protocol_->setObjectName(QStringLiteral("protocol"));
  for (const auto& name : protocols::libraryProtocols()) {
    const QString words = QString::fromStdString(name);
    protocol_->addItem(tr("%1 (ships with the program)").arg(words), words);
  }
  protocol_->addItem(tr("A file of my own…"), QString());
  folder_->setObjectName(QStringLiteral("folder"));
  folder_->setPath(unusedPath(QDir(documentsFolder()).filePath(QStringLiteral("my-study"))));
  seed_->setAccessibleName(tr("Seed"));
  seed_->setPlaceholderText(tr("the protocol's, otherwise a new one"));
  seed_->setValidator(
      new QRegularExpressionValidator(QRegularExpression(QStringLiteral("[0-9]{0,15}")), seed_));
  file_->startIn(protocolFolder());
  fillButton_->setObjectName(QStringLiteral("texts"));
  previewButton_->setObjectName(QStringLiteral("preview"));
  auto* actions = new QWidget(this);
  auto* looks = new QHBoxLayout(actions);
  looks->setContentsMargins(0, 0, 0, 0);
  looks->setSpacing(8);
  for (auto* button : {checkProtocolButton_, previewButton_, fillButton_}) {
    button->setAutoDefault(false);
    button->setProperty("role", QStringLiteral("tool"));
    looks->addWidget(button);
  }
  looks->addStretch(1);
  form().addRow(tr("Protocol"), protocol_);
  form().addRow(tr("Protocol file"), file_);
  form().addRow(QString(), actions);
  form().addRow(tr("New folder"), folder_);
  form().addRow(QString(), advanced_);
  form().addRow(tr("Random seed (optional)"), seed_);
  form().setRowVisible(seed_, false);
  connect(advanced_, &QCheckBox::toggled, this, [this](bool isShown) {
    form().setRowVisible(seed_, isShown);
    fit();
  });
  connect(protocol_, &QComboBox::currentIndexChanged, this, &NewStudyDialog::check);
  connect(protocol_, &QComboBox::activated, this, [this] {
    if (source().isEmpty()) file_->choose();
  });
  connect(file_, &PathField::pathChanged, this, &NewStudyDialog::check);
  connect(folder_, &PathField::pathChanged, this, &NewStudyDialog::updateButton);
  connect(&watch_, &FileWatch::changed, this, &NewStudyDialog::check);
  connect(checkProtocolButton_, &QPushButton::clicked, this, [this] {
    emit protocolRequested(source(), checked_.loaded ? &*checked_.loaded : nullptr);
  });
  connect(
      previewButton_, &QPushButton::clicked, this, [this] { openPreview(*checked_.loaded, this); });
  connect(fillButton_, &QPushButton::clicked, this, &NewStudyDialog::fillInTexts);
  check();
}

QString NewStudyDialog::source() const {
  const QString shipped = protocol_->currentData().toString();
  return shipped.isEmpty() ? file_->path() : shipped;
}

void NewStudyDialog::setProtocolFile(const QString& file) {
  protocol_->setCurrentIndex(protocol_->count() - 1);
  file_->setPath(file);
}

void NewStudyDialog::check() {
  const bool isOwn = protocol_->currentData().toString().isEmpty();
  form().setRowVisible(file_, isOwn);
  fit();
  watch_.watch(isOwn && !file_->path().isEmpty() ? QStringList{file_->path()} : QStringList());
  checked_ = {};
  checkProtocolButton_->setEnabled(!source().isEmpty());
  if (!source().isEmpty()) checked_ = checkProtocol(source().toStdString());
  if (isOwn && checked_.loaded) rememberProtocolFolder(file_->path());
  showChecked();
}

void NewStudyDialog::fillInTexts() {
  TextsDialog form(*checked_.loaded, TextsDialog::Reason::NotNeeded, this);
  if (form.exec() != QDialog::Accepted) return;
  questionnaires::Problems problems;
  auto filled = protocols::withTexts(*checked_.loaded, form.texts(), problems);
  if (!filled) filled = std::move(checked_.loaded);
  checked_ = checkedProtocol(
      std::move(checked_.source), std::move(checked_.text), std::move(filled), problems.all());
  showChecked();
}

void NewStudyDialog::showChecked() {
  previewButton_->setEnabled(checked_.loaded.has_value());
  fillButton_->setEnabled(checked_.loaded.has_value() && !checked_.loaded->blanks.empty());
  updateButton();
  if (source().isEmpty()) return clear();
  showOutcome(checked_.mark(), QString::fromStdString(checked_.verdict()), checked_.notes());
}

void NewStudyDialog::updateButton() {
  setDisabledReason(
      source().isEmpty()          ? tr("Choose a protocol file.")
      : !checked_.loaded          ? tr("The protocol has errors.")
      : folder_->path().isEmpty() ? tr("Choose a new folder.")
                                  : QString());
}

void NewStudyDialog::work() {
  std::optional<std::uint64_t> seed;
  if (!seed_->text().isEmpty()) seed = seed_->text().toULongLong();
  const QString folder = folder_->path();
  const bool isMade = attempt(this, MessageTopic::StudyNotCreated, [&] {
    SystemClock clock;
    Study::create(folder.toStdString(), *checked_.loaded, clock, seed);
  });
  if (!isMade) return;
  accept();
  emit created(folder);
}

}  // namespace study::gui
