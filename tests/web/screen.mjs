// What the page does with the screen.

import {writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {pause, until, Visit} from './browser.mjs';
import {equal, holds, test} from './checks.mjs';
import {firstDifference} from './png.mjs';

export function testScreen(place) {
    const {browser} = place;
    const open = async (fragment, options) => (await Visit.begin(browser, place.site, options)).go(fragment);

    test('A page on which nothing happens draws nothing', async () => {
        for (const fragment of ['', '#lesson=05-row-table&step=3', '#scene=models/teapot.obj&stage=pixel_light']) {
            const program = await open(fragment);
            await pause(500);
            const frames = await program.frames();
            await pause(2000);
            equal(await program.frames(), frames, `frames drawn after two seconds at '${fragment}'`);
        }
    });

    test('The program follows the size of the window and its pixels', async () => {
        const program = await open('#lesson=05-row-table&step=3');
        equal(await program.line('window'), '1600 1000', 'the window');
        for (const [width, height] of [[1024, 700], [400, 700], [700, 320], [2400, 1300]]) {
            await program.page.setViewportSize({width, height});
            await until(async () => await program.line('window') === `${width} ${height}`, `the window has ${width} x ${height} pixels`, 5);
            await program.rest();
            holds(await program.has('canvas'), `With ${width} x ${height} pixels no picture is on the screen.`);
        }
        const sharp = await open('#scene=scenes/lab-room.toml&stage=rows', {deviceScaleFactor: 2, viewport: {width: 1500, height: 900}});
        equal(await sharp.line('window'), '3000 1800', 'the window where a pixel of CSS is two');
        await sharp.click('stage.depth');
        equal(await sharp.setting('stage'), 'depth', 'the stage after a click where a pixel of CSS is two');
    });

    test('A window that goes to a screen with other pixels is drawn in these with the next event', async () => {
        const program = await open('#lesson=05-row-table&step=3');
        await program.protocol.send('Emulation.setDeviceMetricsOverride', {width: 1600, height: 1000, deviceScaleFactor: 2, mobile: false});
        // Chromium does not report the change when it is only emulated.
        await program.page.mouse.move(3, 3);
        await until(async () => await program.line('window') === '3200 2000', 'the window has twice the pixels', 5);
    });

    test('A lost context comes back with everything that was on the screen', async () => {
        for (const fragment of ['', '#lesson=05-row-table&step=3', '#scene=models/globe.obj&stage=pixel_light&tab=texture&pixel=250,250']) {
            const program = await open(fragment);
            await program.page.mouse.move(5, 5);
            await program.rest();
            const before = await program.page.screenshot();
            await program.page.evaluate(() => {
                window.lost = document.getElementById('canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
                window.lost.loseContext();
            });
            await pause(300);
            await program.page.evaluate(() => new Promise(done => {
                document.getElementById('canvas').addEventListener('webglcontextrestored', () => done(), {once: true});
                window.lost.restoreContext();
            }));
            await program.rest();
            await pause(200);
            const after = await program.page.screenshot();
            if (!before.equals(after)) {
                writeFileSync(join(place.folder, 'before.png'), before);
                holds(false, `at '${fragment}' the screen after it is another: ${firstDifference(after, before)}`);
            }
            await program.press('2', '4');
            const click = await program.findPlace('stage.rows');
            if (click) {
                await program.click('stage.rows');
                equal(await program.setting('stage'), 'rows', 'the stage after a click on it');
            }
        }
    });

    test('Without WebGL 2 the page says so', async () => {
        const visit = await Visit.begin(browser, place.site);
        await visit.context.addInitScript(() => {
            const real = HTMLCanvasElement.prototype.getContext;
            HTMLCanvasElement.prototype.getContext = function (kind, ...rest) { return kind === 'webgl2' ? null : real.call(this, kind, ...rest); };
        });
        const page = await visit.context.newPage();
        await page.goto(place.site.url);
        const says = () => page.evaluate(() => document.getElementById('sentence').textContent);
        await until(async () => !(await says()).includes('Loading'), 'the page says something', 20);
        holds((await says()).startsWith('Rasterwalk needs WebGL 2'), `The page says: ${await says()}`);
        visit.messages = visit.messages.filter(text => !/webgl|exit/i.test(text));
    });

    test('The pointer and the language of the page are set', async () => {
        const program = await open('#scene=scenes/lab-room.toml&stage=depth');
        const cursor = () => program.page.evaluate(() => getComputedStyle(document.getElementById('canvas')).cursor);
        const splitter = await program.place('splitter.lesson');
        await program.page.mouse.move(splitter.x, splitter.y);
        await program.rest();
        equal(await cursor(), 'ew-resize', 'the pointer on a border between two columns');
        const canvas = await program.place('canvas');
        await program.page.mouse.move(canvas.x, canvas.y);
        await program.rest();
        equal(await cursor(), 'default', 'the pointer on the picture');
    });
}
