// A browser with the page in it: what a student does, and what can be seen of it.

import {createReadStream, existsSync, readdirSync, statSync} from 'node:fs';
import {createServer} from 'node:http';
import {createRequire} from 'node:module';
import {extname, join, relative} from 'node:path';
import {Failure} from './checks.mjs';

const packages = new URL('../../build/web-tests/', import.meta.url); // `./test web` installs them
const {chromium} = createRequire(packages)('playwright-core');

// ---- A site --------------------------------------------------------------------------------------

const types = {
    '.html': 'text/html; charset=utf-8', '.js': 'text/javascript; charset=utf-8', '.wasm': 'application/wasm',
    '.data': 'application/octet-stream', '.png': 'image/png', '.md': 'text/markdown; charset=utf-8',
    '.txt': 'text/plain; charset=utf-8', '.toml': 'text/plain; charset=utf-8',
};

/// The files of a folder, under the names that a web server gives them.
export function filesOf(folder) {
    return readdirSync(folder, {recursive: true, withFileTypes: true})
        .filter(entry => entry.isFile())
        .map(entry => relative(folder, join(entry.parentPath ?? entry.path, entry.name)));
}

/// Serves a folder to this computer: {url, asked, close}. `asked` lists the paths that were requested.
export async function serve(folder, path = '/') {
    const asked = [];
    const known = new Set(filesOf(folder));
    const server = createServer((request, answer) => {
        const wanted = decodeURIComponent(new URL(request.url, 'http://page').pathname);
        asked.push(wanted);
        let name = wanted.startsWith(path) ? wanted.slice(path.length) : '';
        if (wanted === path) name = 'index.html';
        if (!known.has(name)) {
            answer.writeHead(404, {'Content-Type': 'text/plain'}).end('There is no such file.');
            return;
        }
        const file = join(folder, name);
        answer.writeHead(200, {
            'Content-Type': types[extname(file)] ?? 'application/octet-stream', 'Content-Length': statSync(file).size,
        });
        createReadStream(file).pipe(answer);
    });
    await new Promise(done => server.listen(0, '127.0.0.1', done));
    return {
        url: `http://127.0.0.1:${server.address().port}${path}`, asked, folder,
        files: [...known],
        close: () => new Promise(done => { server.close(done); server.closeAllConnections(); }),
    };
}

// ---- A browser -----------------------------------------------------------------------------------

export function startBrowser() {
    const places = [process.env.RASTERWALK_CHROMIUM, '/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'];
    const executablePath = places.find(place => place && existsSync(place));
    if (!executablePath) throw new Error('Chromium is not installed; RASTERWALK_CHROMIUM can say where it is.');
    return chromium.launch({
        executablePath,
        args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
            '--disable-background-networking'],
    });
}

/// Waits until `look` gives something true, and returns it.
export async function until(look, what, seconds = 20) {
    const end = performance.now() + 1000 * seconds;
    for (;;) {
        const seen = await look();
        if (seen) return seen;
        if (performance.now() > end) throw new Failure(`Within ${seconds} s this did not come: ${what}.`);
        await pause(50);
    }
}
export const pause = milliseconds => new Promise(done => setTimeout(done, milliseconds));

/// A student's visit to a site: what one page keeps, the next finds again.
export class Visit {
    static open = new Set();

    /// @param options of Playwright's context: viewport, deviceScaleFactor, hasTouch, storageState
    static async begin(browser, site, options = {}) {
        const visit = new Visit();
        visit.site = site;
        visit.requests = [];
        visit.messages = [];
        visit.context = await browser.newContext({viewport: {width: 1600, height: 1000}, bypassCSP: true, ...options});
        await visit.context.grantPermissions(['clipboard-read', 'clipboard-write'], {origin: new URL(site.url).origin});
        visit.context.on('request', request => visit.requests.push(request.url()));
        visit.context.on('console', message => {
            // Most sites have no files of their own.
            if (!message.location().url.endsWith('/lessons/own.txt')) visit.messages.push(message.text());
        });
        visit.context.on('weberror', error => visit.messages.push(error.error().stack));
        Visit.open.add(visit);
        return visit;
    }

    /// The page at this place: the part after its #, or nothing.
    async go(fragment = '') {
        const program = new Program();
        program.visit = this;
        program.page = await this.context.newPage();
        program.page.on('filechooser', () => {}); // Chromium may miss a chooser that opens just after listening begins.
        program.protocol = await this.context.newCDPSession(program.page);
        await program.page.goto(this.site.url + fragment);
        await program.begin();
        return program;
    }

    /// Requests for anything but the files of the site.
    strangeRequests() {
        const known = new Set(['', 'lessons/own.txt', ...this.site.files].map(name => this.site.url + name.split('/').map(encodeURIComponent).join('/')));
        return this.requests.filter(url => !known.has(url.split('#')[0]) && !/^(blob:|data:)/.test(url));
    }

    async close() {
        Visit.open.delete(this);
        await this.context.close();
    }
}

/// One page with the program in it.
export class Program {
    /// Waits for the first picture.
    async begin() {
        const state = () => this.page.evaluate(() => window.eval('[isRunning, page.frames, sentence.hidden ? "" : sentence.textContent]'));
        try {
            await until(async () => (await state())[1] > 0, 'the first picture', 30);
        } catch (fault) {
            const [isRunning, frames, sentence] = await state();
            throw new Failure(`${fault.message} The program ${isRunning ? 'runs' : 'does not run'}, frames: ${frames}; the page says: ${sentence}`);
        }
        await this.rest();
    }

    /// Waits until nothing is drawn any more, except a blinking text cursor.
    async rest() {
        const isAtRest = await this.page.evaluate(() => window.eval(`(async () => {
            const end = performance.now() + 30000;
            let frames = -1, since = 0;
            while (performance.now() < end) {
                if (page.frames !== frames || request) [frames, since] = [page.frames, performance.now()];
                if (performance.now() - since > 130) return true;
                await new Promise(done => setTimeout(done, 20));
            }
            return false;
        })()`));
        if (!isAtRest) throw new Failure('The page still draws after 30 s.');
    }

    report() {
        return this.page.evaluate(() => Module.ccall('web_report', 'string', [], []));
    }
    frames() {
        return this.page.evaluate(() => window.eval('page.frames'));
    }
    hash() {
        return this.page.evaluate(() => location.hash);
    }

    /// The line of the report that begins with these words, without them.
    async line(words) {
        const line = (await this.report()).split('\n').find(text => text.startsWith(words + ' '));
        return line?.slice(words.length + 1);
    }
    setting(name) {
        return this.line('setting ' + name);
    }
    cursor() {
        return this.line('cursor');
    }

    /// Where a widget can be seen: pixels of CSS; undefined if it cannot.
    async findPlace(name) {
        const parts = (await this.report()).split('\n').map(text => text.split(' '))
            .find(words => words[0] === 'widget' && words.slice(5).join(' ') === name);
        if (!parts) return undefined;
        const ratio = await this.page.evaluate(() => devicePixelRatio);
        const [left, top, right, bottom] = parts.slice(1, 5).map(number => Number(number) / ratio);
        return {left, top, right, bottom, x: (left + right) / 2, y: (top + bottom) / 2};
    }
    async place(name) {
        const place = await this.findPlace(name);
        if (!place) throw new Failure(`There is no widget ${name} on the screen.`);
        return place;
    }
    async has(name) {
        return await this.findPlace(name) !== undefined;
    }
    /// The names of all widgets that begin with this.
    async widgets(beginning = '') {
        return (await this.report()).split('\n').filter(text => text.startsWith('widget '))
            .map(text => text.split(' ').slice(5).join(' ')).filter(name => name.startsWith(beginning));
    }

    async click(name, options = {}) {
        const {x, y} = await this.place(name);
        await this.page.mouse.click(x, y, options);
        await this.rest();
    }
    async press(...keys) {
        for (const key of keys) await this.page.keyboard.press(key);
        await this.rest();
    }
    async type(letters) {
        await this.page.keyboard.type(letters);
        await this.rest();
    }

    /// Goes to another place in the same page, as by a link in it or the browser's address bar.
    async follow(fragment) {
        await this.followAtOnce(fragment);
        await this.rest();
    }
    /// The same, without waiting until it is drawn.
    async followAtOnce(fragment) {
        await this.page.evaluate(fragment => new Promise(done => {
            window.addEventListener('hashchange', () => done(), {once: true});
            location.hash = fragment;
        }), fragment);
    }

    async reload() {
        await this.page.reload();
        await this.begin();
    }

    /// Does the line at the bottom say this?
    async hasSaid(words) {
        return (await this.line('notice'))?.includes(words) ?? false;
    }
    /// Waits until the line at the bottom says this.
    async waitForWords(words) {
        await until(() => this.hasSaid(words), `the program says “${words}”, not “${await this.line('notice') ?? ''}”`);
    }

    /// The picture that is shown, as PNG.
    async picture() {
        return Buffer.from(await this.page.evaluate(pictureInPage), 'base64');
    }

    /// Drops files and folders of this computer in the middle of the page.
    async drop(...paths) {
        await this.dropAtOnce(...paths);
        await pause(150);
        await this.rest();
    }
    async dropAtOnce(...paths) {
        const {width, height} = this.page.viewportSize();
        const data = {items: [], files: paths, dragOperationsMask: 1};
        for (const type of ['dragEnter', 'dragOver', 'drop']) {
            await this.protocol.send('Input.dispatchDragEvent', {type, x: width / 2, y: height / 2, data});
        }
    }

    /// What the browser saves while this is done: its name, and where it is now.
    async download(act) {
        const waiting = this.page.waitForEvent('download', {timeout: 15000});
        await act();
        const download = await waiting;
        return {name: download.suggestedFilename(), path: await download.path(), saveAs: path => download.saveAs(path)};
    }

    copied() {
        return this.page.evaluate(() => navigator.clipboard.readText());
    }

    async close() {
        await this.page.close();
    }
}

function pictureInPage() {
    Module.ccall('web_picture', null, ['string'], ['/test.png']);
    const bytes = window.eval('FS').readFile('/test.png');
    let text = '';
    for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
    return btoa(text);
}
