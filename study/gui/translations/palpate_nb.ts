<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="nb">
<context>
    <name>study::gui::BenchmarkPage</name>
    <message>
        <source>I have made a cut</source>
        <translation>Jeg har gjort et kutt</translation>
    </message>
    <message>
        <source>Cuts: %1 of at least %2</source>
        <translation>Kutt: %1 av minst %2</translation>
    </message>
</context>
<context>
    <name>study::gui::TrialPage</name>
    <message>
        <source>Begin</source>
        <translation>Begynn</translation>
    </message>
    <message>
        <source>I have felt enough</source>
        <translation>Jeg har kjent nok</translation>
    </message>
    <message>
        <source>Press Begin when you hold the instrument.</source>
        <translation>Trykk «Begynn» når du holder instrumentet.</translation>
    </message>
    <message>
        <source>%1: %2 of at least %3</source>
        <translation>%1: %2 av minst %3</translation>
    </message>
    <message>
        <source>No, go on</source>
        <translation>Nei, gå videre</translation>
    </message>
    <message>
        <source>Would you like to feel it once more before you choose?</source>
        <translation>Vil du kjenne på det en gang til før du velger?</translation>
    </message>
    <message>
        <source>Feel it again</source>
        <translation>Kjenn på det igjen</translation>
    </message>
</context>
<context>
    <name>study::gui::NumberItem</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 til %2</translation>
    </message>
</context>
<context>
    <name>study::gui::ParticipantWindow</name>
    <message>
        <source>Next</source>
        <translation>Neste</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Språk</translation>
    </message>
    <message>
        <source>Thank you</source>
        <translation>Tusen takk</translation>
    </message>
    <message>
        <source>This session is over. Please tell the researcher.</source>
        <translation>Denne økten er over. Si fra til forskeren.</translation>
    </message>
    <message>
        <source>One moment, please</source>
        <translation>Et øyeblikk</translation>
    </message>
    <message>
        <source>The researcher will go on in a moment.</source>
        <translation>Forskeren fortsetter om et øyeblikk.</translation>
    </message>
    <message>
        <source>A few questions</source>
        <translation>Noen spørsmål</translation>
    </message>
    <message>
        <source>The researcher would like to talk with you.</source>
        <translation>Forskeren vil gjerne snakke med deg.</translation>
    </message>
    <message>
        <source>A short break</source>
        <translation>En kort pause</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Steg %1 av %2</translation>
    </message>
    <message>
        <source>Researcher</source>
        <translation>Forsker</translation>
    </message>
    <message>
        <source>You do not take part</source>
        <translation>Du deltar ikke</translation>
    </message>
    <message>
        <source>You need not say why. Please tell the researcher that you have decided.</source>
        <translation>Du trenger ikke å si hvorfor. Si fra til forskeren at du har bestemt deg.</translation>
    </message>
    <message>
        <source>You have left the study</source>
        <translation>Du har forlatt studien</translation>
    </message>
    <message>
        <source>You need not say why. Please tell the researcher.</source>
        <translation>Du trenger ikke å si hvorfor. Si fra til forskeren.</translation>
    </message>
</context>
<context>
    <name>study::gui::PointItem</name>
    <message>
        <source>%1: %2%3 of %4, from %5 to %6</source>
        <translation>%1: %2%3 av %4, fra %5 til %6</translation>
    </message>
</context>
<context>
    <name>study::gui::QuestionnairePage</name>
    <message>
        <source>You may leave this out.</source>
        <translation>Dette kan du hoppe over.</translation>
    </message>
</context>
<context>
    <name>study::gui::ScreenLock</name>
    <message>
        <source>Only for the researcher: the PIN, please.</source>
        <translation>Bare for forskeren: PIN-koden, takk.</translation>
    </message>
    <message>
        <source>PIN of the researcher</source>
        <translation>Forskerens PIN-kode</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Tilbake</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Åpne</translation>
    </message>
    <message>
        <source>That is not the PIN. Please wait %1 s.</source>
        <translation>Det er ikke PIN-koden. Vent i %1 s.</translation>
    </message>
    <message>
        <source>That is not the PIN.</source>
        <translation>Det er ikke PIN-koden.</translation>
    </message>
</context>
<context>
    <name>study::gui::SliderItem</name>
    <message>
        <source>%1: from %2 to %3</source>
        <translation>%1: fra %2 til %3</translation>
    </message>
</context>
</TS>
