// palpate-studio: the windows. Does nothing that the command line cannot do.
#include <cstdio>

#include <QApplication>
#include <QCommandLineParser>
#include <QFileDialog>
#include <QMessageBox>

#include "study/gui/attempt.h"
#include "study/gui/operator_window.h"
#include "study/gui/theme.h"
#include "study/study.h"

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QCoreApplication::setApplicationName(QStringLiteral("palpate-studio"));
  QCoreApplication::setApplicationVersion(QString::fromUtf8(study::appVersion().data()));
  study::gui::applyTheme(application);

  QCommandLineParser parser;
  parser.setApplicationDescription(
      QStringLiteral("The windows of a study: for the operator, and for the participant."));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(
      QStringLiteral("DIR"), QStringLiteral("The study's folder; asked for where it is left out."));
  parser.process(application);

  QString folder = parser.positionalArguments().value(0);
  if (folder.isEmpty()) {
    folder = QFileDialog::getExistingDirectory(
        nullptr, QCoreApplication::translate("main", "Choose the folder of a study"));
  }
  if (folder.isEmpty()) return 0;

  study::SystemClock clock;
  int status = 1;
  study::gui::attempt(nullptr, [&] {
    auto study = study::Study::open(folder.toStdString(), clock);
    study::gui::OperatorWindow window(study);
    window.show();
    status = QApplication::exec();
  });
  return status;
}
