// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Alle Wörter der Seite auf Deutsch. Zahlen haben wie in den Schlüsseln einen Punkt.

import { de as replayWords } from "../../../viewer/src/text/de.js";

const plain = (key) => key.replaceAll(/[_-]/g, " ");
const seconds = (number) => `${number < 10 ? number.toPrecision(2) : Math.round(number)} s`;

/// Namen von Bauarten, Rechenkernen und anderen Wörtern, die ein Fall enthalten kann.
const words = {
  auto: "vom Programm gewählt", event: "ereignisgesteuert", soft: "DEM (Kontaktkräfte)",
  still: "In Ruhe", vibration: "Schwingender Becher", planetary: "Planetenkugelmühle", tumbling: "Drehende Trommel",
  "arc-shaker": "Schwingmühle (Bogen)", "figure-eight": "Schüttelmühle (Acht)",
  circular: "Kreisbewegung", capsule: "Kapsel (Halbkugeln)", cylinder: "Zylinder",
  "rounded-cylinder": "Zylinder, Kanten gerundet", sphere: "Kugel", box: "Quader", "lifter-cylinder": "Zylinder mit Hubleisten",
  none: "keine", equal: "alle gleich",
};

const exampleCases = {
  "vibrating-vial": { name: "Schwingender Becher (Chen et al. 2016)",
    hint: "Eine Kugel springt in einer geschüttelten Kapsel. Versuchen Sie 14 Hz: Wächst die Leistung mit der dritten Potenz?" },
  "mixer-mill": { name: "Retsch MM 400",
    hint: "Zwei Kugeln in einem Becher, der auf einem Bogen schwingt. Vergleichen Sie die Spektren von einer und zwei Kugeln." },
  "planetary-mill": { name: "Fritsch Pulverisette 7 (Planetenkugelmühle)",
    hint: "Sieben Kugeln in einer Planetenkugelmühle. Versuchen Sie eine Reihe der Drehzahl von 200 bis 800 rpm." },
  "tumbling-drum": { name: "Trommelmühle",
    hint: "Kugeln steigen an der Wand und fallen. Versuchen Sie 100 % der kritischen Drehzahl: Die Kugeln bleiben an der Wand." },
  "shaker-mill": { name: "SPEX 8000M",
    hint: "Große und kleine Kugeln auf einer Acht. Versuchen Sie es ohne die kleinen: Welche Stöße fallen weg?" },
  quartz: { name: "Wie fein Quarz wird",
    hint: "Von den Stößen zu den Korngrößen nach einer Stunde Mahlen. Versuchen Sie 300 rpm, und sehen Sie sich das Pulver an." },
};

/// Lektionen, in der Reihenfolge von learn/lessons.js, wo die richtigen Antworten stehen.
const lessons = [
  { title: "Was ist ein Stoß wert?",
    intro: "Ein Becher schwingt zehnmal in der Sekunde, und eine Kugel springt zwischen seinen Enden. Jeder Stoß macht einen " +
      "Teil ihrer Energie zu Wärme oder zu gebrochenen Körnern. Die Leistung ist die Summe dieser Teile je Sekunde.",
    task: "Rechnen Sie mit drei Frequenzen. Achten Sie auf die Leistung und die Zahl der Stöße.", varied: "Frequenz",
    question: "Die Frequenz steigt von 10 auf 20 Hz, die Amplitude bleibt. Was geschieht mit der Leistung?",
    answers: [
      ["Sie verdoppelt sich.", "Die Zahl der Stöße je Sekunde tut das. Aber jeder Stoß ist auch härter: Die Wand ist doppelt " +
        "so schnell."],
      ["Sie wird viermal so groß.", "Die Energie eines Stoßes wird es: Die Geschwindigkeit verdoppelt sich, und die Energie " +
        "wächst mit ihrem Quadrat. Aber es gibt auch doppelt so viele Stöße."],
      ["Sie wird achtmal so groß.", "Doppelt so viele Stöße, jeder mit der vierfachen Energie: 2 × 4 = 8, die dritte Potenz von " +
        "2. Die Wand erreicht 2π × Frequenz × Amplitude, und die Energie wächst mit dem Quadrat der Geschwindigkeit."],
      ["Sie bleibt: Es ist dieselbe Kugel.", "Die Kugel ist dieselbe, aber die Wand, die sie antreibt, ist schneller."]],
    conclusion: "Von 10 auf 20 Hz: 2.1-mal so viele Stöße, 3.9-mal die Energie eines Stoßes, 8-mal die Leistung." },
  { title: "Warum mahlt eine höhere Drehzahl weniger?",
    intro: "Sechs Kugeln in einer drehenden Trommel: Hubleisten heben sie an, dann fallen sie. Bei der kritischen Drehzahl ist " +
      "die Fliehkraft an der Wand so groß wie das Gewicht.",
    task: "Rechnen Sie unter und über der kritischen Drehzahl. Sehen Sie den Kugeln zu.",
    varied: "Drehzahl, Teil der kritischen",
    question: "Die Trommel dreht mit 125 % statt 75 % der kritischen Drehzahl. Was geschieht mit den Stößen?",
    answers: [
      ["Sie werden härter: Die Trommel ist schneller.", "Es zählt die Geschwindigkeit der Kugel gegen das, was sie trifft. Eine " +
        "Kugel, die mit der Wand umläuft, trifft sie nicht."],
      ["Sie werden schwächer: Die Kugeln laufen mit der Wand um.", "Über der kritischen Drehzahl ist die Fliehkraft selbst oben " +
        "größer als das Gewicht: Die Kugeln fallen nicht mehr. Es bleibt ein Klappern zwischen den Hubleisten."],
      ["Sie bleiben: Die Fallhöhe ist dieselbe.", "Eine Kugel fällt, wo ihr Gewicht sie von der Wand zieht. Über der kritischen " +
        "Drehzahl ist das nirgends."],
      ["Es gibt keine mehr.", "Eine einzelne Kugel, die nie rutscht, träfe nichts. Hier klappern Kugeln noch zwischen den " +
        "Hubleisten, aber schwach."]],
    conclusion: "Bei 125 % hat ein Stoß ein Drittel der Energie wie bei 75 %, und auch die Leistung ist ein Drittel. Trommelmühlen " +
      "drehen deshalb mit etwa 65 bis 80 % der kritischen Drehzahl." },
  { title: "Wenige große oder viele kleine Kugeln?",
    intro: "Im Becher einer Planetenkugelmühle sind 96 g Stahl: sieben Kugeln von 15 mm oder, mit fast derselben Masse, 24 Kugeln " +
      "von 10 mm.",
    task: "Rechnen Sie beides, und vergleichen Sie die Spektren: Wie viele Stöße gibt es, wie hart sind sie?", varied: "Kugeln",
    question: "24 kleine Kugeln ersetzen die sieben großen. Was geschieht mit den Stößen?",
    answers: [
      ["Weniger, und jeder ist härter.", "Es ist umgekehrt: Eine kleine Kugel ist leichter und trifft öfter auf andere."],
      ["Mehr, und jeder ist schwächer.", "Eine Kugel von 10 mm hat das 0.3-Fache der Masse einer von 15 mm, und mehr Kugeln " +
        "treffen sich öfter: Dieselbe Leistung verteilt sich auf mehr Stöße."],
      ["Mehr, und jeder ist gleich hart: Die Drehzahl ist dieselbe.", "Die Geschwindigkeiten sind ähnlich, aber die Energie eines " +
        "Stoßes ist ½ m v², und die Masse m einer Kugel ist nur das 0.3-Fache."],
      ["Wie vorher: Die Masse ist dieselbe.", "Die Masse aller Kugeln bestimmt ungefähr, wie viel Leistung sie aufnehmen. Ihre " +
        "Zahl bestimmt, auf wie viele Stöße sie sich verteilt."]],
    conclusion: "Etwa sechsmal so viele Stöße, jeder mit etwa einem Siebtel der Energie. Grobe und feste Körner brauchen harte " +
      "Stöße, also größere Kugeln; feines Pulver braucht viele Stöße, also kleinere." },
  { title: "Bewirken mehr Kugeln mehr?",
    intro: "Dieser Becher ist innen 48 mm lang, eine Kugel 8 mm breit. Mehr Kugeln stoßen öfter, aber sie nehmen den anderen den " +
      "Raum zum Fliegen.",
    task: "Rechnen Sie mit einer, zwei, vier und sechs Kugeln.", varied: "Zahl der Kugeln",
    question: "Sechs Kugeln statt einer: Wie groß ist die Leistung aller sechs zusammen?",
    answers: [
      ["Sechsmal die einer Kugel.", "Dazu müsste jede so frei fliegen wie eine einzelne. Aber sie stoßen vorher aneinander, mit " +
        "kleinerer Geschwindigkeit."],
      ["Größer als die einer Kugel, aber nicht sechsmal.", "Das stimmt bis zu vier Kugeln. Sechs sind, im Zickzack übereinander, " +
        "43 mm lang: Es bleibt zu wenig Raum."],
      ["Kleiner als die einer Kugel.", "Sechs Kugeln füllen den Becher fast von Ende zu Ende. Sie fahren mit ihm mit und berühren " +
        "einander und die Wände nur langsam."],
      ["Gleich: Der Becher bestimmt sie.", "Der Becher gibt die Bewegung vor, aber was die Kugeln aufnehmen, hängt von ihren " +
        "Stoßgeschwindigkeiten ab."]],
    conclusion: "Die Leistung ist bei einer mittleren Füllung am größten, hier um vier Kugeln. Die Energie eines Stoßes ist " +
      "umso kleiner, je mehr Kugeln es sind." },
  { title: "Welchen Zahlen kann man trauen?",
    intro: "Die Zahl hinter ± ist ein 95-%-Intervall: So weit kann der Mittelwert dieser Rechnung von dem einer endlosen " +
      "entfernt sein. Hier werden zwei kurze Rechnungen verglichen.",
    task: "Rechnen Sie 2 s mit 10 Hz und mit 11 Hz. Sehen Sie sich die Intervalle der Leistung an, dann längere Rechnungen.",
    varied: "Frequenz, Zeit, Stoßzahl e",
    question: "2 s mit 10 Hz ergeben 40 ± 7 mW, 2 s mit 11 Hz ergeben 51 ± 15 mW. Was sagen diese beiden Rechnungen?",
    answers: [
      ["11 Hz hat mehr Leistung: 51 ist mehr als 40.", "Das kann sein. Aber die Intervalle überlappen: In so kurzen Rechnungen " +
        "entsteht ein solcher Unterschied auch durch Zufall."],
      ["Die Leistung ist gleich: Die Intervalle überlappen.", "Überlappen beweist keine Gleichheit. Es heißt, dass diese Rechnungen " +
        "nicht entscheiden können."],
      ["Nicht genug; längere Rechnungen können entscheiden.", "Die vierfache simulierte Zeit halbiert ein Intervall. Nach 200 s " +
        "überlappen die Intervalle nicht mehr."],
      ["Nichts: Simulationen kann man nicht trauen.", "Ein Intervall sagt, wie weit der Zufall reicht, und so weit kann man ihm " +
        "trauen. Zwei Einstellungen einer Mühle kann man auch vergleichen, wenn manche Werte nie gemessen wurden."]],
    conclusion: "Lange Rechnungen unterscheiden die Frequenzen. Aber Intervalle enthalten nur den Zufall: Die Stoßzahl 0.9 ist " +
      "angenommen, und mit 0.8 gibt es nur ein Drittel der Stöße, weit außerhalb des Intervalls. Doch 11 Hz hat mit beiden das " +
      "1.3-Fache der Leistung von 10 Hz: Unterschiede zwischen Einstellungen sind verlässlicher als einzelne Zahlen." },
];

const sections = { mill: "Mühle", jar: "Mahlbecher", balls: "Mahlkugeln", powder: "Pulver", contact: "Kontakt",
  run: "Rechnung", drive: "Motor der Mühle", flow: "Durchfluss" };
const counters = { collisions: "Stöße berechnet", simulated: "Zeit simuliert",
  power: "Dissipierte Leistung", rate: "Stöße über der Schwelle" };
const severities = { invalid: "Außerhalb der Gültigkeit:", warning: "Warnung:", note: "Hinweis:" };
const verdicts = { apart: "verschieden", overlap: "vielleicht gleich", unknown: "ohne Intervall" };

const quantityNames = {
  dissipated_power: "Dissipierte Leistung", collision_rate: "Stoßrate", drawn_power: "Aufgenommene Leistung",
  collision_rate_above_threshold: "Stoßrate über der Schwelle", collision_rate_in_flight: "Stoßrate im Flug",
  energy_normal_mean: "Mittlere Stoßenergie, normal",
  energy_normal_mean_above_threshold: "Mittlere Stoßenergie über der Schwelle, normal",
  energy_lost_mean: "Mittlerer Energieverlust", impact_speed_normal_mean: "Mittlere Stoßgeschwindigkeit, normal",
  impact_angle_mean: "Mittlerer Stoßwinkel", impact_efficiency: "Wirkungsgrad der Stöße",
  contact_time_share: "Zeitanteil in Kontakt", impacts_per_ball: "Stöße je Kugel",
  impacts_per_ball_above_threshold: "Stöße je Kugel über der Schwelle", ball_count: "Zahl der Kugeln",
  balls_mass: "Masse der Kugeln", simulated_time: "Simulierte Zeit", settling_time: "Einschwingzeit", replicates: "Wiederholungen",
  specific_energy_dose_rate: "Dosisleistung je Pulvermasse", specific_energy_dose: "Dosis (Energie je Pulvermasse)",
  specific_energy_dose_per_hour: "Dosis je Stunde", time_to_dose: "Zeit bis zur Dosis", milling_time: "Mahldauer",
  specific_impact_power: "Stoßleistung je Pulvermasse", d10: "D10", d50: "D50", d90: "D90", conversion: "Umsatz",
};
const groupNames = { Collisions: "Stöße", "Power and contacts": "Leistung und Kontakte", "Power of the mill": "Leistung der Mühle",
  "Motion of the charge": "Bewegung der Füllung", "Numerical accuracy": "Numerische Genauigkeit", Fineness: "Feinheit",
  "Energy per mass of powder": "Energie je Pulvermasse", Dose: "Dosis", Wear: "Verschleiß", Temperatures: "Temperaturen",
  Drive: "Antrieb", Flow: "Durchfluss", Mixing: "Mischung", "Powder captured by collisions": "Von Stößen erfasstes Pulver" };
const keyNames = {
  frequency: "Frequenz", amplitude: "Amplitude", speed: "Drehzahl", ratio: "Drehzahlverhältnis", tilt: "Neigung",
  jar_axis: "Achse des Bechers", jars_carried: "Becher in der Mühle", orbit_radius: "Bahnradius", arm: "Armlänge",
  swing: "Ausschlag zu jeder Seite", ratio_convention: "Bezug des Verhältnisses", radius: "Radius",
  diameter: "Durchmesser", height: "Höhe", volume: "Volumen", length: "Länge", width: "Breite", depth: "Tiefe",
  fillet: "Kantenradius", wall: "Wanddicke", lifters: "Hubleisten", lifter_height: "Höhe der Hubleisten",
  lifter_width: "Breite der Hubleisten", count: "Zahl der Kugeln", filling: "Füllgrad (Feststoff)", bulk_filling: "Füllgrad (Schüttung)",
  mass: "Masse", density: "Dichte", material: "Werkstoff", shape: "Form", distribution: "Verteilung", size: "Korngröße",
  spread: "Streuung", ball_to_powder: "Kugeln zu Pulver", void_filling: "Füllgrad der Zwischenräume",
  law: "Kontaktgesetz", restitution: "Stoßzahl", tangential_restitution: "Tangentiale Stoßzahl", friction: "Reibungszahl",
  rolling_friction: "Rollreibung", lasting: "Dauerkontakte", contact_time: "Kontaktzeit", softening: "Erweichung",
  youngs_modulus: "Elastizitätsmodul", poisson_ratio: "Querkontraktionszahl", hardness: "Härte",
  engine: "Rechenverfahren", time: "Simulierte Zeit", settle: "Einschwingen, nicht gezählt", replicates: "Wiederholungen",
  start: "Anfang", time_step: "Zeitschritt", sensitivity: "Empfindlichkeit", motor: "Motor", inertia: "Trägheitsmoment",
  torque: "Drehmoment",
};

const estimate = {
  mill: { label: "Mühle", remedy: "Wählen Sie eine der Liste" },
  jar: { label: "Mahlbecher", remedy: "Wählen Sie einen der Liste" },
  material: { label: "Werkstoff (Kugeln, Becher)" },
  balls: { label: "Mahlkugeln", hint: "oder 50 g x 3 mm",
    remedy: "Schreiben Sie Zahl und Durchmesser, 2x10mm, oder 50 g x 3 mm, oder 30 % x 5 mm (des Bechervolumens); zwischen zwei " +
      "Sorten steht ein Komma" },
  drive: { label: "Frequenz" },
  powder: { label: "Pulver", hint: "oder Kugeln zu Pulver, 10:1",
    remedy: "Schreiben Sie eine Masse, 200 mg, oder die Masse der Kugeln zu der des Pulvers, 10:1" },
  time: { label: "Mahldauer", remedy: "Füllen Sie das Pulver aus, oder lassen Sie die Zeit leer" },
};
const sentence = (words) => (words === "" ? "" : `${words[0].toUpperCase()}${words.slice(1).replace(/[.]$/, "")}.`);

function status(run) {
  if (!run) return "Bereit.";
  const sum = seconds(run.sum("simulated") || 0);
  const of = run.replicates.length === 1 ? "" : ` in ${run.replicates.length} Wiederholungen`;
  if (run.status === "done" && run.endedEarly())
    return `Vorzeitig beendet: ${sum} simuliert${of}; die Meldungen sagen, warum.`;
  if (run.status === "done") return `Fertig: ${sum} simuliert${of}, gerechnet in ${seconds(run.seconds)}.`;
  if (run.status === "stopped") return `Gestoppt: ${sum} simuliert, das Ergebnis enthält, was gerechnet wurde.`;
  if (run.status === "failed") return `Die Rechnung ist fehlgeschlagen: ${run.message}`;
  const percent = `${Math.floor(100 * run.share())} %`;
  if (run.status === "paused") return `Angehalten bei ${percent}.`;
  if (run.status === "stopping") return "Wird gestoppt …";
  if (run.status === "merging") return "Wiederholungen werden zusammengefasst …";
  return `Rechnet${of}: ${percent}, ${sum} simuliert.`;
}

export const text = {
  language: "de",
  shortName: "DE",
  languageName: "Deutsch",
  languageChoice: "Sprache",
  quantityNames,
  groupNames,
  keyNames,
  numbers: { to: "bis", infinite: "unendlich" },
  name: "Mahlwerk",
  tagline: "Was in einer Kugelmühle geschieht",
  skip: "Zu den Ergebnissen springen",
  loading: "Der Simulator wird geladen …",
  loadFailed: (why) => `Der Simulator konnte nicht geladen werden: ${why}`,
  version: (version) => `Mahlwerk ${version}`,
  englishParts: "Meldungen, Bedeutungen und Berichte des Programms sind englisch.",
  footer: "Alles wird auf diesem Gerät gerechnet; nichts wird gesendet. Freie Software, Apache-Lizenz 2.0.",
  licences: "Lizenzen",
  toDark: "Dunkel",
  toLight: "Hell",
  themeAbout: "Zwischen dunkel und hell wechseln",

  estimate: "Abschätzen",
  estimateHeading: "Abschätzung einer Mühle",
  estimateAbout: "Schreibt den Fall, zeigt ihn unten und rechnet ihn. Angenommene Werte stehen unter „Zu diesen Zahlen“; " +
    "Bänder über diese Werte rechnet mahlwerk estimate in der Befehlszeile.",
  estimateWord: (word) => estimate[word].label,
  estimateHint: (word) => estimate[word].hint ?? "",
  estimateDrive: (key) => (key === "speed" ? "Drehzahl" : "Frequenz"),
  estimateRange: ({ least, most, fixed }) => fixed ? `leer: ${fixed}, die der Mühle`
    : !most ? "" : least ? `${least} bis ${most}` : `bis ${most}`,
  estimateFault: (kind, word, fault) => kind === "missing" ? "Füllen Sie dieses Feld aus."
    : `${sentence(fault.text)} ${sentence(kind === "written" ? estimate[word].remedy : fault.remedy)}`.trim(),

  exampleCases,
  example: "Beginnen mit",
  ownCase: "Eigener Fall",
  caseHeading: "Fall",
  form: "Formular",
  caseText: "Fall als Text (TOML)",
  caseTab: "Text",
  resultHeading: "Ergebnis",
  runHeading: "Rechnung",
  regions: "Gezeigter Teil",
  replay: "Kugeln im bewegten Becher",
  replayWords,

  learn: "Lernen",
  learnAbout: "Fünf Lektionen mit Fragen",
  learnIntro: "Jede Lektion stellt eine Frage. Raten Sie, und lassen Sie die Seite die Antwort rechnen.",
  learnClose: "Lektionen schließen",
  lessons,
  lessonName: (number, title) => `Lektion ${number}: ${title}`,
  lessonDone: "beantwortet",
  lessonTry: "Rechnen mit",
  lessonQuestion: "Frage",
  lessonRight: "Richtig.",
  lessonWrong: "Nicht ganz.",
  lessonCheck: "Selbst prüfen",
  lessonCheckAbout: "Rechnet die Fälle dieser Lektion, mit ihren 95-%-Intervallen.",
  lessonStatus: (at, count) => `Rechnet Fall ${at} von ${count} …`,
  lessonResult: "Was die Fälle zeigen",
  lessonNext: "Nächste Lektion",
  section: (name) => sections[name] ?? plain(name),
  ballSet: (number) => `Mahlkugeln, Sorte ${number}`,
  part: (name) => `Bauteil: ${name}`,
  addBalls: "Weitere Sorte Kugeln",
  remove: "Entfernen",
  word: (word) => words[word] ?? plain(word),
  kind: (kind) => words[kind] ?? plain(kind),
  model: (where) => (where === "mill" ? "Mühle" : "Mahlbecher"),
  byItsNumbers: "Nach ihren Zahlen",
  fromCatalogue: "Aus dem Katalog",
  containsUnverified: "enthält ungeprüfte Werte",
  unitOf: (label) => `Einheit: ${label}`,
  sliderOf: (label) => `Regler: ${label}`,
  automatic: "auto",
  lineNumber: (line) => `Zeile ${line}`,
  remedy: (remedy) => `Abhilfe: ${remedy}`,
  faultsFirst: "Der Fall hat einen Fehler; beheben Sie ihn zuerst.",
  faultCount: (count) => (count === 1 ? "Der Fall hat einen Fehler:" : `Der Fall hat ${count} Fehler. Der erste:`),
  showFaults: "Zeigen",

  run: "Rechnen",
  pause: "Pause",
  resume: "Weiter",
  stop: "Stopp",
  progress: "Fortschritt der Rechnung",
  status,
  changed: "Der Fall ist seit diesem Ergebnis geändert worden.",
  sweeping: "Eine Reihe wird gerechnet.",
  counter: (key) => counters[key],

  share: "Teilen",
  shareAbout: "Einen Link kopieren, der den ganzen Fall enthält",
  shared: "Link kopiert. Er enthält den ganzen Fall; nichts wurde gesendet.",
  sharedAddress: "Die Adresse dieser Seite enthält jetzt den ganzen Fall: Kopieren Sie sie dort.",
  badLink: "Dieser Link enthält keinen lesbaren Fall; stattdessen wird das erste Beispiel gezeigt.",
  badLinkLater: "Die Adresse enthält keinen lesbaren Fall; der gezeigte bleibt.",
  keptCase: "Ihr Fall, wie Sie ihn verlassen haben. „Rechnen“ startet ihn.",
  leaveChanges: "Ihre Änderungen am Fall verlassen? „Zurück“ im Browser bringt sie wieder.",
  fromLink: "Dieser Fall kam mit dem Link. „Rechnen“ startet ihn.",

  spectrum: "Spektrum der Stöße",
  spectrumOf: "Spektrum von",
  rate: "Rate",
  power: "Leistung",
  spectrumRateAbout: "Stöße je Sekunde über ihrer Stoßenergie",
  spectrumPowerAbout: "Stoßleistung über der Stoßenergie",
  spectrumAbout: (peak) => `Am höchsten nahe ${peak}.`,
  impactEnergy: "Stoßenergie, normal",
  rateAxis: "Rate je Oktave, 1/s",
  powerPerOctave: "Leistung je Oktave",
  powerAxis: "Leistung",
  thisRun: "diese Rechnung",
  powerOverTime: "Leistung über der Zeit",
  timeAxis: "Simulierte Zeit, s",
  dissipated: "dissipiert",
  meanSoFar: "Mittel bisher",

  details: "Einzelheiten des Ergebnisses",
  quantities: "Größen",
  quantityColumns: ["Größe", "Wert ± 95-%-Intervall", "Bedeutung"],
  noMillingTime: "keine Mahldauer angegeben",
  preliminary: "Vorläufig: Die Rechnung läuft, und die Intervalle werden noch enger.",
  noResult: "Noch kein Ergebnis: „Rechnen“ drücken.",
  noCurve: "Noch nichts zu zeichnen.",

  comparison: "Vergleich",
  keepAsA: "Dieses Ergebnis als A behalten",
  forgetA: "A vergessen",
  restoreA: "Zurück zum Fall von A",
  compareHint: "Behalten Sie ein Ergebnis als A, ändern Sie den Fall und rechnen Sie: Beide stehen hier nebeneinander.",
  compareRunB: (title) => `A ist „${title}“. Ändern Sie nun den Fall und rechnen Sie: Das nächste Ergebnis ist B.`,
  compareAbout: (a, b) => `A ist „${a}“, B ist „${b}“. „Verschieden“ heißt, dass die 95-%-Intervalle nicht überlappen.`,
  differences: (list) => (list.length === 0 ? " Beide Fälle sind gleich."
    : ` Geändert: ${list.map(([key, a, b]) => `${key} von ${a ?? "der Vorgabe"} auf ${b ?? "die Vorgabe"}`)
      .join(", ")}.`),
  compareColumns: ["Größe", "A", "B", "Änderung", "Intervalle"],
  verdict: (verdict) => verdicts[verdict],

  sweep: "Reihe",
  sweepAbout: "Rechnet den Fall mit mehreren Werten eines Schlüssels, einen nach dem anderen.",
  sweepKey: "Schlüssel",
  sweepFrom: "Von",
  sweepTo: "Bis",
  sweepCount: "Zahl der Werte",
  sweepSpacing: "Abstände",
  spacings: [["lin", "gleiche Schritte"], ["log", "gleiche Verhältnisse"]],
  sweepQuantity: "Größe",
  sweepCurve: "Kurve der Reihe",
  runSweep: "Reihe rechnen",
  saveSweep: "sweep.csv speichern",
  sweepWaits: "Eine Rechnung läuft; stoppen Sie sie, oder warten Sie ihr Ende ab.",
  sweepFault: "Von und Bis müssen Zahlen sein, bei gleichen Verhältnissen beide über 0.",
  sweepStatus: (state, at, count) => state === "done" ? `Fertig: ${count} Werte.`
    : state === "stopped" ? `Gestoppt nach ${at} von ${count} Werten.`
      : `Rechnet Wert ${Math.min(at + 1, count)} von ${count}.`,

  report: "Alle Bilder",
  noReport: "Der Bericht einer Rechnung mit allen Bildern und Karten erscheint hier, wenn sie beendet ist.",

  about: "Zu diesen Zahlen",
  trust: "Die Intervalle enthalten nur die Streuung der Simulation: Längere Rechnungen machen sie enger. Sie enthalten keine " +
    "Fehler des Modells und keine von Werten, die niemand gemessen hat. Unterschiede zwischen zwei Einstellungen einer Mühle " +
    "sind verlässlicher als einzelne Zahlen.",
  noticesInFull: (count) => (count === 1 ? "Diese Meldung ganz" : `${count} Meldungen ganz`),
  replicateStopped: (number, reason) => `Wiederholung ${number} wurde abgebrochen: ${reason}`,
  noNotices: "Das Programm hat keine Meldungen zu diesem Fall.",
  severity: (severity) => severities[severity] ?? `${severity}:`,
  guessed: "Angenommen und nicht kalibriert:",
  assumed: "Angenommene Werte",
  assumedAbout: "Der Fall nennt diese Werte nicht; das Programm nahm seine Vorgaben.",
  unverified: "Ungeprüfte Werte",
  unverifiedAbout: "Werte des Katalogs, deren Quelle schwach ist oder die niemand geprüft hat.",
  originColumns: ["Schlüssel", "Wert", "Quelle"],
  repeat: "Diese Rechnung mit dem Programm wiederholen",
  repeatAbout: "Speichern Sie den Fall als case.toml. Dieselbe Version des Programms gibt dieselben Zahlen:",
  copy: "Kopieren",
  copied: "Kopiert",
  downloadCase: "case.toml speichern",

  files: "Dateien",
  filesAbout: "Dateien dieses Ergebnisses.",
  filesHint: "Die Dateien eines Ergebnisses erscheinen hier, wenn eine Rechnung beendet ist.",
  openResult: "Ergebnis oder Fall öffnen",
  openAbout: "Ergebnisse des Programms: Wählen Sie summary.json und was daneben liegt, oder ziehen Sie den Ordner auf die Seite. " +
    "Auch die Seite einer Kampagne, einer Anpassung oder einer Suche (campaign.html, ...) wird gezeigt.",
  opened: (title) => `Geöffnet: ${title}.`,
  openedStudy: "Geöffnet: die Seite einer Studie, unten bei „Alle Bilder“.",
  openedCase: "Dieser Fall kam aus einer Datei. „Rechnen“ startet ihn.",
  nothingToOpen: "Unter diesen Dateien ist weder eine summary.json noch ein Fall (.toml).",
  cannotOpen: (why) => `Dieses Ergebnis kann nicht gezeigt werden: ${why}`,

  // Arbeiten
  follow: "Änderungen sofort rechnen",
  followAbout: "Ein geänderter Fall tritt an die Stelle dessen, der gerechnet wird. Nach einem Ergebnis, das höchstens 30 s gebraucht hat, " +
    "startet eine Änderung auch die nächste Rechnung. Nach „Anhalten“ oder „Abbrechen“ startet nichts von selbst",

  history: "Verlauf",
  historyAbout: "Ergebnisse dieser Sitzung, das neueste zuerst, höchstens 20. Sie verschwinden mit der Seite, wenn Sie sie nicht " +
    "speichern: Gespeicherte bleiben in diesem Browser, auf diesem Gerät.",
  historyDenied: "Ergebnisse dieser Sitzung, das neueste zuerst, höchstens 20. In diesem Browser darf die Seite nichts behalten: Sie " +
    "verschwinden mit der Seite. Laden Sie herunter, was Sie brauchen.",
  nameOfCase: "Name",
  saveThisCase: "Diesen Fall speichern",
  savedAs: (name) => `Als „${name}“ in diesem Browser gespeichert.`,
  notSaved: (reason) => reason === "full" ? "Nicht gespeichert: In diesem Browser ist kein Platz mehr. Löschen Sie zuerst einen Eintrag."
    : reason === "denied" ? "In diesem Browser darf die Seite nichts behalten: Der Name gilt, bis die Seite geschlossen wird."
      : `Nicht gespeichert: ${reason}`,
  nameOfEntry: "Neuer Name",
  ok: "OK",
  entryAbout: ({ date, saved }) => `${new Date(date).toLocaleString("de-DE", { dateStyle: "medium", timeStyle: "medium" })}, ` +
    (saved ? "gespeichert" : "diese Sitzung"),
  entryChange: (changes) => `Seit dem Ergebnis davor: ${changes.map(([key, to]) => `${key} = ${to ?? "Vorgabe"}`).join(", ")}`,
  entryChoice: ({ name, date, change }) => [name, new Date(date).toLocaleTimeString("de-DE"),
    ...change.slice(0, 2).map(([key, to]) => `${key} = ${to ?? "Vorgabe"}`)].join(", "),
  onlyCase: "Ein Fall ohne Ergebnis.",
  open: "Öffnen",
  openEntry: (name) => `${name} öffnen`,
  openedEntry: "Ihr gespeicherter Fall. „Rechnen“ startet ihn.",
  rename: "Umbenennen",
  renameEntry: (name) => `${name} umbenennen`,
  saveEntry: "Speichern",
  saveEntryAbout: (name) => `${name} unter einem Namen speichern`,
  downloadCaseOf: (name) => `case.toml von ${name} herunterladen`,
  downloadSummaryOf: (name) => `summary.json von ${name} herunterladen`,
  delete: "Löschen",
  deleteEntry: (name) => `${name} löschen`,
  compareGroup: "Als A oder B vergleichen",
  compareAs: (side, name) => `Als ${side} vergleichen: ${name}`,
  noA: "kein Ergebnis",
  newestAsB: "das neueste Ergebnis",

  embed: "Um den Fall in eine andere Seite einzubetten:",
  embedAbout: "Der Rahmen zeigt die bewegten Kugeln, die wichtigsten Zahlen und „Rechnen“; mit #embed&amp;run&amp; statt #embed&amp; rechnet er sofort.",
  openInFull: "Ganze Seite öffnen",
  close: "Schließen",
};
