#include "study/gui/session_table.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QVBoxLayout>

#include "study/gui/attempt.h"
#include "study/gui/labels.h"
#include "study/gui/participant_window.h"
#include "study/storage/records.h"

namespace study::gui {

SessionTable::SessionTable(Study& study, QWidget* parent)
    : QWidget(parent),
      study_(study),
      table_(new QTableWidget(this)),
      cohort_(new QComboBox(this)),
      mode_(new QComboBox(this)),
      language_(new QComboBox(this)),
      enrol_(new QPushButton(tr("New participant"), this)),
      resume_(new QPushButton(tr("Go on with the selected one"), this)) {
  const auto& protocol = study.protocol().protocol;
  for (const auto& cohort : protocol.cohorts) {
    cohort_->addItem(
        QString::fromStdString(cohort.title.in("en")), QString::fromStdString(cohort.id));
  }
  mode_->addItem(tr("live"), static_cast<int>(RunMode::Live));
  mode_->addItem(tr("pilot (does not count)"), static_cast<int>(RunMode::Pilot));
  for (const auto& language : protocol.languages) {
    const QString tag = QString::fromStdString(language);
    language_->addItem(nativeName(tag), tag);
  }
  for (auto* button : {enrol_, resume_}) button->setProperty("role", QStringLiteral("tool"));
  cohort_->setAccessibleName(tr("Cohort"));
  mode_->setAccessibleName(tr("Run mode"));
  language_->setAccessibleName(tr("Language"));

  table_->setColumnCount(4);
  table_->setHorizontalHeaderLabels(
      {tr("Participant"), tr("Cohort"), tr("Run mode"), tr("Status")});
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->verticalHeader()->hide();
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(table_, 1);
  layout->addWidget(resume_);
  auto* choices = new QHBoxLayout;
  for (auto* box : {cohort_, mode_, language_}) choices->addWidget(box, 1);
  layout->addLayout(choices);
  layout->addWidget(enrol_);

  connect(enrol_, &QPushButton::clicked, this, [this] {
    emit enrolRequested(
        {.cohort = cohort_->currentData().toString().toStdString(),
         .runMode = static_cast<RunMode>(mode_->currentData().toInt()),
         .language = language_->currentData().toString().toStdString(),
         .code = {}});
  });
  connect(resume_, &QPushButton::clicked, this, [this] {
    const auto* first = table_->item(table_->currentRow(), 0);
    if (first != nullptr) emit resumeRequested(first->data(Qt::UserRole).toLongLong());
  });
  connect(table_, &QTableWidget::itemSelectionChanged, this, [this] {
    const auto* last = table_->item(table_->currentRow(), 3);
    resume_->setEnabled(
        enrol_->isEnabled() && last != nullptr && last->text() == QStringLiteral("in_progress"));
  });
  refresh();
}

void SessionTable::refresh() {
  attempt(this, [&] {
    const auto sessions = storage::Records(study_.database()).sessions();
    table_->setRowCount(static_cast<int>(sessions.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
      const auto& s = sessions[static_cast<std::size_t>(row)];
      auto* code = new QTableWidgetItem(asText(s.participant));
      code->setData(Qt::UserRole, static_cast<qlonglong>(s.id));
      table_->setItem(row, 0, code);
      table_->setItem(row, 1, new QTableWidgetItem(asText(s.cohort)));
      table_->setItem(row, 2, new QTableWidgetItem(asText(s.runMode)));
      table_->setItem(row, 3, new QTableWidgetItem(asText(s.status)));
    }
    table_->scrollToBottom();
  });
  resume_->setEnabled(false);
}

void SessionTable::setOpen(bool isOpen) {
  enrol_->setEnabled(!isOpen);
  resume_->setEnabled(false);
}

}  // namespace study::gui
