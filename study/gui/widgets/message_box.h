#pragma once

#include <optional>

#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QString>
#include <QStringList>
#include <QVBoxLayout>

#include "study/gui/widgets/messages.h"

namespace study::gui {

/// The only box for messages and questions: a bold line that says what happened or what is asked,
/// below it what that means for the data and what to do. The buttons are verbs. The safe one has
/// the focus and is the default, until something is typed.
class MessageBox final : public QDialog {
  Q_OBJECT

 public:
  /// @param arguments  replace %1, %2, … in the words of the topic.
  /// @param why  shown as it is: the cause of a failure, before what it means for the data, or a
  /// list after it.
  MessageBox(
      MessageTopic topic,
      const QStringList& arguments,
      const QString& why,
      QWidget* parent = nullptr);

  MessageTopic topic() const noexcept { return topic_; }
  /// All text of the box, paragraph by paragraph.
  QString words() const { return words_.join(QStringLiteral("\n\n")); }

  /// The text in the field, or the chosen entry.
  QString text() const;
  void setText(const QString& text);
  void setChoices(const QStringList& choices);
  int choice() const { return choices_ == nullptr ? -1 : choices_->currentIndex(); }

  /// Adds a widget below the words.
  void add(QWidget& widget);

 private:
  void addField(const MessageRow& row);
  void addButtons(const MessageRow& row);
  void updateButtons();

  MessageTopic topic_;
  QStringList words_;
  QVBoxLayout* column_;
  QLineEdit* line_ = nullptr;
  QLabel* disabledReason_ = nullptr;  ///< why the action cannot be chosen yet
  QComboBox* choices_ = nullptr;
  QPushButton* safeButton_ = nullptr;
  QPushButton* actionButton_ = nullptr;  ///< nullptr: nothing is asked
};

/// Adds the sign of the kind, and a headline with @p paragraphs below it, to @p layout.
/// @return the column of the words, to which more can be added.
QVBoxLayout* addBoxWords(
    QVBoxLayout& layout,
    MessageRow::Kind kind,
    const QString& headline,
    const QStringList& paragraphs,
    QWidget& box);

/// Shows a message and waits until it is closed.
void showMessage(
    QWidget* parent,
    MessageTopic topic,
    const QStringList& arguments = {},
    const QString& why = {});

/// Asks a question. Closing the box is the safe answer.
/// @return whether the action was chosen.
bool ask(
    QWidget* parent,
    MessageTopic topic,
    const QStringList& arguments = {},
    const QString& why = {});

/// Asks for a text.
/// @return what was written; std::nullopt if the safe button was chosen.
std::optional<QString> askForText(
    QWidget* parent,
    MessageTopic topic,
    const QStringList& arguments = {},
    const QString& written = {},
    const QString& why = {});

/// Asks for one of @p choices.
/// @return its index.
std::optional<int> askForChoice(QWidget* parent, MessageTopic topic, const QStringList& choices);

}  // namespace study::gui
