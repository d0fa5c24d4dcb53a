#include "study/gui/desk/help_window.h"

#include <algorithm>
#include <array>
#include <vector>

#include <QAbstractTextDocumentLayout>
#include <QKeyEvent>
#include <QPixmap>
#include <QPointer>
#include <QScrollBar>
#include <QSplitter>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextFrame>
#include <QTextList>
#include <QTextTable>
#include <QTimer>
#include <QVBoxLayout>

#include "study/gui/participant/participant_window.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {

constexpr const char* kFirstPage = "running-a-study.md";
constexpr const char* kHelpProperty = "help";

constexpr auto kWindows = std::to_array<ProgramWindow>({
    {"AmendDialog", "Create the study"},
    {"BackgroundTask", ""},
    {"BackupDialog", "After each day"},
    {"BuildBoneDialog", "Bones and materials"},
    {"BoneColoursWindow", "Bones and materials"},
    {"EraseDialog", "After each day"},
    {"ExportDialog", "The results"},
    {"FindingsDialog", "The day"},
    {"FitMaterialDialog", "Bones and materials"},
    {"HelpWindow", ""},
    {"HomeWindow", "The studio"},
    {"ImportCutDialog", "Import a recording"},
    {"KeyDialog", "The results"},
    {"MessageBox", "When something goes wrong"},
    {"NewStudyDialog", "Create the study"},
    {"OperatorWindow", "The day"},
    {"PageMirror", "The day"},
    {"ParticipantWindow", ""},
    {"PinDialog", "The day"},
    {"PlanDialog", "Create the study"},
    {"PreviewWindow", "Look at every page"},
    {"ProtocolWindow", "Write the protocol"},
    {"QFileDialog", ""},
    {"ReportDialog", "The results"},
    {"SelfTestDialog", "System check"},
    {"SimulateDialog", "Create the study"},
    {"SimulationView", "Bones and materials"},
    {"StatisticsDialog", "The results"},
    {"TextsDialog", "Fill in the texts"},
    {"Tour", "Try it"},
    {"VerifyDialog", "After each day"},
});

QUrl placeOf(const QString& page) {
  return {QStringLiteral("qrc:/help/") + (page.isEmpty() ? QString::fromUtf8(kFirstPage) : page)};
}

QPointer<HelpWindow>& helpWindow() {
  static QPointer<HelpWindow> window;
  return window;
}

bool belongsToParticipant(const QWidget& widget) {
  for (const auto* w = &widget; w != nullptr; w = w->parentWidget()) {
    if (qobject_cast<const ParticipantWindow*>(w) != nullptr) return true;
  }
  return false;
}

/// Adds the space between paragraphs that Qt's Markdown import omits.
void addParagraphSpacing(const QTextBlock& block) {
  const bool isHeading = block.blockFormat().headingLevel() > 0;
  const bool isCode = block.blockFormat().hasProperty(QTextFormat::BlockCodeFence);
  QTextBlockFormat format;
  format.setTopMargin(isHeading ? 22.0 : 0.0);
  format.setBottomMargin(isCode ? 0.0 : 8.0);
  format.setNonBreakableLines(false);  // wraps long commands
  QTextCursor(block).mergeBlockFormat(format);
}

/// Thin lines around cells and space in them, instead of Qt's double frames.
void fitTables(const QTextDocument& document, const QColor& ink) {
  for (auto* frame : document.rootFrame()->childFrames()) {
    auto* table = qobject_cast<QTextTable*>(frame);
    if (table == nullptr) continue;
    auto format = table->format();
    format.setBorder(1.0);
    format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    format.setBorderCollapse(true);
    format.setCellSpacing(0.0);
    format.setCellPadding(7.0);
    format.setTopMargin(6.0);
    format.setBottomMargin(14.0);
    format.setBorderBrush(ink);
    table->setFormat(format);
  }
}

/// A picture in the text.
struct Picture {
  int place;   ///< position of its character
  int width;   ///< natural width [px]
  int indent;  ///< indentation of its line [px]
};

std::vector<Picture> picturesIn(const QTextDocument& document) {
  std::vector<Picture> pictures;
  for (auto block = document.begin(); block.isValid(); block = block.next()) {
    const int steps = block.blockFormat().indent() +
                      (block.textList() == nullptr ? 0 : block.textList()->format().indent());
    const int indent = static_cast<int>(steps * document.indentWidth());
    for (auto it = block.begin(); !it.atEnd(); ++it) {
      const auto format = it.fragment().charFormat().toImageFormat();
      if (!format.isValid()) continue;
      const QUrl name(format.name());
      const auto held = document.resource(QTextDocument::ImageResource, name);
      auto image = held.value<QImage>();
      if (image.isNull()) image = QImage::fromData(held.toByteArray());  // not painted yet
      if (!image.isNull()) pictures.push_back({it.fragment().position(), image.width(), indent});
    }
  }
  return pictures;
}

/// Scales each picture to at most @p room [px] wide and at most its natural width.
void fitPictures(QTextDocument& document, int room) {
  for (const auto& picture : picturesIn(document)) {
    QTextCursor cursor(&document);
    cursor.setPosition(picture.place);
    cursor.setPosition(picture.place + 1, QTextCursor::KeepAnchor);
    auto format = cursor.charFormat().toImageFormat();
    format.setWidth(std::min(picture.width, room - picture.indent));
    cursor.setCharFormat(format);
  }
}

class HelpKey final : public QObject {
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() != QEvent::KeyPress) return false;
    const auto* widget = qobject_cast<QWidget*>(watched);
    const auto* key = static_cast<QKeyEvent*>(event);
    if (widget == nullptr || key->key() != Qt::Key_F1) return false;
    if (!belongsToParticipant(*widget)) showHelp(helpTopicOf(*widget), widget);
    return true;
  }
};

}  // namespace

/// The text has many links, so Tab leaves it; Left and Right move from link to link. Its lines are
/// never too long to be read.
class HelpWindow::Text final : public QTextBrowser {
 public:
  using QTextBrowser::QTextBrowser;

 protected:
  void resizeEvent(QResizeEvent* event) override {
    constexpr int kWidest = 820;  // [px]
    constexpr int kLeft = 16;
    const int bar = verticalScrollBar()->sizeHint().width();
    const int rest = width() - 2 * frameWidth() - bar - kWidest;
    setViewportMargins(std::clamp(rest / 2, 0, kLeft), 0, std::max(0, rest - kLeft), 0);
    QTextBrowser::resizeEvent(event);
  }

  bool focusNextPrevChild(bool next) override {
    // NOLINTNEXTLINE(bugprone-parent-virtual-call): the text browser's own goes to a link
    return QWidget::focusNextPrevChild(next);
  }

  void keyPressEvent(QKeyEvent* event) override {
    const bool isToLink = event->key() == Qt::Key_Right || event->key() == Qt::Key_Left;
    if (!isToLink) return QTextBrowser::keyPressEvent(event);
    QTextBrowser::focusNextPrevChild(event->key() == Qt::Key_Right);
  }
};

std::span<const ProgramWindow> programWindows() noexcept {
  return kWindows;
}

QString helpTopicOf(const QWidget& widget) {
  for (const auto* w = &widget; w != nullptr; w = w->parentWidget()) {
    const QString own = w->property(kHelpProperty).toString();
    if (!own.isEmpty()) return own;
    const std::string_view name = w->metaObject()->className();
    const auto* found =
        std::ranges::find(kWindows, name.substr(name.rfind(':') + 1), &ProgramWindow::name);
    if (found != kWindows.end() && !found->topic.empty()) {
      return QString::fromUtf8(found->topic.data(), static_cast<qsizetype>(found->topic.size()));
    }
  }
  return {};
}

HelpWindow* openHelp() noexcept {
  return helpWindow().data();
}

void showHelp(const QString& topic, const QWidget* beside) {
  // A modal window blocks all other windows except its children.
  auto* modal = QApplication::activeModalWidget();
  if (openHelp() != nullptr && modal != nullptr && openHelp()->parentWidget() != modal) {
    delete openHelp();
  }
  if (openHelp() == nullptr) {
    auto* window = new HelpWindow(modal);
    window->setWindowFlag(Qt::Window);
    window->setAttribute(Qt::WA_DeleteOnClose);
    window->setAttribute(Qt::WA_QuitOnClose, false);
    // Places the help over the window that asked, so that it never covers the participant's window
    // on another screen.
    constexpr QPoint kOffset(60, 40);
    if (beside != nullptr) window->move(beside->window()->frameGeometry().topLeft() + kOffset);
    helpWindow() = window;
  }
  openHelp()->showTopic(topic);
  openHelp()->raise();
}

void installHelpKey(QApplication& application) {
  application.installEventFilter(new HelpKey(&application));
}

HelpWindow::HelpWindow(QWidget* parent)
    : QMainWindow(parent),
      searchField_(new QLineEdit(this)),
      searchResult_(quietLabel({}, this)),
      contents_(new QListWidget(this)),
      text_(new Text(this)) {
  setWindowTitle(tr("Help — Palpate"));
  searchField_->setPlaceholderText(tr("Search this page"));
  searchField_->setAccessibleName(tr("Search this page"));
  searchField_->setClearButtonEnabled(true);
  searchResult_->setVisible(false);
  contents_->setAccessibleName(tr("Contents"));
  contents_->setWordWrap(true);
  contents_->setIconSize({14, 1});
  contents_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  text_->setOpenExternalLinks(false);
  text_->setAccessibleName(tr("Help"));
  text_->setAccessibleDescription(tr("Left and Right go from link to link"));
  text_->viewport()->installEventFilter(this);
  text_->document()->setDocumentMargin(16);
  text_->setWordWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  auto* sides = new QSplitter(this);
  auto* left = new QWidget(this);
  auto* lines = withMargins<QVBoxLayout>(left, {12, 12, 12, 12});
  lines->addWidget(searchField_);
  lines->addWidget(searchResult_);
  lines->addWidget(contents_, 1);
  sides->addWidget(left);
  sides->addWidget(text_);
  sides->setSizes({300, 800});
  sides->setStretchFactor(1, 1);
  setCentralWidget(sides);
  resizeOnScreen(*this, {1100, 760});
  connect(searchField_, &QLineEdit::returnPressed, this, &HelpWindow::search);
  connect(searchField_, &QLineEdit::textEdited, this, [this] {
    text_->moveCursor(QTextCursor::Start);
    search();
  });
  connect(text_, &QTextBrowser::sourceChanged, this, &HelpWindow::listHeadings);
  const auto open = [this](const QListWidgetItem* item) { goTo(item->data(Qt::UserRole).toInt()); };
  connect(contents_, &QListWidget::itemClicked, this, open);
  connect(contents_, &QListWidget::itemActivated, this, open);
  text_->setSource(placeOf({}));
}

void HelpWindow::listHeadings() {
  contents_->clear();
  constexpr int kMainLevel = 2;
  QPixmap indent(contents_->iconSize());
  indent.fill(Qt::transparent);
  for (auto block = text_->document()->begin(); block.isValid(); block = block.next()) {
    addParagraphSpacing(block);
    if (block.blockFormat().headingLevel() == 0) continue;
    auto* item = new QListWidgetItem(block.text(), contents_);
    item->setData(Qt::UserRole, block.blockNumber());
    if (block.blockFormat().headingLevel() <= kMainLevel) {
      auto font = contents_->font();
      font.setWeight(QFont::DemiBold);
      item->setFont(font);
      continue;
    }
    item->setIcon(indent);  // an empty picture also indents the second line of a long heading
  }
  fitTables(*text_->document(), themeOf(*this).line);
  fitToWidth();
}

/// Goes to the next place of the wanted words; after the last one, to the first.
void HelpWindow::search() {
  const QString words = searchField_->text().trimmed();
  bool isFound = words.isEmpty() || text_->find(words);
  if (!isFound) {
    text_->moveCursor(QTextCursor::Start);
    isFound = text_->find(words);
  }
  searchResult_->setText(tr("Not on this page."));
  searchResult_->setVisible(!isFound);
}

bool HelpWindow::eventFilter(QObject* watched, QEvent* event) {
  // The text is laid out again only after this event.
  if (event->type() == QEvent::Resize) QTimer::singleShot(0, this, &HelpWindow::fitToWidth);
  return QMainWindow::eventFilter(watched, event);
}

/// Fits the pictures. The text at the top of the view stays in place.
void HelpWindow::fitToWidth() {
  const auto place = text_->cursorForPosition({0, 0});
  const int before = text_->cursorRect(place).top();
  const int margins = 2 * static_cast<int>(text_->document()->documentMargin());
  fitPictures(*text_->document(), std::max(1, text_->viewport()->width() - margins));
  auto* bar = text_->verticalScrollBar();
  bar->setValue(bar->value() + text_->cursorRect(place).top() - before);
}

void HelpWindow::goTo(int number) {
  const auto block = text_->document()->findBlockByNumber(number);
  heading_ = block.text();
  const auto place = text_->document()->documentLayout()->blockBoundingRect(block);
  text_->verticalScrollBar()->setValue(static_cast<int>(place.top()));
}

void HelpWindow::showTopic(const QString& topic) {
  const auto page = placeOf(topic.section(u'#', 0, -2));
  const auto heading = topic.section(u'#', -1);
  if (text_->source() != page) text_->setSource(page);
  show();  // the text has its layout only when it is visible
  for (int row = 0; row < contents_->count(); ++row) {
    if (row > 0 && !contents_->item(row)->text().contains(heading)) continue;
    if (row == 0 && !heading.isEmpty()) continue;
    contents_->setCurrentRow(row);
    return goTo(contents_->item(row)->data(Qt::UserRole).toInt());
  }
  contents_->setCurrentRow(0);
  if (contents_->count() > 0) goTo(contents_->item(0)->data(Qt::UserRole).toInt());
}

}  // namespace study::gui
