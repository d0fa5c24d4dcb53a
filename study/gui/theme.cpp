#include "study/gui/theme.h"

#include <QFont>
#include <QStyleFactory>

namespace study::gui {
namespace {

constexpr const char* kStyle = R"css(
QWidget { color: #1b1f24; background: #fbfbf9; font-size: 16px; }
QLabel[role="title"] { font-size: 30px; font-weight: 600; }
QLabel[role="huge"] { font-size: 54px; font-weight: 600; }
QLabel[role="statement"] { font-size: 20px; }
QLabel[role="quiet"] { color: #59616b; }
QLabel[role="anchor"] { color: #3b434d; font-size: 15px; }
QPushButton { background: #ffffff; border: 2px solid #9aa4ae; border-radius: 8px; padding: 8px 18px;
              min-height: 34px; }
QPushButton:hover { border-color: #1f5f99; }
QPushButton:focus { border: 3px solid #e07b00; }
QPushButton:disabled { color: #9aa4ae; border-color: #d4d9de; background: #f2f3f4; }
QPushButton:checked { background: #1f5f99; color: #ffffff; border-color: #1f5f99; }
QPushButton:checked:focus { border: 3px solid #e07b00; }
QPushButton[role="next"] { background: #1f5f99; color: #ffffff; border-color: #1f5f99; font-size: 20px;
                           font-weight: 600; min-height: 48px; min-width: 180px; }
QPushButton[role="next"]:disabled { background: #d4d9de; color: #7c8791; border-color: #d4d9de; }
QPushButton[role="next"]:focus { border: 3px solid #e07b00; }
QPushButton[role="point"] { font-size: 20px; min-width: 56px; min-height: 52px; padding: 4px; }
QPushButton[role="option"] { text-align: left; min-height: 44px; font-size: 18px; }
QPushButton[role="tool"] { min-height: 22px; padding: 5px 10px; }
QPushButton[role="stop"] { background: #b3261e; color: #ffffff; border-color: #7d150f; font-size: 24px;
                           font-weight: 700; min-height: 64px; }
QPushButton[role="stop"]:disabled { background: #e3c5c3; border-color: #e3c5c3; }
QLabel[role="good"] { background: #1e6b3a; color: #ffffff; border-radius: 6px; font-weight: 600; }
QLabel[role="resting"] { background: #e3e6e9; color: #3b434d; border-radius: 6px; font-weight: 600; }
QLabel[role="bad"] { background: #b3261e; color: #ffffff; border-radius: 6px; font-weight: 600; }
QLineEdit, QPlainTextEdit, QComboBox { background: #ffffff; border: 2px solid #9aa4ae; border-radius: 6px;
                                       padding: 6px; }
QLineEdit:focus, QPlainTextEdit:focus, QComboBox:focus { border: 3px solid #e07b00; }
QProgressBar { border: none; background: #e3e6e9; border-radius: 4px; max-height: 8px; }
QProgressBar::chunk { background: #1f5f99; border-radius: 4px; }
QFrame[role="card"] { background: #ffffff; border: 1px solid #d4d9de; border-radius: 10px; }
QFrame[role="card"] QLabel { background: transparent; }
QScrollArea { border: none; }
QScrollBar:vertical { background: #f0f1f2; width: 14px; margin: 0; border: none; border-radius: 7px; }
QScrollBar::handle:vertical { background: #9aa4ae; min-height: 40px; border-radius: 7px; }
QScrollBar:horizontal { background: #f0f1f2; height: 14px; margin: 0; border: none; border-radius: 7px; }
QScrollBar::handle:horizontal { background: #9aa4ae; min-width: 40px; border-radius: 7px; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QTableWidget { background: #ffffff; border: 1px solid #d4d9de; gridline-color: #e9ecef; }
QHeaderView::section { background: #eef0f2; border: none; padding: 4px 8px; font-weight: 600; }
QGroupBox { font-weight: 600; border: 1px solid #d4d9de; border-radius: 8px; margin-top: 12px;
            padding-top: 10px; }
QGroupBox::title { subcontrol-origin: margin; left: 10px; }
)css";

}  // namespace

void applyTheme(QApplication& application) {
  application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(16);
  application.setFont(font);
  application.setStyleSheet(QString::fromUtf8(kStyle));
}

}  // namespace study::gui
