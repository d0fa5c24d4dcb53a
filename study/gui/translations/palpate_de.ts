<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de">
<context>
    <name>study::gui::BenchmarkPage</name>
    <message>
        <source>I have made a cut</source>
        <translation>Ich habe einen Schnitt gemacht</translation>
    </message>
    <message>
        <source>Cuts: %1 of at least %2</source>
        <translation>Schnitte: %1 von mindestens %2</translation>
    </message>
</context>
<context>
    <name>study::gui::TrialPage</name>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>I have felt enough</source>
        <translation>Ich habe genug gefühlt</translation>
    </message>
    <message>
        <source>Press Begin when you hold the instrument.</source>
        <translation>Drücken Sie auf „Beginnen“, wenn Sie das Instrument in der Hand haben.</translation>
    </message>
    <message>
        <source>%1: %2 of at least %3</source>
        <translation>%1: %2 von mindestens %3</translation>
    </message>
    <message>
        <source>No, go on</source>
        <translation>Nein, weiter</translation>
    </message>
    <message>
        <source>Would you like to feel it once more before you choose?</source>
        <translation>Möchten Sie es noch einmal fühlen, bevor Sie wählen?</translation>
    </message>
    <message>
        <source>Feel it again</source>
        <translation>Noch einmal fühlen</translation>
    </message>
</context>
<context>
    <name>study::gui::NumberItem</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
</context>
<context>
    <name>study::gui::ParticipantWindow</name>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Thank you</source>
        <translation>Vielen Dank</translation>
    </message>
    <message>
        <source>This session is over. Please tell the researcher.</source>
        <translation>Diese Sitzung ist zu Ende. Bitte geben Sie der Studienleitung Bescheid.</translation>
    </message>
    <message>
        <source>One moment, please</source>
        <translation>Einen Moment, bitte</translation>
    </message>
    <message>
        <source>The researcher will go on in a moment.</source>
        <translation>Es geht gleich weiter.</translation>
    </message>
    <message>
        <source>A few questions</source>
        <translation>Einige Fragen</translation>
    </message>
    <message>
        <source>The researcher would like to talk with you.</source>
        <translation>Die Studienleitung möchte mit Ihnen sprechen.</translation>
    </message>
    <message>
        <source>A short break</source>
        <translation>Eine kurze Pause</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>Researcher</source>
        <translation>Versuchsleitung</translation>
    </message>
    <message>
        <source>You do not take part</source>
        <translation>Sie nehmen nicht teil</translation>
    </message>
    <message>
        <source>You need not say why. Please tell the researcher that you have decided.</source>
        <translation>Sie müssen das nicht begründen. Bitte sagen Sie der Versuchsleitung, dass Sie sich entschieden haben.</translation>
    </message>
    <message>
        <source>You have left the study</source>
        <translation>Sie haben die Studie verlassen</translation>
    </message>
    <message>
        <source>You need not say why. Please tell the researcher.</source>
        <translation>Sie müssen das nicht begründen. Bitte sagen Sie der Versuchsleitung Bescheid.</translation>
    </message>
</context>
<context>
    <name>study::gui::PointItem</name>
    <message>
        <source>%1: %2%3 of %4, from %5 to %6</source>
        <translation>%1: %2%3 von %4, von %5 bis %6</translation>
    </message>
</context>
<context>
    <name>study::gui::QuestionnairePage</name>
    <message>
        <source>You may leave this out.</source>
        <translation>Diese Angabe ist freiwillig.</translation>
    </message>
</context>
<context>
    <name>study::gui::ScreenLock</name>
    <message>
        <source>Only for the researcher: the PIN, please.</source>
        <translation>Nur für die Versuchsleitung: bitte die PIN.</translation>
    </message>
    <message>
        <source>PIN of the researcher</source>
        <translation>PIN der Versuchsleitung</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>That is not the PIN. Please wait %1 s.</source>
        <translation>Das ist nicht die PIN. Bitte warten Sie %1 s.</translation>
    </message>
    <message>
        <source>That is not the PIN.</source>
        <translation>Das ist nicht die PIN.</translation>
    </message>
</context>
<context>
    <name>study::gui::SliderItem</name>
    <message>
        <source>%1: from %2 to %3</source>
        <translation>%1: von %2 bis %3</translation>
    </message>
</context>
</TS>
