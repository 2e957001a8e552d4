// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// All words of the page, in English. Another language is another module of the same shape, named in text.js.

import { en as replayWords } from "../../../viewer/src/text/en.js";

const plain = (key) => key.replaceAll(/[_-]/g, " ");
const seconds = (number) => `${number < 10 ? number.toPrecision(2) : Math.round(number)} s`;

/// Of kinds, engines and other words that a case may have; what is not listed is shown as it is written.
const words = {
  auto: "chosen by the program", event: "event engine", soft: "soft engine (contact forces)",
  still: "At rest", vibration: "Vibrating vial", planetary: "Planetary mill", tumbling: "Tumbling drum",
  "arc-shaker": "Mixer mill (arc)", "figure-eight": "Shaker mill (figure of eight)",
  circular: "Circular motion", capsule: "Capsule (half spheres)", cylinder: "Cylinder",
  "rounded-cylinder": "Rounded cylinder", sphere: "Sphere", box: "Box", "lifter-cylinder": "Cylinder with lifters",
  none: "none", equal: "all equal",
};

const exampleCases = {
  "vibrating-vial": { name: "Vibrating vial (Chen et al. 2016)",
    hint: "One ball bounces in a shaken capsule. Try a frequency of 14 Hz: does the power grow as its " +
      "cube?" },
  "mixer-mill": { name: "Retsch MM 400",
    hint: "Two balls in a jar that swings in an arc. Try one ball instead of two, and compare the " +
      "spectra." },
  "planetary-mill": { name: "Fritsch Pulverisette 7 (planetary)",
    hint: "Seven balls in a planetary mill. Try a sweep of the speed from 200 to 800 rpm." },
  "tumbling-drum": { name: "Tumbling drum",
    hint: "Balls climb the wall and fall. Try 100 % of the critical speed, and watch the balls stay on " +
      "the wall." },
  "shaker-mill": { name: "SPEX 8000M",
    hint: "Large and small balls in a figure of eight. Try it without the small balls: which hits " +
      "vanish?" },
  quartz: { name: "How fine quartz gets",
    hint: "From impacts to grain sizes, after an hour of milling. Try 300 rpm, and look at the tab " +
      "Powder." },
};

/// Lessons, in the order of learn/lessons.js, which names the right answers. `varied`: what differs between the cases.
const lessons = [
  { title: "What is a hit worth?",
    intro: "A vial is shaken ten times a second, and one ball bounces between its ends. Every hit turns a part of the " +
      "ball's energy into heat, or into broken grains. The power is the sum of these parts in a second.",
    task: "Run the vial at three frequencies. Watch the power and the number of hits.", varied: "Frequency",
    question: "The frequency doubles from 10 to 20 Hz; the amplitude stays. What happens to the power?",
    answers: [
      ["It doubles.", "The number of hits per second does. But each hit is harder, too: the wall moves twice as fast."],
      ["It grows fourfold.", "The energy of one hit does: the speed doubles, and energy grows as its square. But there are " +
        "also twice as many hits per second."],
      ["It grows eightfold.", "Twice as many hits, each with four times the energy: 2 × 4 = 8, the cube of 2. The wall's " +
        "largest speed is 2π × frequency × amplitude, and energy grows as the square of the speed."],
      ["It stays: the ball is the same.", "The ball is the same, but the wall that drives it is faster."]],
    conclusion: "From 10 to 20 Hz: 2.1 times the hits, 3.9 times the energy of a hit, 8 times the power." },
  { title: "Why does a higher speed grind less?",
    intro: "Six balls tumble in a drum. Its lifters carry them up, and they fall. At the critical speed, the centrifugal " +
      "force at the wall equals the weight.",
    task: "Run the drum below and above its critical speed. Watch the balls in the replay.",
    varied: "Speed, of the critical speed",
    question: "The drum turns at 125 % of its critical speed instead of 75 %. What happens to the hits?",
    answers: [
      ["They become harder: the drum is faster.", "What counts is the speed of a ball relative to what it hits. A ball that " +
        "turns with the wall does not hit it."],
      ["They become weaker: the balls turn with the wall.", "Above the critical speed, the centrifugal force exceeds the " +
        "weight even at the top: the balls no longer fall. What remains is rattling between the lifters."],
      ["They stay: the height of the fall is the same.", "A ball falls where its weight pulls it off the wall. Above the " +
        "critical speed, that is nowhere."],
      ["There are none at all.", "One ball that never slips would not hit anything. Here, balls still rattle between the " +
        "lifters, but weakly."]],
    conclusion: "At 125 %, a hit has a third of the energy that it has at 75 %, and the power is a third, too. Drums " +
      "therefore turn at about 65 to 80 % of their critical speed." },
  { title: "Few large or many small balls?",
    intro: "The jar of a planetary mill holds 96 g of steel: seven balls of 15 mm or, with nearly the same mass, 24 balls of " +
      "10 mm.",
    task: "Run both, and compare their spectra: how many hits are there, and how hard are they?", varied: "Balls",
    question: "24 small balls replace the seven large ones. What happens to the hits?",
    answers: [
      ["Fewer, and each is harder.", "It is the other way round: a small ball is lighter, and it meets other balls more often."],
      ["More, and each is weaker.", "A ball of 10 mm has 0.3 of the mass of one of 15 mm, and more balls meet more often: the " +
        "same power is divided among more hits."],
      ["More, and each is as hard: the speed of the mill is the same.", "Speeds are alike, but the energy of a hit is " +
        "½ m v², and the mass m of a ball is only 0.3 of what it was."],
      ["As before: the mass is the same.", "The mass of all balls decides roughly how much power they take. Their number " +
        "decides into how many hits it is divided."]],
    conclusion: "About six times as many hits, each with about a seventh of the energy. Coarse and strong grains need hard " +
      "hits, larger balls; a fine powder needs many hits, smaller balls." },
  { title: "Do more balls do more?",
    intro: "This vial is 48 mm long inside, a ball is 8 mm wide. More balls make more hits, but they take the room in which " +
      "the others fly.",
    task: "Run the vial with one, two, four and six balls.", varied: "Number of balls",
    question: "Six balls instead of one: how large is the power of all six together?",
    answers: [
      ["Six times that of one ball.", "Each would have to fly as freely as a single ball. But they hit each other first, at " +
        "a lower speed."],
      ["Larger than that of one ball, but not six times.", "This is true up to four balls. Six are 43 mm long, one above the " +
        "other in a zigzag: too little room is left."],
      ["Smaller than that of one ball.", "Six balls fill the vial nearly from end to end. They travel with it, and touch each " +
        "other and the walls at low speed only."],
      ["The same: the vial decides.", "The vial gives the motion, but how much the balls take depends on the speeds at which " +
        "they hit."]],
    conclusion: "The power has its maximum at a middle filling, here near four balls. The energy of a hit falls as " +
      "balls are added." },
  { title: "Which numbers can be trusted?",
    intro: "The number behind ± is a 95 % interval: so far may the mean of this run be from that of an endless run. Here, " +
      "two short runs are compared.",
    task: "Run the vial for 2 s at 10 Hz and at 11 Hz. Look at the intervals of the power, then at longer runs.",
    varied: "Frequency, time, restitution e",
    question: "2 s at 10 Hz give 40 ± 7 mW, 2 s at 11 Hz give 51 ± 15 mW. What do these two runs tell?",
    answers: [
      ["11 Hz has more power: 51 is more than 40.", "It may be so. But the intervals overlap: in runs as short as these, such " +
        "a difference also arises by chance."],
      ["The power is the same: the intervals overlap.", "Overlap does not prove that they are equal. It means that these runs " +
        "cannot tell."],
      ["Not enough; longer runs can decide.", "Four times the simulated time halves an interval. After 200 s, the intervals " +
        "are apart."],
      ["Nothing: simulations cannot be trusted.", "An interval says how far chance goes, so it can be trusted that far. And " +
        "two settings of one mill can be compared even if some values were never measured."]],
    conclusion: "Long runs tell the frequencies apart. But intervals contain only chance: the restitution, 0.9, is assumed, " +
      "and with 0.8 there are only a third of the hits, far outside the interval. Yet 11 Hz has 1.3 times the power of " +
      "10 Hz with both: trust differences between settings more than absolute numbers." },
];

const sections = { mill: "Mill", jar: "Jar", balls: "Balls", powder: "Powder", contact: "Contact",
  run: "Run", drive: "Motor of the mill", flow: "Flow through the jar" };
const counters = { collisions: "Collisions computed", simulated: "Time simulated",
  power: "Power dissipated", rate: "Hits above the threshold" };
const severities = { invalid: "Outside the validity:", warning: "Warning:", note: "Note:" };
const verdicts = { apart: "differ", overlap: "may be equal", unknown: "no interval" };

const estimate = {
  mill: { label: "Mill", remedy: "choose one of the list" },
  jar: { label: "Jar", remedy: "choose one of the list" },
  material: { label: "Material of balls, jar" },
  balls: { label: "Balls", hint: "or 50 g x 3 mm",
    remedy: "write number and diameter, 2x10mm, or 50 g x 3 mm, or 30 % x 5 mm (of the volume of the jar); a comma stands " +
      "between two sets" },
  drive: { label: "Frequency" },
  powder: { label: "Powder", hint: "or balls to powder, 10:1",
    remedy: "write a mass, 200 mg, or the mass of the balls over that of the powder, 10:1" },
  time: { label: "Milling time", remedy: "fill in the powder, or leave the time empty" },
};
const sentence = (words) => (words === "" ? "" : `${words[0].toUpperCase()}${words.slice(1).replace(/[.]$/, "")}.`);

function status(run) {
  if (!run) return "Ready.";
  const sum = seconds(run.sum("simulated") || 0);
  const of = run.replicates.length === 1 ? "" : ` in ${run.replicates.length} replicates`;
  if (run.status === "done" && run.endedEarly())
    return `Ended early: ${sum} simulated${of}; the notices of the result say why.`;
  if (run.status === "done") return `Done: ${sum} simulated${of}, computed in ${seconds(run.seconds)}.`;
  if (run.status === "stopped") return `Stopped: ${sum} simulated, the result holds what was computed.`;
  if (run.status === "failed") return `The run failed: ${run.message}`;
  const percent = `${Math.floor(100 * run.share())} %`;
  if (run.status === "paused") return `Paused at ${percent}.`;
  if (run.status === "stopping") return "Stopping …";
  if (run.status === "merging") return "Merging the replicates …";
  return `Computing${of}: ${percent}, ${sum} simulated.`;
}

export const text = {
  language: "en",
  shortName: "EN",
  languageName: "English",
  languageChoice: "Language",
  /// Names of what the program calls by English words: by key, or by heading. Empty here: its words are taken.
  quantityNames: {},
  groupNames: {},
  keyNames: {},
  numbers: { to: "to", infinite: "infinite" },
  name: "Mahlwerk",
  tagline: "What happens inside a ball mill",
  skip: "Skip to the results",
  loading: "Loading the simulator …",
  loadFailed: (why) => `The simulator could not be loaded: ${why}`,
  version: (version) => `Mahlwerk ${version}`,
  englishParts: "", // says in other languages which parts of the page are English
  footer: "Everything is computed on this device; nothing is sent. Free software, Apache License 2.0.",
  licences: "Licences",
  toDark: "Dark",
  toLight: "Light",
  themeAbout: "Switch between dark and light",

  estimate: "Estimate",
  estimateHeading: "Estimate of a mill",
  estimateAbout: "Makes the case, shows it below and runs it. What it assumes is listed under \"About these numbers\"; bands " +
    "over these values are computed by mahlwerk estimate on the command line.",
  estimateWord: (word) => estimate[word].label,
  estimateHint: (word) => estimate[word].hint ?? "",
  estimateDrive: (key) => (key === "speed" ? "Speed" : "Frequency"),
  estimateRange: ({ least, most, fixed }) => fixed ? `empty: ${fixed}, that of the mill`
    : !most ? "" : least ? `${least} to ${most}` : `up to ${most}`,
  estimateFault: (kind, word, fault) => kind === "missing" ? "Fill in this field."
    : `${sentence(fault.text)} ${sentence(kind === "written" ? estimate[word].remedy : fault.remedy)}`.trim(),

  exampleCases,
  example: "Start from",
  ownCase: "Your own case",
  caseHeading: "Case",
  form: "Form",
  caseText: "Case as text (TOML)",
  caseTab: "Text",
  resultHeading: "Result",
  runHeading: "Run",
  regions: "Shown part",
  replay: "Balls in the moving jar",
  replayWords,

  learn: "Learn",
  learnAbout: "Five lessons with questions",
  learnIntro: "Each lesson asks a question. Guess, and let the page compute the answer.",
  learnClose: "Close the lessons",
  lessons,
  lessonName: (number, title) => `Lesson ${number}: ${title}`,
  lessonDone: "answered",
  lessonTry: "Run with",
  lessonQuestion: "Question",
  lessonRight: "Right.",
  lessonWrong: "Not quite.",
  lessonCheck: "Check it yourself",
  lessonCheckAbout: "Computes the cases of this lesson, with their 95 % intervals.",
  lessonStatus: (at, count) => `Computing case ${at} of ${count} …`,
  lessonResult: "What the cases show",
  lessonNext: "Next lesson",
  section: (name) => sections[name] ?? plain(name),
  ballSet: (number) => `Balls, set ${number}`,
  part: (name) => `Part: ${name}`,
  addBalls: "Add a set of balls",
  remove: "Remove",
  word: (word) => words[word] ?? plain(word),
  kind: (kind) => words[kind] ?? plain(kind),
  model: (where) => (where === "mill" ? "Mill" : "Jar"),
  byItsNumbers: "By its numbers",
  fromCatalogue: "From the catalogue",
  containsUnverified: "contains unverified values",
  unitOf: (label) => `Unit: ${label}`,
  sliderOf: (label) => `Slider: ${label}`,
  automatic: "auto",
  lineNumber: (line) => `Line ${line}`,
  remedy: (remedy) => `Remedy: ${remedy}`,
  faultsFirst: "The case has a fault; mend it first.",
  faultCount: (count) => (count === 1 ? "The case has a fault:" : `The case has ${count} faults. The first:`),
  showFaults: "Show",

  run: "Run",
  pause: "Pause",
  resume: "Continue",
  stop: "Stop",
  progress: "Progress of the run",
  status,
  changed: "The case has changed since this result.",
  sweeping: "A sweep is being computed.",
  counter: (key) => counters[key],

  share: "Share",
  shareAbout: "Copy a link that contains the whole case",
  shared: "Link copied. It contains the whole case; nothing was sent.",
  sharedAddress: "The address of this page now contains the whole case: copy it from there.",
  badLink: "This link holds no readable case; the first example is shown instead.",
  badLinkLater: "The address holds no readable case; the present one stays.",
  keptCase: "Your case as you left it. Press Run to compute it.",
  leaveChanges: "Leave your changes of the case? The browser's Back brings them back.",
  fromLink: "This case came with the link. Press Run to compute it.",

  spectrum: "Spectrum of impacts",
  spectrumOf: "Spectrum of",
  rate: "Rate",
  power: "Power",
  spectrumRateAbout: "Collisions per second over their impact energy",
  spectrumPowerAbout: "Impact power over impact energy",
  spectrumAbout: (peak) => `It is highest near ${peak}.`,
  impactEnergy: "Impact energy, normal motion",
  rateAxis: "Rate per octave, 1/s",
  powerPerOctave: "Power per octave",
  powerAxis: "Power",
  thisRun: "this run",
  powerOverTime: "Power over time",
  timeAxis: "Simulated time, s",
  dissipated: "dissipated",
  meanSoFar: "mean so far",

  details: "Details of the result",
  quantities: "Quantities",
  quantityColumns: ["Quantity", "Value ± 95 % interval", "Meaning"],
  noMillingTime: "no milling time given",
  preliminary: "Preliminary: the run is being computed, and the intervals still shrink.",
  noResult: "No result yet: press Run.",
  noCurve: "Nothing to draw yet.",

  comparison: "Compare",
  keepAsA: "Keep this result as A",
  forgetA: "Forget A",
  restoreA: "Back to the case of A",
  compareHint: "Keep a result as A, change the case, and run again: both stand side by side here.",
  compareRunB: (title) => `A is "${title}". Now change the case and run it: the next result is B.`,
  compareAbout: (a, b) => `A is "${a}", B is "${b}". "Differ" means that the 95 % intervals do not ` +
    "overlap.",
  differences: (list) => (list.length === 0 ? " Both cases are the same."
    : ` Changed: ${list.map(([key, a, b]) => `${key} from ${a ?? "its default"} to ${b ?? "its default"}`)
      .join(", ")}.`),
  compareColumns: ["Quantity", "A", "B", "Change", "Intervals"],
  verdict: (verdict) => verdicts[verdict],

  sweep: "Sweep",
  sweepAbout: "Runs the case at several values of one key, one after another.",
  sweepKey: "Key",
  sweepFrom: "From",
  sweepTo: "To",
  sweepCount: "Number of values",
  sweepSpacing: "Spacing",
  spacings: [["lin", "equal steps"], ["log", "equal ratios"]],
  sweepQuantity: "Quantity",
  sweepCurve: "Curve of the sweep",
  runSweep: "Run the sweep",
  saveSweep: "Download sweep.csv",
  sweepWaits: "A run is being computed; stop it, or wait for its end.",
  sweepFault: "From and to must be numbers; with equal ratios both above 0.",
  sweepStatus: (state, at, count) => state === "done" ? `Done: ${count} values.`
    : state === "stopped" ? `Stopped after ${at} of ${count} values.`
      : `Computing value ${Math.min(at + 1, count)} of ${count}.`,

  report: "All plots",
  noReport: "The report of a run, with every plot and map, appears here when the run has ended.",

  about: "About these numbers",
  trust: "The intervals contain only the scatter of the simulation: a longer run makes them narrower. " +
    "They do not contain errors of the model, nor of values that nobody measured. Differences between " +
    "two settings of one mill are more reliable than absolute numbers.",
  noticesInFull: (count) => (count === 1 ? "This notice in full" : `${count} notices in full`),
  replicateStopped: (number, reason) => `Replicate ${number} was stopped: ${reason}`,
  noNotices: "The program has no notices about this case.",
  severity: (severity) => severities[severity] ?? `${severity}:`,
  guessed: "Assumed and not calibrated:",
  assumed: "Assumed values",
  assumedAbout: "The case does not state these values; the program took its defaults.",
  unverified: "Unverified values",
  unverifiedAbout: "Values of the catalogue whose source is weak or that nobody has checked.",
  originColumns: ["Key", "Value", "Source"],
  repeat: "Repeat this run with the program",
  repeatAbout: "Save the case as case.toml. The same version of the program gives the same numbers:",
  copy: "Copy",
  copied: "Copied",
  downloadCase: "Download case.toml",

  files: "Files",
  filesAbout: "Files of this result.",
  filesHint: "The files of a result appear here when a run has ended.",
  openResult: "Open a result or a case",
  openAbout: "Results of the program: choose summary.json and what lies beside it, or drop the folder on the page. The page of a " +
    "campaign, a fit or a search (campaign.html, ...) is shown, too.",
  opened: (title) => `Opened: ${title}.`,
  openedStudy: "Opened: the page of a study, below \"All plots\".",
  openedCase: "This case came from a file. Press Run to compute it.",
  nothingToOpen: "Among these files is neither a summary.json nor a case (.toml).",
  cannotOpen: (why) => `This result cannot be shown: ${why}`,

  // work
  follow: "Run follows changes",
  followAbout: "A changed case takes the place of the one that is computed. After a result that took at most 30 s, a change " +
    "starts the next run, too. After Pause or Stop nothing starts by itself",

  history: "History",
  historyAbout: "Results of this session, the newest first: at most 20. They are gone when the page is closed, unless you save " +
    "them: saved ones stay in this browser, on this device.",
  historyDenied: "Results of this session, the newest first: at most 20. This browser lets the page keep nothing, so they are " +
    "gone when the page is closed: download what you need.",
  nameOfCase: "Name",
  saveThisCase: "Save this case",
  savedAs: (name) => `Saved as "${name}" in this browser.`,
  notSaved: (reason) => reason === "full" ? "Not saved: there is no room left in this browser. Delete a saved entry first."
    : reason === "denied" ? "This browser lets the page keep nothing: the name holds until the page is closed."
      : `Not saved: ${reason}`,
  nameOfEntry: "New name",
  ok: "OK",
  entryAbout: ({ date, saved }) => `${new Date(date).toLocaleString("en-GB", { dateStyle: "medium", timeStyle: "medium" })}, ` +
    (saved ? "saved" : "this session"),
  entryChange: (changes) => `Since the result before: ${changes.map(([key, to]) => `${key} = ${to ?? "its default"}`).join(", ")}`,
  entryChoice: ({ name, date, change }) => [name, new Date(date).toLocaleTimeString("en-GB"),
    ...change.slice(0, 2).map(([key, to]) => `${key} = ${to ?? "its default"}`)].join(", "),
  onlyCase: "A case without a result.",
  open: "Open",
  openEntry: (name) => `Open ${name}`,
  openedEntry: "Your saved case. Press Run to compute it.",
  rename: "Rename",
  renameEntry: (name) => `Rename ${name}`,
  saveEntry: "Save",
  saveEntryAbout: (name) => `Save ${name} by a name`,
  downloadCaseOf: (name) => `Download case.toml of ${name}`,
  downloadSummaryOf: (name) => `Download summary.json of ${name}`,
  delete: "Delete",
  deleteEntry: (name) => `Delete ${name}`,
  compareGroup: "Compare as A or B",
  compareAs: (side, name) => `Compare as ${side}: ${name}`,
  noA: "no result",
  newestAsB: "the newest result",

  embed: "To embed the case in another page:",
  embedAbout: "The frame shows the replay, the key numbers and Run; with #embed&amp;run&amp; in place of #embed&amp; it runs at once.",
  openInFull: "Open in full",
  close: "Close",
};
