// Part of building the site for release (finish.mjs): what the first view does without leaves the page's program for a second
// one, which comes after it and shares its memory, its tables and its functions. In the first program a short stub stands
// for each function that left; it goes through a table that the second fills when it comes. Should one be wanted before,
// the stub has the second fetched there and then (`late`, in boot.js and engine.js). Works on the text form, where all have names.

import { execFile } from 'node:child_process';
import { readFile, readdir, rm, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { promisify } from 'node:util';

const run = promisify(execFile);
const FEATURES = ['bulk-memory', 'nontrapping-float-to-int', 'sign-ext', 'mutable-globals', 'reference-types', 'multivalue'];
const FLAGS = FEATURES.map((feature) => `--enable-${feature}`);

/** Where what comes late is at home; whatever only these use goes with them. */
const LATE = [
  // The planner, which is made for speed.
  ...['domain::flood', 'domain::leaps', 'domain::straight', 'ground::bound', 'ground::compile', 'ground::distance', 'ground::errand',
    'ground::grid', 'ground::itinerary', 'ground::monitor', 'ground::pairs', 'ground::relax', 'ground::strides', 'ground::task',
    'ground::undertaking', 'ground::wish', 'mdp', 'plan', 'solve'].map((home) => `groundling_kernel::${home}::`),
  ...['worker::course', 'worker::plan',
    'ui::page::grammar::german', 'ui::help', 'ui::kept', 'ui::app::view::kept', 'ui::app::view::address::share',
    'ui::page::view::files::read_all', 'ui::page::view::files::sort', 'ui::talk::command::ask::instead',
    'ui::talk::past', 'ui::talk::proof', 'ui::talk::room::edit', 'ui::talk::room::hand::release',
    'ui::talk::room::moved', 'ui::talk::room::worlds', 'ui::talk::share::also', 'ui::talk::share::session',
    'ui::talk::teach::learn::learn', 'ui::talk::teach::learn::learn_besides', 'ui::talk::teach::learn::look',
    'ui::talk::teach::trail', 'ui::talk::teach::unlike', 'ui::talk::view::chart', 'ui::talk::view::edit',
    'ui::talk::view::past::lines', 'ui::talk::view::planner', 'ui::talk::view::proof', 'ui::talk::view::readings',
    'ui::talk::view::rules', 'ui::talk::view::share::told', 'ui::talk::view::study', 'ui::talk::view::teach::lesson',
    'ui::talk::view::teach::refused', 'ui::talk::view::teach::taught', 'ui::talk::watch::chart', 'ui::talk::watch::values',
    'ui::talk::why'].map((home) => `groundling::${home}::`),
];

const NAME = String.raw`\$(?:"(?:[^"\\]|\\.)*"|[^\s()"]+)`;
const first = (form) => form.match(NAME)[0];
const names = (text, pattern) => [...text.matchAll(new RegExp(pattern.replace('NAME', `(${NAME})`), 'g'))].map(([, name]) => name);
const isLate = (name) => LATE.some((home) => [`$${home}`, `$"${home}`, `$"<${home}`].some((own) => name.startsWith(own)));

/** The parts of a program's text, by what they are. */
function read(text) {
  const forms = text.slice(0, text.lastIndexOf('\n)')).split(/\n(?= \()/).slice(1);
  const those = (kind) => forms.filter((form) => form.startsWith(` (${kind} `));
  return { forms, those, functions: new Map(those('func').map((form) => [first(form), form])) };
}

/** The functions that can go: those at home where what is late is, and those that nothing else can reach. */
function late({ those, functions }) {
  const calls = new Map([...functions].map(([name, form]) => [name, names(form, '\\((?:return_)?call NAME')]));
  const told = [...those('export'), ...those('elem'), ...those('start')].flatMap((form) => names(form, 'NAME'));
  const stays = new Set();
  for (const todo = told.filter((name) => !isLate(name)); todo.length > 0;) {
    const name = todo.pop();
    if (!functions.has(name) || stays.has(name)) continue;
    stays.add(name);
    todo.push(...calls.get(name).filter((called) => !isLate(called)));
  }
  const goes = [...functions.keys()].filter((name) => !stays.has(name));
  const wanted = new Set([...told, ...[...stays].flatMap((name) => calls.get(name))]);
  return { goes, stubs: goes.filter((name) => wanted.has(name)) };
}

/** What a function takes and gives, as it stands in its own head, or without names. */
const head = (form) => form.slice(form.indexOf(first(form)) + first(form).length).split('\n')[0].replace(/\)\)$/, ')');
const signature = (form) => head(form).replaceAll(/(?<=\(param )\$\S+ /g, '');

function stub(name, form, place) {
  const given = [...head(form).matchAll(/\(param (\$\S+)/g)].map(([, own]) => ` (local.get ${own})`).join('');
  return ` (func ${name}${head(form)}
  (if (ref.is_null (table.get $late (i32.const 0))) (then (call $bring_late)))
  (call_indirect $late${signature(form)}${given} (i32.const ${place})))`;
}

/** The two programs that are made of one. */
function split(text) {
  const whole = read(text);
  const { forms, those, functions } = whole;
  const { goes, stubs } = late(whole);
  if (stubs.length === 0) throw new Error('no function is late: the program has no names, or LATE names none of its modules');
  const gone = goes.map((name) => functions.get(name)).join('\n');
  if (/\(ref\.func |\(memory\.init |\(data\.drop /.test(gone)) throw new Error('what goes refers to what cannot be shared');

  // What the second has from the first. The first gives nothing else besides what it gave before.
  const own = new Set(goes);
  const used = new Set(names(gone, 'NAME'));
  const shared = [...used].filter((name) => functions.has(name) && !own.has(name)).map((name) => ['func', name, signature(functions.get(name))]);
  for (const form of those('import')) {
    const [, name, rest] = form.match(`\\(func (${NAME})(.*)\\)\\)$`) ?? [];
    if (used.has(name)) shared.push(['func', name, rest]);
  }
  for (const kind of ['memory', 'table', 'global']) {
    for (const form of those(kind)) {
      const [, rest] = form.match(`^ \\(${kind} ${NAME}((?: \\([^()]*\\)| [^\\s()]+)*?)(?: \\(i32\\.const .*\\))?\\)$`);
      if (kind === 'memory' || used.has(first(form))) shared.push([kind, first(form), rest]);
    }
  }
  shared.push(['table', '$late', ` ${stubs.length} funcref`]);
  const called = (place) => `"${place.toString(36)}"`;

  const kept = forms.filter((form) => !(form.startsWith(' (func ') && own.has(first(form)) && !stubs.includes(first(form))))
    .map((form) => (form.startsWith(' (func ') && own.has(first(form)) ? stub(first(form), form, stubs.indexOf(first(form))) : form));
  const at = kept.findIndex((form) => /^ \((?:global|memory|table|data|elem|export|func) /.test(form));
  kept.splice(at, 0, ' (import "./app_bg.js" "late" (func $bring_late))', ` (table $late ${stubs.length} funcref)`,
    ...shared.map(([kind, name], place) => ` (export ${called(place)} (${kind} ${name}))`));
  const second = [
    ...those('type'), ...those('rec'),
    ...shared.map(([kind, name, rest], place) => ` (import "first" ${called(place)} (${kind} ${name}${rest}))`),
    ` (elem (table $late) (i32.const 0) func ${stubs.join(' ')})`, gone,
  ];
  const module = (parts) => `(module\n${parts.join('\n')}\n)\n`;
  return { programs: [module(kept), module(second)], figures: [goes.length, functions.size, stubs.length] };
}

const folder = process.env.TRUNK_STAGING_DIR;
if (process.env.TRUNK_PROFILE === 'release') {
  const program = (await readdir(folder)).find((file) => /^app-.*_bg\.wasm$/.test(file));
  const at = (name) => path.join(folder, name);
  const [second, script] = [program.replace('_bg.', '_late.'), program.replace('_bg.wasm', '.js')];
  const text = at('app.wat');
  await run('wasm-dis', [...FLAGS, at(program), '-o', text]);
  const { programs, figures: [gone, all, stubs] } = split(await readFile(text, 'utf8'));
  for (const [place, name] of [program, second].entries()) {
    await writeFile(text, programs[place]);
    await run('wasm-as', [...FLAGS, text, '-o', at(name)]);
  }
  await rm(text);
  const edit = async (name, from, to) => {
    const before = await readFile(at(name), 'utf8');
    if (!from.test(before)) throw new Error(`${name} has nothing like ${from}`);
    await writeFile(at(name), before.replace(from, to));
  };
  await edit(script, /const import0 = \{/, '$&\n        late: () => globalThis.late(wasm),');
  await edit('index.html', /data-app="?program"?/, `$& data-late="./${second}"`);
  console.log(`${gone} of ${all} functions come late, by way of ${stubs}`);
}
