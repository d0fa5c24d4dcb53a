// The schema that ships for editors (through ajv) and the reader that speaks to people must give
// the same verdict on the structure of an instrument. Compared on three folders of small files and
// on every shipped instrument with one thing changed.
//
//   node schema_verdicts.mjs <node_modules> <instrument_verdict> <library> <data> <scratch>
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";

const [nodeModules, verdictProgram, library, data, scratch] = process.argv.slice(2);
const kSkipped = 77;

// What no schema sees: what one part of a file says about another, and what JSON.parse lets pass.
const kUnseen = [
  /^two (items|options|scores) share the id /,
  /^two options read the same$/,
  /^the text in '(?!en')[A-Za-z-]+' is missing$/,
  /^this text is blank$/,
  /is not among the options$/,
  /^there is no item '/,
  /^answers to '.*' are no numbers$/,
  /names a person$/,
  /is the id of an item too$/,
  /^more answers are needed than there are items$/,
  /^a sum with answers missing would count them as zero$/,
  /^least is .* and most is /,
  /^steps of .* do not lead from /,
  /labels for .* points$/,
  /has no words for both ends$/,
  /stands here twice$/,
  /holds the character NUL$/,
  /^a whole number is expected here, not one with a decimal point$/, // 5.0 is 5 to JSON.parse
];

const failures = [];
const fail = (sentence) => failures.push(sentence);

function loadAjv() {
  try {
    return createRequire(path.join(path.resolve(nodeModules), "any.js"))("ajv/dist/2020").default;
  } catch {
    console.log(
      `skipped: there is no ajv in ${nodeModules}; run 'npm install ajv' beside it or set PALPATE_AJV`,
    );
    process.exit(kSkipped);
  }
}

function readerVerdicts(files) {
  const verdicts = new Map();
  for (let i = 0; i < files.length; i += 200) {
    const lines = execFileSync(verdictProgram, files.slice(i, i + 200), {
      encoding: "utf8",
      maxBuffer: 1 << 28,
    });
    for (const line of lines.trim().split("\n")) {
      const verdict = JSON.parse(line);
      verdicts.set(verdict.file, verdict);
    }
  }
  return verdicts;
}

const filesIn = (folder) =>
  fs.readdirSync(folder).filter((name) => name.endsWith(".json")).sort().map((name) => path.join(folder, name));
const parsed = (file) => JSON.parse(fs.readFileSync(file, "utf8").replace(/^\uFEFF/, ""));
const errorsOf = (verdict) => verdict.problems.filter((problem) => problem.severity === "error");
const isUnseen = (problem) => kUnseen.some((pattern) => pattern.test(problem.what));
const inWords = (problems) => problems.map((problem) => `\n    ${problem.path}: ${problem.what}`).join("");

// --- the three folders -----------------------------------------------------------------------

function compareFolder(folder, schemaAccepts, readerAccepts) {
  const files = filesIn(folder);
  const verdicts = readerVerdicts(files);
  for (const file of files) {
    const verdict = verdicts.get(file);
    if (validate(parsed(file)) !== schemaAccepts) {
      fail(`${file}: the schema ${schemaAccepts ? "refuses" : "accepts"} it ${JSON.stringify(validate.errors)}`);
    }
    if (verdict.accepted !== readerAccepts) {
      fail(`${file}: the reader ${readerAccepts ? "refuses" : "accepts"} it${inWords(verdict.problems)}`);
    }
  }
  return [...verdicts.values()];
}

function checkWhatIsUnseen(verdicts) {
  for (const verdict of verdicts) {
    for (const problem of errorsOf(verdict).filter((p) => !isUnseen(p))) {
      fail(`${verdict.file}: a schema should see this too: ${problem.path}: ${problem.what}`);
    }
  }
  const said = verdicts.flatMap(errorsOf).map((problem) => problem.what);
  for (const pattern of kUnseen.filter((p) => !said.some((what) => p.test(what)))) {
    fail(`no file of the folder semantic shows ${pattern}`);
  }
}

// --- one thing changed -----------------------------------------------------------------------

const kinds = (value) => (value === null ? "null" : Array.isArray(value) ? "list" : typeof value);
const kOthers = ["a text", "", 5, 1.5, -1e12, true, null, [], {}, ["a"], { en: 5 }, { de: "nur Deutsch" }];

function* changesOf(value) {
  for (const other of kOthers) {
    if (JSON.stringify(other) !== JSON.stringify(value)) yield [`becomes ${JSON.stringify(other)}`, other];
  }
  if (typeof value === "string") yield ["is misspelt", value + " x"];
  if (typeof value === "number") {
    yield ["is one less", value - 1];
    yield ["is far too large", 1e15];
    yield ["is zero", 0];
  }
  if (kinds(value) === "list") {
    yield ["loses its first", value.slice(1)];
    yield ["keeps only its first", value.slice(0, 1)];
    if (value.length > 0) yield ["has its first twice", [value[0], ...value]];
    if (value.length > 0) yield ["has far too many", Array(1001).fill(value[0])];
  }
}

function* changesOfKeys(object) {
  for (const key of Object.keys(object)) {
    const without = { ...object };
    delete without[key];
    yield [`${key} is dropped`, without];
    const misspelt = Object.fromEntries(Object.entries(object).map(([k, v]) => [k === key ? `${k}x` : k, v]));
    yield [`${key} is misspelt`, misspelt];
    const mistaken = { ...without, [key.toUpperCase()]: object[key] };
    yield [`${key} is shouted`, mistaken];
  }
  for (const key of ["colour", "options", "scale", "key", "least", "unit", "consent_option"]) {
    if (!(key in object)) yield [`${key} is added`, { ...object, [key]: 1 }];
  }
}

/// Every place of a value with the shape of the place: what was changed at "items[3].text" need not
/// be changed again at "items[4].text", unless the item is of another type. Plain values of the same
/// shape are changed in one file only.
function* placesOf(value, at = [], shape = "$") {
  yield [at, shape, value];
  const kind = kinds(value);
  if (kind === "object") {
    for (const key of Object.keys(value)) {
      const type = typeof value.type === "string" ? `<${value.type}>` : "";
      yield* placesOf(value[key], [...at, key], `${shape}${type}.${key}`);
    }
  } else if (kind === "list") {
    for (let i = 0; i < value.length; ++i) yield* placesOf(value[i], [...at, i], `${shape}[]`);
  }
}

function changedAt(value, at, changed) {
  if (at.length === 0) return changed;
  const copy = Array.isArray(value) ? [...value] : { ...value };
  copy[at[0]] = changedAt(value[at[0]], at.slice(1), changed);
  return copy;
}

const seenAnywhere = new Set();

function* mutationsOf(instrument) {
  const seenHere = new Set();
  for (const [at, shape, value] of placesOf(instrument)) {
    const seen = ["object", "list"].includes(kinds(value)) ? seenHere : seenAnywhere;
    if (seen.has(shape)) continue;
    seen.add(shape);
    const changes = [...changesOf(value), ...(kinds(value) === "object" ? changesOfKeys(value) : [])];
    for (const [how, changed] of changes) yield [`${at.join(".")} ${how}`, changedAt(instrument, at, changed)];
  }
}

function compareMutations(file) {
  const folder = path.join(scratch, path.basename(file, ".json"));
  fs.mkdirSync(folder, { recursive: true });
  const cases = [...mutationsOf(parsed(file))].map(([how, content], i) => {
    const place = path.join(folder, `${i}.json`);
    fs.writeFileSync(place, JSON.stringify(content));
    return { how: `${path.basename(file)}: ${how}`, place, content };
  });
  const verdicts = readerVerdicts(cases.map(({ place }) => place));
  const count = { accepted: 0, refused: 0, unseen: 0 };
  for (const { how, place, content } of cases) {
    const errors = errorsOf(verdicts.get(place));
    const isSound = validate(content);
    if (!isSound && errors.length === 0) fail(`${how}: only the schema refuses it ${JSON.stringify(validate.errors)}`);
    const seen = errors.filter((problem) => !isUnseen(problem));
    if (isSound && seen.length > 0) fail(`${how}: only the reader refuses it${inWords(seen)}`);
    ++count[!isSound ? "refused" : errors.length > 0 ? "unseen" : "accepted"];
  }
  return count;
}

// ---------------------------------------------------------------------------------------------

const Ajv = loadAjv();
const schema = path.join(library, "instrument-1.schema.json");
const validate = new Ajv({ allErrors: true, strict: true, strictRequired: false }).compile(parsed(schema));
fs.rmSync(scratch, { recursive: true, force: true });

const instruments = filesIn(library).filter((file) => file !== schema);
compareFolder(path.join(data, "good"), true, true);
compareFolder(path.join(data, "bad"), false, false);
checkWhatIsUnseen(compareFolder(path.join(data, "semantic"), true, false));
for (const verdict of readerVerdicts(instruments).values()) {
  if (!verdict.accepted) fail(`${verdict.file}: refused${inWords(verdict.problems)}`);
}
const total = { accepted: 0, refused: 0, unseen: 0 };
for (const file of [...instruments, ...filesIn(path.join(data, "good"))]) {
  if (!validate(parsed(file))) fail(`${file}: the schema refuses it ${JSON.stringify(validate.errors)}`);
  for (const [kind, count] of Object.entries(compareMutations(file))) total[kind] += count;
}
fs.rmSync(scratch, { recursive: true, force: true });

console.log(
  `changed files: ${total.refused} refused by both, ${total.accepted} accepted by both, ` +
    `${total.unseen} refused by the reader for what no schema sees`,
);
if (total.refused < 300) fail("too few changes were tried");
for (const sentence of failures.slice(0, 40)) console.log(sentence);
if (failures.length > 0) console.log(`${failures.length} disagreements`);
process.exit(failures.length > 0 ? 1 : 0);
