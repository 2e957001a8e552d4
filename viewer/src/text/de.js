// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Alle Wörter der Wiedergabe auf Deutsch, für Seiten, die sie übergeben (web/src/text/de.js).

import { grouped } from "./en.js";

const ballsShown = ({ count, of }) => of > count
  ? `${grouped(count)} von ${grouped(of)} Kugeln (${Math.round(of / count) > 1
    ? `jede ${Math.round(of / count)}. wird gezeigt` : "nicht alle werden gezeigt"})`
  : `${grouped(count)} ${count === 1 ? "Kugel" : "Kugeln"}`;
const carriers = { disc: { name: "Scheibe", about: "im Bezugssystem der Scheibe, das mit ihr um die Achse der Mühle dreht" } };

export const de = {
  replay: (title) => `Wiedergabe: ${title}`,
  picture: (title) => `Kugeln im bewegten Becher: ${title}. Ziehen dreht, Umschalttaste und Ziehen verschiebt, Rad oder zwei ` +
    "Finger vergrößern. Tasten: Leertaste spielt oder hält an, Pfeile gehen einen Schritt, v wechselt die Ansicht, c die " +
    "Farben, h zeigt oder verbirgt Stöße, Plus und Minus vergrößern, Umschalttaste und Pfeile drehen.",
  keys: [" Ziehen dreht, ", "Leertaste", " spielt, ", "\u2190", " ", "\u2192", " Schritt, ", "v", " Ansicht, ", "c",
    " Farbe, ", "h", " Stöße. Ein Klick wählt eine Kugel, ", "b", " die nächste."],

  play: "Abspielen",
  pause: "Anhalten",
  back: "Ein Bild zurück",
  forward: "Ein Bild vor",
  time: "Zeit",
  simulatedTime: "Simulierte Zeit",
  pace: "Tempo",
  paceLabel: "Tempo der Wiedergabe",
  paceAbout: "Simulierte Zeit je wirklicher Zeit",
  loop: "Endlos",
  realTime: (factor) => `${factor}x Echtzeit`,

  view: "Ansicht",
  views: {
    laboratory: { name: "Labor", about: "im Bezugssystem des Labors" },
    centre: { name: "Bechermitte", about: "im Bezugssystem der Bechermitte, nicht drehend" },
    fixed: { name: "Becher fest", about: "im Bezugssystem des Bechers, mit ihm drehend" },
  },
  carrier: (name) => carriers[name] ?? { name: name[0].toUpperCase() + name.slice(1),
    about: `im Bezugssystem von „${name}“, das mit ihm um die Achse der Mühle dreht` },

  colour: "Farbe",
  colours: {
    speed: { name: "Geschw.", about: "Geschwindigkeit gegen die Bechermitte",
      scale: (unit) => `Geschwindigkeit gegen die Bechermitte (${unit})` },
    spin: { name: "Drehung", about: "Winkelgeschwindigkeit der Kugel um ihre Mitte",
      scale: (unit) => `Winkelgeschwindigkeit (${unit})` },
    energy: { name: "Energie", about: "Bewegungsenergie der Verschiebung, aus der Geschwindigkeit gegen die Bechermitte; ohne " +
      "die Energie der Drehung", scale: (unit) => `Bewegungsenergie der Verschiebung (${unit})` },
    species: { name: "Sorte", about: "Eine Farbe für jede Sorte Kugeln" },
  },

  hits: "Stöße",
  hitsAbout: "Die stärksten Stöße aufleuchten lassen. Ein größerer, röterer Ring hat mehr Stoßenergie (normal)",
  hitsScale: "Stöße, Stoßenergie",

  camera: "Kamera",
  directions: {
    start: { name: "Anfang", about: "Ansicht am Anfang" },
    axis: { name: "Längs", about: "Blick entlang der Achse des Bechers" },
    side: { name: "Seite", about: "Blick von der Seite" },
  },

  save: "Speichern",
  savePicture: "Bild",
  savePictureAbout: "Dieses Bild als PNG speichern, in doppelter Auflösung",
  saveVideo: "Video",
  saveVideoAbout: "Die ganze Wiedergabe als Video speichern",
  stop: "Stopp",
  recording: (seconds) => `Aufnahme: Die Wiedergabe läuft einmal, ${seconds} s. Lassen Sie die Seite sichtbar.`,
  videoFailed: (why) => `Das Video konnte nicht aufgenommen werden: ${why}.`,
  recorderStopped: "die Aufnahme wurde beendet",
  noRecorder: "Dieser Browser kann keine Videos aufnehmen",
  noFrames: "der Browser nahm kein Bild auf; eine langsamere Wiedergabe kann helfen",
  noVideoFormat: "Dieser Browser kann in keinem Videoformat aufnehmen",

  caption: (data, from, to, view) => `${ballsShown(data)}, ${data.frames > 1
    ? `${grouped(data.frames)} Bilder von ${from} bis ${to}` : `ein Bild bei ${from}`}, ${view}.`,
  picked: ({ number, body, kind }) => `${body ? "Teilkugel" : "Kugel"} ${grouped(number)}${kind ? `, ${kind}` : ""}`,
  hitsOf: (count, span) => `${grouped(count)} ${count === 1 ? "Stoß" : "Stöße"} in ${span}`,
  weight: "g",

  noWebGL: "Die Wiedergabe braucht WebGL 2, das dieser Browser nicht kann oder abgeschaltet hat. Alle Zahlen sind auch ohne " +
    "sie vollständig.",
  dataFault: (what) => `Die Daten der Wiedergabe können nicht gezeigt werden: ${what}; schreiben Sie den Bericht neu, mit der ` +
    "Version von mahlwerk, die diese Seite geschrieben hat.",
  dataFaults: {
    missing: (name) => `"${name}" fehlt`,
    notBase64: (name) => `"${name}" ist kein base64`,
    length: (name, found, expected) => `"${name}" hat ${found} Bytes statt ${expected}`,
    multiple: (name, found, size) => `"${name}" hat ${found} Bytes, kein Vielfaches von ${size}`,
    notPositive: (name, value) => `"${name}" muss über 0 sein, nicht ${value}`,
    corners: (name) => `"${name}.triangles" nennt eine Ecke, die "${name}.vertices" nicht enthält`,
    bodies: (name, count, first, spheres) =>
      `"${name}" hat ${count} Körper ab der Kugel ${first}, von ${spheres} Kugeln`,
    noTimes: () => '"times" fehlt oder ist leer',
    times: () => 'die Zahlen in "times" müssen wachsen',
    notJson: (why) => `sie sind kein JSON (${why})`,
    version: (found) => `sie haben die Version ${found}, aber diese Seite liest die Version 1`,
    count: (found) => `"count" muss eine ganze Zahl sein, nicht ${found}`,
  },
};
