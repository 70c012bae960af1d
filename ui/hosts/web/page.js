'use strict';
// The page around the program: listens to the browser, and does what the program asks of it.
// page.cpp is the other half. It comes before rasterwalk.js, which picks up `Module`.

// ---- What the program calls ----------------------------------------------------------------------

const canvas = document.getElementById('canvas');
const sentence = document.getElementById('sentence');
const chooser = document.getElementById('chooser');
const typing = document.getElementById('typing');

// Each page of a site keeps its own data.
const storePrefix = 'rasterwalk:' + new URL('.', location.href).pathname + ':';
const stateFolder = '/state/rasterwalk';
const keptFiles = ['progress.toml', 'window.toml'];

const page = {
    frames: 0, // for tests: how many were requested

    copy(text) {
        const byHand = () => {
            tell('web_say', 'This browser does not let the page copy. Copy the text from the dialog.');
            window.prompt('Copy this:', text);
        };
        if (navigator.clipboard) navigator.clipboard.writeText(text).catch(byHand);
        else byHand();
    },
    chooseFile(isResult) {
        chooser.value = '';
        chooser.multiple = !isResult;
        chooser.onchange = () => openFiles([...chooser.files].map(file => ({name: file.name, file})), isResult);
        chooser.click();
    },
    handOut(path) {
        const link = document.createElement('a');
        link.href = URL.createObjectURL(new Blob([FS.readFile(path)]));
        link.download = path.slice(path.lastIndexOf('/') + 1);
        link.click();
        setTimeout(() => URL.revokeObjectURL(link.href), 60000);
    },
    // Returns false if the browser keeps nothing.
    keep(path) {
        try {
            const name = path.slice(path.lastIndexOf('/') + 1);
            if (!keptFiles.includes(name)) return true;
            localStorage.setItem(storePrefix + name, FS.readFile(path, {encoding: 'utf8'}));
            return true;
        } catch (fault) {
            return false;
        }
    },
    setCursor(name) { canvas.style.cursor = name; },
    // A touch screen shows its keyboard, and hides it.
    setTyping(isTyping) {
        if (!lastPointerWasTouch) return;
        typing.value = typingMark;
        if (isTyping) typing.focus();
        else canvas.focus();
    },
    setAddress(fragment) {
        clearTimeout(addressTimer);
        try {
            if (fragment !== location.hash) history.replaceState(null, '', fragment || location.pathname + location.search);
        } catch (fault) {
            addressTimer = setTimeout(() => page.setAddress(fragment), 1000); // browsers limit how many they allow
        }
    },
    // Only the first sentence is shown: it says why there is nothing else.
    say(text) {
        if (isTold) return;
        isTold = true;
        sentence.textContent = text;
        sentence.hidden = false;
    },
};
let isTold = false, addressTimer = 0;

function stored(name) {
    try {
        return localStorage.getItem(storePrefix + name);
    } catch (fault) {
        return null; // storage is turned off
    }
}

// ---- When frames are drawn -----------------------------------------------------------------------

let isRunning = false;
let request = 0, timer = 0;

function wake() {
    if (isRunning && !request) request = requestAnimationFrame(drawFrame);
}

function drawFrame() {
    cancelAnimationFrame(request); // a tap does not wait for it
    request = 0;
    clearTimeout(timer);
    ++page.frames;
    const ratio = devicePixelRatio;
    const width = Math.max(Math.round(canvas.clientWidth * ratio), 1);
    const height = Math.max(Math.round(canvas.clientHeight * ratio), 1);
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    const rest = call('web_frame', performance.now(), width, height, ratio);
    if (page.frames === 1 && isRunning) {
        sentence.hidden = true;
        isTold = false;
        performance.mark('first-picture');
    }
    if (rest <= 0) wake();
    else if (Number.isFinite(rest)) timer = setTimeout(wake, rest);
}

const longestText = 100000; // letters that a function of page.cpp takes

// Calls a function of page.cpp. If it ends the program, the page says why instead of standing still.
function call(name, ...values) {
    if (!isRunning) return Infinity;
    const types = values.map(value => typeof value === 'string' ? 'string' : 'number');
    const short = values.map(value => typeof value === 'string' ? value.slice(0, longestText) : value);
    try {
        return Module.ccall(name, 'number', types, short);
    } catch (fault) {
        stop(fault);
        return Infinity;
    }
}

function stop(fault) {
    const wasRunning = isRunning;
    isRunning = false;
    console.error(fault);
    const what = (fault && fault.message || String(fault)).replace(/\.$/, '');
    page.say(wasRunning ? `Rasterwalk has stopped (${what}). Reload the page to continue; your progress is kept.`
        : `Rasterwalk could not be started (${what}). It needs a browser with WebGL 2 and WebAssembly exceptions, and its own files next to it.`);
}

function tell(name, ...values) {
    call(name, ...values);
    wake();
}

// ---- Keys ----------------------------------------------------------------------------------------

// Keys by their numbers in ui/widgets/keys.h.
const namedKeys = {
    Escape: 256, Enter: 257, Tab: 258, Backspace: 259, Insert: 260, Delete: 261,
    ArrowRight: 262, ArrowLeft: 263, ArrowDown: 264, ArrowUp: 265,
    PageUp: 266, PageDown: 267, Home: 268, End: 269,
    F1: 290, F2: 291, F3: 292, F4: 293, F5: 294, F6: 295, F12: 301,
};
const codedKeys = {
    Space: 32, Quote: 39, Comma: 44, Minus: 45, Period: 46, Slash: 47, Semicolon: 59, Equal: 61,
    BracketLeft: 91, Backslash: 92, BracketRight: 93,
    NumpadSubtract: 333, NumpadAdd: 334, NumpadEnter: 335,
};
const writtenKeys = {',': 44, '-': 45, '.': 46, '+': 61, '=': 61, '[': 91, ']': 93};
// With Ctrl all other keys belong to the browser: a new tab, reload, find, zoom. Ctrl+V sends a paste event.
const commandKeys = new Set(['A', 'C', 'O', 'S', 'X', 'Y', 'Z', ','].map(key => key.charCodeAt(0))
    .concat([263, 262, 264, 265, 257, 268, 269, 259, 261, 290]));

// A letter is the one written on the key; if that is not a Latin one, the key's place counts.
function keyOf(event) {
    if (event.code.startsWith('Numpad') && codedKeys[event.code]) return codedKeys[event.code];
    if (event.key in namedKeys) return namedKeys[event.key];
    if (/^[a-z]$/i.test(event.key)) return event.key.toUpperCase().charCodeAt(0);
    const digit = /^(?:Digit|Numpad)(\d)$/.exec(event.code);
    if (digit) return digit[1].charCodeAt(0);
    if (event.key in writtenKeys) return writtenKeys[event.key];
    const letter = /^Key([A-Z])$/.exec(event.code);
    if (letter) return letter[1].charCodeAt(0);
    return codedKeys[event.code] || 0;
}

// On a Mac, Option with a key writes what AltGr writes elsewhere.
const isMac = /Mac|iPhone|iPad/.test(navigator.platform);

function onKey(event) {
    if (event.isComposing) return;
    const isDown = event.type === 'keydown';
    const isThirdLevel = event.getModifierState('AltGraph');
    const ctrl = (event.ctrlKey || event.metaKey) && !isThirdLevel;
    const alt = event.altKey && !isThirdLevel;
    const key = keyOf(event);
    if (!isDown && event.key === 'Meta') tell('web_leave');
    if (!event.repeat) tell('web_key', key, isDown, ctrl, event.shiftKey, alt);
    // While Command is held, macOS does not report that other keys are released.
    if (isDown && event.metaKey && key) tell('web_key', key, false, ctrl, event.shiftKey, alt);
    const isLetter = [...event.key].length === 1;
    const isWritten = isDown && isLetter && !ctrl && (!alt || isMac) && document.activeElement !== typing;
    if (isWritten) tell('web_letters', event.key);
    const isOurs = ctrl ? commandKeys.has(key) : alt ? key === 262 || key === 263 : key !== 0;
    const isTyped = document.activeElement === typing && (isLetter || key === 259);
    if (isOurs && !isTyped) event.preventDefault();
}

// ---- Mouse, pen and fingers ----------------------------------------------------------------------

const programButtons = [[1, 0], [2, 1], [4, 2]]; // the browser's bits: left, right, middle; and the program's numbers
let heldButtons = 0; // bits
const fingers = new Map(); // by id: where they are
let lastPointerWasTouch = false;

// While a button is held, the browser reports a change of another one as a move.
function setButtons(buttons) {
    for (const [bit, button] of programButtons)
        if ((buttons ^ heldButtons) & bit) tell('web_button', button, Boolean(buttons & bit));
    heldButtons = buttons;
}

function place(event) {
    return [event.clientX * devicePixelRatio, event.clientY * devicePixelRatio];
}

// The middle of two fingers, and how far apart they are.
function pairOf() {
    const [a, b] = [...fingers.values()];
    return {x: (a[0] + b[0]) / 2, y: (a[1] + b[1]) / 2, distance: Math.hypot(a[0] - b[0], a[1] - b[1])};
}

function onDown(event) {
    lastPointerWasTouch = event.pointerType === 'touch';
    if (lastPointerWasTouch) event.preventDefault(); // no mouse event after it, which would take the focus from a field
    if (document.activeElement !== typing) canvas.focus();
    canvas.setPointerCapture(event.pointerId);
    if (lastPointerWasTouch) fingers.set(event.pointerId, place(event));
    if (fingers.size > 1) {
        // The first finger was not a click, so it is released where nothing is.
        tell('web_pointer', -1e9, -1e9);
        setButtons(0);
        return;
    }
    tell('web_key', 0, true, event.ctrlKey || event.metaKey, event.shiftKey, event.altKey);
    tell('web_pointer', ...place(event));
    setButtons(event.buttons);
}

function onMove(event) {
    if (!fingers.has(event.pointerId)) {
        tell('web_pointer', ...place(event));
        setButtons(event.buttons);
        return;
    }
    const before = fingers.size === 2 ? pairOf() : null;
    fingers.set(event.pointerId, place(event));
    if (!before) {
        if (fingers.size === 1) tell('web_pointer', ...place(event));
        return;
    }
    const now = pairOf();
    const pixelsPerStep = 60 * devicePixelRatio;
    tell('web_pointer', now.x, now.y);
    const spread = (now.distance - before.distance) / pixelsPerStep;
    const moved = [(now.x - before.x) / pixelsPerStep, (now.y - before.y) / pixelsPerStep];
    if (Math.abs(spread) > Math.hypot(...moved)) tell('web_wheel', 0, spread);
    else tell('web_wheel', ...moved);
}

function onUp(event) {
    const wasPair = fingers.size > 1;
    const wasFinger = fingers.delete(event.pointerId);
    if (wasFinger && wasPair) return;
    tell('web_pointer', ...place(event));
    if (event.type === 'pointercancel') tell('web_leave');
    setButtons(wasFinger ? 0 : event.buttons);
    // What the tap brings up must be known before this event is over: only then may a page show the keyboard.
    for (let i = 0; wasFinger && i < 3; ++i) drawFrame();
}

// What an on-screen keyboard writes, after a mark, so that a Backspace has something to delete.
const typingMark = '\u200b';

function takeTyped() {
    const isErased = !typing.value.startsWith(typingMark);
    if (isErased) for (const isDown of [true, false]) tell('web_key', 259, isDown, false, false, false);
    const letters = typing.value.replace(typingMark, '');
    if (letters) tell('web_letters', letters);
    typing.value = typingMark;
}

function onWheel(event) {
    event.preventDefault();
    const perStep = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 100 : event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 3 : 1;
    tell('web_pointer', ...place(event));
    tell('web_wheel', -event.deltaX / perStep, -event.deltaY / perStep);
}

// ---- Files of the student ------------------------------------------------------------------------

const largestFiles = 512 * 2 ** 20; // bytes, of everything opened
const longRead = 4 * 2 ** 20; // bytes from which reading takes a while

// Which of several files is opened: a view or a lesson if there is one, or else a scene, or else a model.
const openedFirst = [/\.walk\.toml$/i, /(^|\/)\d\d-[^/]*\.md$/i, /\.toml$/i, /\.obj$/i, /./];
let openedCount = 0, openedSize = 0;

// Files opened together are kept together, so a scene finds its model, and a model its textures.
async function openFiles(files, isResult) {
    if (!files.length) return;
    const size = files.reduce((sum, {file}) => sum + file.size, 0);
    if (openedSize + size > largestFiles) {
        tell('web_say', 'With what was opened before, that is more than 512 MB. Reload the page and open fewer files.');
        return;
    }
    openedSize += size;
    const first = openedFirst.map(pattern => files.find(({name}) => pattern.test(name))).find(Boolean);
    const main = isResult ? files[0] : first;
    try {
        // A model finds its files in neighbouring folders too, so each opening has a parent of its own.
        const folder = `/opened/${++openedCount}/files`;
        for (const {name, file} of files) {
            const path = folder + '/' + name;
            FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
            FS.writeFile(path, new Uint8Array(await file.arrayBuffer()));
        }
        if (size > longRead) {
            tell('web_say', `Reading ${main.name}. The page will not respond until this is done.`);
            await pictures(3);
        }
        tell('web_open', folder + '/' + main.name, isResult);
    } catch (fault) {
        tell('web_say', `${main.name} cannot be read: ${fault.message}`);
    }
}

const mostEntries = 1000; // of a folder

const pictures = count => count > 0 ? new Promise(requestAnimationFrame).then(() => pictures(count - 1)) : null;

// All files that were dropped, including those in folders: [{name, file}].
async function filesOf(entry, folder = '') {
    if (entry.isFile) {
        const file = await new Promise((done, failed) => entry.file(done, failed));
        return [{name: folder + entry.name, file}];
    }
    const reader = entry.createReader(), entries = [];
    for (;;) {
        const some = await new Promise((done, failed) => reader.readEntries(done, failed));
        if (!some.length) break;
        entries.push(...some);
        if (entries.length > mostEntries) throw new Error(`the folder ${entry.name} holds more than ${mostEntries} files`);
    }
    const parts = await Promise.all(entries.map(inner => filesOf(inner, folder + entry.name + '/')));
    return parts.flat();
}

async function onDrop(event) {
    event.preventDefault();
    const items = [...event.dataTransfer.items].filter(item => item.kind === 'file');
    const plain = [...event.dataTransfer.files].map(file => ({name: file.name, file}));
    const entries = items.map(item => item.webkitGetAsEntry && item.webkitGetAsEntry()).filter(Boolean);
    try {
        const found = entries.some(entry => entry.isDirectory)
            ? (await Promise.all(entries.map(entry => filesOf(entry)))).flat() : plain;
        await openFiles(found, false);
    } catch (fault) {
        tell('web_say', `What was dropped cannot be read: ${fault.message}`);
    }
}

// ---- Files of the page ---------------------------------------------------------------------------

// lessons/files.txt lists what is in the page's lessons folder but not in rasterwalk.data: one path
// per line, and its size if that is known. lessons/own.txt, if it is there, lists what a teacher has
// added. Texts are fetched at once, the rest when the program looks at it.
const lists = ['files.txt', 'own.txt'];

const fetchText = path => fetch(addressOf(path), {cache: 'no-cache'}).then(answer => answer.ok ? answer.arrayBuffer() : null).catch(() => null);

async function listedFiles() {
    const texts = await Promise.all(lists.map(fetchText));
    const lines = texts.flatMap(text => text ? new TextDecoder().decode(text).split(/\r?\n/) : []);
    // Sorted by path, a file comes before any path that takes it for a folder.
    const entries = lines.map(entryOf).filter(Boolean).sort((a, b) => a.path < b.path ? -1 : a.path > b.path ? 1 : 0);
    await Promise.all(entries.filter(({path}) => /\.(md|toml)$/.test(path)).map(async entry => {
        const text = await fetchText(entry.path);
        if (text) entry.bytes = new Uint8Array(text);
        else entry.isMissing = true;
    }));
    return entries;
}

// Only files in that folder; they have an extension, so no folder is taken for a file.
function entryOf(line) {
    const [, path, size] = /^\s*(?:\.\/)?([^#\s].*?)(?:\s+(\d+))?\s*$/.exec(line) || [];
    if (!path) return null;
    const isInside = path.split('/').every(part => part && !/^\.+$/.test(part) && !/[\\\p{Cc}]/u.test(part)) && /\.[^/]+$/.test(path);
    if (!isInside) console.warn(`lessons: the list holds ${path}, which is not a file in this folder or below it.`);
    return isInside ? {path, size: size && Number(size)} : null;
}

const addressOf = path => 'lessons/' + path.split('/').map(encodeURIComponent).join('/');

function fetchNow(path) {
    const request = new XMLHttpRequest();
    request.open('GET', addressOf(path), false);
    // As text, because a synchronous request cannot ask for an ArrayBuffer.
    request.overrideMimeType('text/plain; charset=x-user-defined');
    request.send();
    if (request.status !== 200) throw new Error(String(request.status));
    return Uint8Array.from(request.responseText, letter => letter.charCodeAt(0) & 0xff);
}

function putFile({path, size, bytes}) {
    const whole = '/lessons/' + path;
    FS.mkdirTree(whole.slice(0, whole.lastIndexOf('/')));
    FS.writeFile(whole, bytes || new Uint8Array());
    if (bytes) return;
    const node = FS.lookupPath(whole).node;
    const load = () => {
        if (!bytes) {
            try {
                bytes = fetchNow(path);
            } catch (fault) {
                throw new FS.ErrnoError(29); // EIO
            }
            node.contents = bytes;
            node.usedBytes = bytes.length;
        }
        return bytes.length;
    };
    const {read, mmap} = node.stream_ops;
    const {getattr} = node.node_ops;
    node.stream_ops = {...node.stream_ops,
        read: (...values) => { load(); return read(...values); },
        mmap: (...values) => { load(); return mmap(...values); }};
    node.node_ops = {...node.node_ops,
        getattr: inner => ({...getattr(inner), size: bytes ? bytes.length : size === undefined ? load() : size})};
}

// ---- The beginning -------------------------------------------------------------------------------

if (location.protocol === 'file:') {
    page.say('A browser can run Rasterwalk only from a web server. Run ./run web in the program folder to start one.');
}

const listed = listedFiles();

var Module = {
    canvas,
    noInitialRun: true,
    preRun: [() => {
        ENV.XDG_STATE_HOME = '/state';
        ENV.HOME = '/saved';
    }],
    onAbort: stop,
    onRuntimeInitialized: () => start().catch(stop),
};

async function start() {
    for (const folder of [stateFolder, '/saved', '/opened']) FS.mkdirTree(folder);
    FS.chdir('/saved');
    for (const name of keptFiles) {
        const text = stored(name);
        if (text !== null) FS.writeFile(stateFolder + '/' + name, text);
    }
    for (const entry of await listed) {
        try {
            if (entry.isMissing) throw new Error('the file is missing');
            putFile(entry);
        } catch (fault) {
            console.warn(`lessons: the list holds ${entry.path}, which cannot be used: ${fault.message}`);
        }
    }
    const [address, ...fragment] = location.href.slice(0, longestText).split('#');
    if (callMain([address, fragment.join('#')]) !== 0) return;
    isRunning = true;
    listen();
    wake();
}

// On another screen, or zoomed, the canvas has a different number of pixels, though its size stays.
function watchPixels() {
    try {
        new ResizeObserver(wake).observe(canvas, {box: 'device-pixel-content-box'});
    } catch (fault) {
        // Safari does not report these; there the change is noticed at the next event.
    }
}

function listen() {
    watchPixels();
    window.addEventListener('keydown', onKey);
    window.addEventListener('keyup', onKey);
    window.addEventListener('blur', () => tell('web_leave'));
    window.addEventListener('resize', wake);
    window.addEventListener('pagehide', () => call('web_keep'));
    window.addEventListener('hashchange', () => tell('web_go', location.hash));
    window.addEventListener('paste', event => {
        event.preventDefault();
        tell('web_paste', event.clipboardData.getData('text'));
    });
    window.addEventListener('contextmenu', event => event.preventDefault());
    window.addEventListener('dragover', event => event.preventDefault());
    window.addEventListener('drop', onDrop);
    // Another page of the program has kept something; what this page keeps next adds to it.
    window.addEventListener('storage', event => {
        const name = keptFiles.find(kept => event.key === storePrefix + kept);
        if (name && event.newValue !== null) FS.writeFile(stateFolder + '/' + name, event.newValue);
    });
    canvas.addEventListener('pointerdown', onDown);
    canvas.addEventListener('pointermove', onMove);
    canvas.addEventListener('pointerup', onUp);
    canvas.addEventListener('pointercancel', onUp);
    canvas.addEventListener('pointerleave', event => { if (!event.buttons && event.pointerType !== 'touch') tell('web_pointer', -1e9, -1e9); });
    canvas.addEventListener('wheel', onWheel, {passive: false});
    canvas.addEventListener('webglcontextlost', event => { event.preventDefault(); tell('web_context', 1); });
    canvas.addEventListener('webglcontextrestored', () => tell('web_context', 0));
    typing.addEventListener('input', event => { if (!event.isComposing) takeTyped(); });
    typing.addEventListener('compositionend', takeTyped);
}

window.addEventListener('error', event => {
    if (!isRunning) stop(new Error(event.message || `${event.target.src} is missing`));
}, true);
