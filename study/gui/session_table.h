#pragma once

#include <QComboBox>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>

#include "study/session.h"

namespace study::gui {

/// Who has taken part, whom to go on with, and a new participant.
class SessionTable final : public QWidget {
  Q_OBJECT

 public:
  explicit SessionTable(Study& study, QWidget* parent = nullptr);

  void refresh();
  /// While a session is open nobody else's can be.
  void setOpen(bool isOpen);

 signals:
  void enrolRequested(const study::Enrolment& enrolment);
  void resumeRequested(qlonglong session);

 private:
  Study& study_;
  QTableWidget* table_;
  QComboBox* cohort_;
  QComboBox* mode_;
  QComboBox* language_;
  QPushButton* enrol_;
  QPushButton* resume_;
};

}  // namespace study::gui
