#pragma once

#include <QBoxLayout>
#include <QPushButton>
#include <QWidget>

namespace study::gui {

/// What the home page shows as long as there is no study: what the program does, and three ways to
/// begin.
class Welcome final : public QWidget {
  Q_OBJECT

 public:
  explicit Welcome(QWidget* parent = nullptr);

 signals:
  void tourRequested();
  void systemCheckRequested();
  void newStudyRequested();
  void folderRequested();
  void protocolCheckRequested();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  struct StartOption;
  void addCard(const StartOption& way);
  QWidget* makeLinks();

  QPushButton* main_ = nullptr;
  QBoxLayout* cards_;  ///< beside each other; below each other in a narrow window
};

}  // namespace study::gui
