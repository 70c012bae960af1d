// What the browser keeps.

import {until, Visit} from './browser.mjs';
import {equal, holds, test} from './checks.mjs';

const kept = (program, name) => program.page.evaluate(name =>
    Object.entries(localStorage).find(([key]) => key.endsWith(':' + name))?.[1] ?? '', name);

/// The kept record of the steps of a lesson that were shown.
const keptSteps = async (program, lesson) => {
    const text = await kept(program, 'progress.toml');
    const at = text.indexOf(`[lessons.${lesson}]`);
    return at < 0 ? [] : JSON.parse(/steps = (\[[^\]]*\])/.exec(text.slice(at))?.[1] ?? '[]');
};

/// Acts as if the window were on a different screen, and moves the mouse.
async function usePixels(program, factor) {
    await program.protocol.send('Emulation.setDeviceMetricsOverride', {width: 1600, height: 1000, deviceScaleFactor: factor, mobile: false});
    await program.page.mouse.move(3, 3);
    await program.page.mouse.move(5, 5);
    await until(async () => await program.line('window') === `${1600 * factor} ${1000 * factor}`, 'the window has the pixels of the screen', 5);
    await program.rest();
}

export function testStorage(place) {
    const {browser} = place;

    test('Progress and options are kept over a reload', async () => {
        const visit = await Visit.begin(browser, place.site);
        let program = await visit.go('#lesson=05-row-table&step=3');
        await program.press('PageDown');
        await until(async () => (await keptSteps(program, '05-row-table')).includes(4), 'step 4 of lesson 5 is kept', 8);
        const before = await program.place('stage.rows');
        await chooseTheme(program);
        await program.click('text.larger');
        await until(async () => /theme = ['"]light['"]/.test(await kept(program, 'window.toml')), 'the theme is kept', 8);
        const larger = await program.place('stage.rows');
        holds(larger.bottom - larger.top > before.bottom - before.top, 'The text is not larger.');
        const theme = await groundColour(program);
        await program.reload();
        const after = await program.place('stage.rows');
        equal(after.bottom - after.top, larger.bottom - larger.top, 'the height of a button after a reload');
        equal(await groundColour(program), theme, 'the colour of the ground after a reload');
        await program.close();
        program = await visit.go();
        equal(await kept(program, 'progress.toml').then(text => text.includes('05-row-table')), true, 'lesson 5 is in what is kept');
    });

    test('The text keeps its size on a screen with other pixels', async () => {
        const visit = await Visit.begin(browser, place.site);
        let program = await visit.go('#lesson=05-row-table&step=3');
        await program.click('text.larger');
        const height = async () => { const {top, bottom} = await program.place('stage.rows'); return bottom - top; };
        const before = await height();
        await until(async () => /text_scale/.test(await kept(program, 'window.toml')), 'the text size is kept', 8);
        const isSame = async what => {
            const now = await height();
            holds(Math.abs(now - before) <= 1, `${what}: a button is ${now} pixels of CSS high, and was ${before}.`);
        };
        const metrics = factor => usePixels(program, factor);
        await metrics(2);
        await until(async () => (await program.line('window')) === '3200 2000', 'the window has twice the pixels', 5);
        await program.rest();
        await isSame('with twice the pixels');
        await program.reload();
        await isSame('with twice the pixels, after a reload');
        await metrics(1);
        await until(async () => (await program.line('window')) === '1600 1000', 'the window has its pixels back', 5);
        await program.rest();
        await isSame('with single pixels again');
        const storageState = await visit.context.storageState();
        await visit.close();
        const other = await Visit.begin(browser, place.site, {deviceScaleFactor: 1.5, storageState});
        program = await other.go('#lesson=05-row-table&step=3');
        await isSame('at another visit with half as many pixels more');
    });

    test('Two pages with other pixels do not change the size of each other\'s text', async () => {
        const visit = await Visit.begin(browser, place.site);
        const first = await visit.go('#lesson=05-row-table&step=3');
        const heightIn = async program => { const {top, bottom} = await program.place('stage.rows'); return bottom - top; };
        const before = await heightIn(first);
        const second = await visit.go('#lesson=08-depth-buffer&step=1');
        await usePixels(second, 2);
        await until(async () => (await second.line('window')) === '3200 2000', 'the window has twice the pixels', 5);
        await second.press('PageDown');
        await until(async () => (await keptSteps(second, '08-depth-buffer')).includes(2), 'a step is kept', 8);
        await first.press('PageDown');
        await until(async () => (await keptSteps(first, '05-row-table')).includes(4), 'a step is kept', 8);
        await second.close();
        await first.reload();
        const now = await heightIn(first);
        holds(Math.abs(now - before) <= 1, `After a reload a button is ${now} pixels of CSS high, and was ${before}.`);
    });

    test("Two pages at once do not lose each other's progress", async () => {
        const visit = await Visit.begin(browser, place.site);
        const first = await visit.go('#lesson=05-row-table&step=1');
        const second = await visit.go('#lesson=08-depth-buffer&step=1');
        for (let round = 0; round < 3; ++round) {
            await first.press('PageDown');
            await second.press('PageDown');
        }
        const has = async (lesson, steps) => {
            const seen = await keptSteps(first, lesson);
            return steps.every(step => seen.includes(step));
        };
        await until(() => has('05-row-table', [1, 2, 3, 4]), 'the steps of the first page are kept', 8);
        await until(() => has('08-depth-buffer', [1, 2, 3, 4]), 'the steps of the second page are kept', 8);
        await Promise.all([first, second].map(program => program.close()));
        const third = await visit.go('#lesson=03-points&step=1');
        await until(async () => (await keptSteps(third, '03-points')).includes(1), 'the steps of a third page are kept', 8);
        for (const lesson of ['05-row-table', '08-depth-buffer']) equal(await keptSteps(third, lesson).then(steps => steps.includes(4)), true, `step 4 of ${lesson} is kept`);
    });

    test('What is kept and cannot be understood is told, and the program goes on', async () => {
        const visit = await Visit.begin(browser, place.site);
        let program = await visit.go('#lesson=05-row-table&step=1');
        await until(() => kept(program, 'progress.toml'), 'progress is kept', 8);
        await program.page.evaluate(() => {
            for (const key of Object.keys(localStorage)) if (key.endsWith('.toml')) localStorage.setItem(key, 'this = is [ no TOML');
        });
        await program.reload();
        holds(await program.has('status.trouble'), 'Nothing is said at the bottom.');
        await program.press('PageDown');
        equal(await program.hash(), '#lesson=05-row-table&step=2', 'the address after Page down');
    });

    for (const [words, script] of [
        ['is turned off', () => Object.defineProperty(window, 'localStorage', {get() { throw new DOMException('Access is denied.', 'SecurityError'); }})],
        ['is full', () => { Storage.prototype.setItem = () => { throw new DOMException('The quota is exceeded.', 'QuotaExceededError'); }; }],
    ]) {
        test(`Storage that ${words} is told in a sentence, and the program goes on`, async () => {
            const visit = await Visit.begin(browser, place.site);
            await visit.context.addInitScript(script);
            const program = await visit.go('#lesson=05-row-table&step=3');
            await program.waitForWords('This browser keeps nothing for this page, so what you do here is lost when you leave.');
            await program.press('PageDown');
            equal(await program.hash(), '#lesson=05-row-table&step=4', 'the address after Page down');
            await program.press('5');
            equal(await program.setting('stage'), 'depth', 'the stage after 5');
        });
    }
}

async function chooseTheme(program) {
    await program.click('menu.View');
    const name = (await program.widgets('menu.view.')).find(name => /theme|light/.test(name));
    holds(name, `The menu has no theme: ${await program.widgets('menu.view.')}`);
    await program.click(name);
}

/// The colour at the corner of the page.
async function groundColour(program) {
    const {readPng} = await import('./png.mjs');
    const {rows, channels} = readPng(await program.page.screenshot());
    return [...rows.at(-3).subarray(3 * channels, 3 * channels + 3)].join(',');
}
