#include "study/gui/widgets/message_box.h"

#include <algorithm>
#include <utility>

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QPainter>

#include "study/gui/widgets/attempt.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/field_form.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {

/// The text in the language of the desk. An argument is not searched for further places.
QString withArguments(const char* english, const QStringList& arguments) {
  const QString text = deskText(english);
  QString filled;
  for (qsizetype i = 0; i < text.size(); ++i) {
    const bool isPlace = text[i] == u'%' && i + 1 < text.size() && text[i + 1].isDigit();
    const int place = isPlace ? text[i + 1].digitValue() : 0;
    if (place < 1 || place > arguments.size()) {
      filled += text[i];
      continue;
    }
    filled += arguments[place - 1];
    ++i;
  }
  return filled;
}

/// The sign of a kind of message, told apart by its letter as well as by its colour.
class KindIcon final : public QWidget {
 public:
  KindIcon(MessageRow::Kind kind, QWidget* parent) : QWidget(parent), kind_(kind) {
    constexpr int kSize = 40;  // [px]
    setFixedSize(kSize, kSize);
  }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    const auto& theme = themeOf(*this);
    const auto [letter, fill] = symbolAndFillFor(theme);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill.background);
    painter.drawEllipse(rect());
    auto bold = font();
    bold.setPixelSize(height() * 3 / 5);
    bold.setBold(true);
    painter.setFont(bold);
    painter.setPen(fill.text);
    painter.drawText(rect(), Qt::AlignCenter, letter);
  }

 private:
  std::pair<QString, Fill> symbolAndFillFor(const Theme& theme) const {
    switch (kind_) {
      case MessageRow::Kind::Failure:
        return {QStringLiteral("✕"), theme.stop};
      case MessageRow::Kind::Warning:
        return {QStringLiteral("!"), theme.warn};
      case MessageRow::Kind::Information:
        return {QStringLiteral("i"), theme.accent};
      case MessageRow::Kind::Question:
        return {QStringLiteral("?"), theme.accent};
    }
    return {};
  }

  MessageRow::Kind kind_;
};

}  // namespace

QVBoxLayout* addBoxWords(
    QVBoxLayout& layout,
    MessageRow::Kind kind,
    const QString& headline,
    const QStringList& paragraphs,
    QWidget& box) {
  constexpr int kWidth = 480;  // [px] of the words: about 55 characters
  auto* column = new QVBoxLayout;
  column->setSpacing(10);
  auto* heading = headingLabel(headline, &box);
  heading->setMinimumWidth(kWidth);
  column->addWidget(heading);
  for (const auto& paragraph : paragraphs) {
    auto* label = bodyLabel(paragraph, &box);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);  // an error can be passed on
    column->addWidget(label);
  }
  auto* row = new QHBoxLayout;
  row->setSpacing(16);
  row->addWidget(new KindIcon(kind, &box), 0, Qt::AlignTop);
  row->addLayout(column, 1);
  layout.setContentsMargins(20, 18, 20, 16);
  layout.setSpacing(16);
  layout.addLayout(row);
  return column;
}

MessageBox::MessageBox(
    MessageTopic topic, const QStringList& arguments, const QString& why, QWidget* parent)
    : QDialog(parent), topic_(topic), column_(nullptr) {
  const auto& row = messageAbout(topic);
  setWindowTitle(withArguments(row.title, arguments));
  const QString headline = withArguments(row.headline, arguments);
  QStringList paragraphs{
      withArguments(row.data, arguments), why.trimmed(), withArguments(row.advice, arguments)};
  if (row.kind == MessageRow::Kind::Failure) std::swap(paragraphs[0], paragraphs[1]);
  paragraphs.removeAll(QString());
  words_ = QStringList(headline) + paragraphs;
  auto* layout = new QVBoxLayout(this);
  layout->setSizeConstraint(QLayout::SetFixedSize);  // always as large as its words need
  column_ = addBoxWords(*layout, row.kind, headline, paragraphs, *this);
  if (row.field != MessageRow::Field::None) addField(row);
  addButtons(row);
  updateButtons();
}

void MessageBox::addField(const MessageRow& row) {
  auto* form = new FieldForm;
  const QString label = deskText(row.label);
  if (row.field == MessageRow::Field::Choice) {
    choices_ = new QComboBox(this);
    choices_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    form->addRow(label, choices_);
  } else {
    line_ = new QLineEdit(this);
    if (row.field == MessageRow::Field::Passphrase) line_->setEchoMode(QLineEdit::Password);
    form->addRow(label, line_);
    if (row.field == MessageRow::Field::NeededText) {
      disabledReason_ = quietLabel(deskText(row.missing), this);
      disabledReason_->setObjectName(QStringLiteral("obstacle"));
      auto size = disabledReason_->sizePolicy();
      size.setRetainSizeWhenHidden(
          true);  // the box does not change its height with the first letter
      disabledReason_->setSizePolicy(size);
    }
    connect(line_, &QLineEdit::textChanged, this, &MessageBox::updateButtons);
  }
  column_->addLayout(form);
  if (disabledReason_ != nullptr) column_->addWidget(disabledReason_);
}

void MessageBox::addButtons(const MessageRow& row) {
  auto* buttons = new QDialogButtonBox(this);
  safeButton_ = buttons->addButton(deskText(row.safe), QDialogButtonBox::RejectRole);
  safeButton_->setObjectName(QStringLiteral("safe"));
  if (*row.action != '\0') {
    actionButton_ = buttons->addButton(deskText(row.action), QDialogButtonBox::AcceptRole);
    actionButton_->setObjectName(QStringLiteral("action"));
    if (row.field != MessageRow::Field::None) {
      actionButton_->setProperty("role", QStringLiteral("main"));
    }
  }
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  static_cast<QVBoxLayout*>(layout())->addWidget(buttons);
  if (line_ != nullptr) {
    line_->setFocus();
  } else if (choices_ != nullptr) {
    choices_->setFocus();
  } else {
    safeButton_->setFocus();
  }
}

/// Enables the action and makes Enter its key as soon as something is typed or chosen; before that,
/// Enter does nothing.
void MessageBox::updateButtons() {
  const bool isWritten = choice() >= 0 || (line_ != nullptr && !line_->text().trimmed().isEmpty());
  const bool isNeeded = messageAbout(topic_).field == MessageRow::Field::NeededText;
  if (actionButton_ != nullptr) {
    actionButton_->setEnabled(isWritten || !isNeeded);
    actionButton_->setAutoDefault(isWritten);
    actionButton_->setDefault(isWritten);
  }
  safeButton_->setDefault(!isWritten);
  if (disabledReason_ != nullptr) disabledReason_->setVisible(!isWritten);
}

QString MessageBox::text() const {
  return choices_ != nullptr ? choices_->currentText()
         : line_ != nullptr  ? line_->text()
                             : QString();
}

void MessageBox::setText(const QString& text) {
  if (line_ != nullptr) line_->setText(text);
}

void MessageBox::setChoices(const QStringList& choices) {
  choices_->addItems(choices);
  updateButtons();
}

void MessageBox::add(QWidget& widget) {
  column_->addWidget(&widget);
}

void showMessage(
    QWidget* parent, MessageTopic topic, const QStringList& arguments, const QString& why) {
  MessageBox(topic, arguments, why, parent).exec();
}

void showFailure(QWidget* parent, MessageTopic topic, const std::exception& error) {
  showMessage(parent, topic, {}, deskText(error));
}

bool ask(QWidget* parent, MessageTopic topic, const QStringList& arguments, const QString& why) {
  return MessageBox(topic, arguments, why, parent).exec() == QDialog::Accepted;
}

std::optional<QString> askForText(
    QWidget* parent,
    MessageTopic topic,
    const QStringList& arguments,
    const QString& written,
    const QString& why) {
  MessageBox box(topic, arguments, why, parent);
  box.setText(written);
  if (box.exec() != QDialog::Accepted) return std::nullopt;
  return box.text();
}

std::optional<int> askForChoice(QWidget* parent, MessageTopic topic, const QStringList& choices) {
  MessageBox box(topic, {}, {}, parent);
  box.setChoices(choices);
  if (box.exec() != QDialog::Accepted) return std::nullopt;
  return box.choice();
}

}  // namespace study::gui
