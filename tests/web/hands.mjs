// Mouse, keys, clipboard and fingers.

import {pause, until, Visit} from './browser.mjs';
import {equal, holds, test} from './checks.mjs';

export function testHands(place) {
    const {browser} = place;
    const open = async (fragment, options) => (await Visit.begin(browser, place.site, options)).go(fragment);

    test('A click reaches the widget under it, also a quick one', async () => {
        const program = await open('#stage=depth');
        await program.click('stage.rows');
        equal(await program.setting('stage'), 'rows', 'the stage after a click on it');
        const {x, y} = await program.place('stage.fill');
        await program.page.evaluate(([x, y]) => {
            // Both within one frame, as with a fast hand or a slow computer.
            const canvas = document.getElementById('canvas');
            const event = (type, buttons) => new PointerEvent(type, {clientX: x, clientY: y, button: 0, buttons, pointerId: 1, pointerType: 'mouse', bubbles: true});
            canvas.setPointerCapture = () => undefined;
            for (const [type, buttons] of [['pointermove', 0], ['pointerdown', 1], ['pointerup', 0]]) canvas.dispatchEvent(event(type, buttons));
        }, [x, y]);
        await program.rest();
        equal(await program.setting('stage'), 'fill', 'the stage after a click shorter than a frame');
    });

    test('Keys reach the program', async () => {
        const program = await open('#scene=scenes/lab-room.toml&stage=rows');
        await program.press('5');
        equal(await program.setting('stage'), 'depth', 'the stage after 5');
        await program.press('Control+z');
        equal(await program.setting('stage'), 'rows', 'the stage after Ctrl+Z');
        await program.press('Control+Shift+Z');
        equal(await program.setting('stage'), 'depth', 'the stage after Ctrl+Shift+Z');
        const before = await program.setting('camera.yaw');
        await program.page.keyboard.down('ArrowRight');
        await pause(400);
        await program.page.keyboard.up('ArrowRight');
        await program.rest();
        const after = await program.setting('camera.yaw');
        holds(before !== undefined && after !== before, `An arrow has not moved the camera: ${after}`);
    });

    test('A key that is held when the page is left is let go', async () => {
        const program = await open('#scene=scenes/lab-room.toml&stage=points');
        await program.page.keyboard.down('ArrowRight');
        await pause(200);
        await program.page.evaluate(() => window.dispatchEvent(new Event('blur')));
        await program.rest();
        const frames = await program.frames();
        await pause(500);
        equal(await program.frames(), frames, 'frames drawn after the page was left');
        await program.page.keyboard.up('ArrowRight');
    });

    test("F5 and Ctrl+S are the program's; Ctrl+R, Ctrl+T and F11 are the browser's", async () => {
        const program = await open('#lesson=05-row-table&step=3');
        await program.page.evaluate(() => { window.isSamePage = true; });
        await program.press('F5');
        equal(await program.page.evaluate(() => window.isSamePage), true, 'the page is the one before F5');
        holds(await program.has('lecture.leave'), 'F5 has not begun the lecture.');
        await program.press('Escape');
        holds(!await program.has('lecture.leave'), 'Escape has not ended the lecture.');
        const isLeft = (key, code, more = {}) => program.page.evaluate(([key, code, more]) => {
            const event = new KeyboardEvent('keydown', {key, code, bubbles: true, cancelable: true, ...more});
            const isLeft = document.getElementById('canvas').dispatchEvent(event);
            window.dispatchEvent(new KeyboardEvent('keyup', {key, code}));
            return isLeft;
        }, [key, code, more]);
        for (const [key, code, more, expected] of [
            ['r', 'KeyR', {ctrlKey: true}, true], ['t', 'KeyT', {ctrlKey: true}, true], ['w', 'KeyW', {ctrlKey: true}, true],
            ['f', 'KeyF', {ctrlKey: true}, true], ['v', 'KeyV', {ctrlKey: true}, true], ['+', 'Equal', {ctrlKey: true}, true],
            ['-', 'Minus', {ctrlKey: true}, true], ['0', 'Digit0', {ctrlKey: true}, true], ['F11', 'F11', {}, true],
            ['z', 'KeyZ', {ctrlKey: true}, false], ['c', 'KeyC', {ctrlKey: true}, false], [',', 'Comma', {ctrlKey: true}, false],
            ['Tab', 'Tab', {}, false], ['PageDown', 'PageDown', {}, false], [' ', 'Space', {}, false],
            ['ArrowLeft', 'ArrowLeft', {altKey: true}, false], ['ArrowUp', 'ArrowUp', {ctrlKey: true}, false],
        ]) {
            equal(await isLeft(key, code, more), expected, `${JSON.stringify(more)} ${key} is left to the browser`);
        }
    });

    test('The letter on a key counts, and on keyboards without Latin letters its place', async () => {
        const program = await open('#scene=scenes/lab-room.toml&stage=depth');
        const press = async (key, code) => {
            await program.page.evaluate(([key, code]) => {
                for (const type of ['keydown', 'keyup']) window.dispatchEvent(new KeyboardEvent(type, {key, code, bubbles: true, cancelable: true}));
            }, [key, code]);
            await program.rest();
        };
        equal(await program.setting('depth_test'), 'inverse_z', 'the depth test'); // as the stage sets it
        await press('z', 'KeyY'); // a German keyboard
        const off = await program.setting('depth_test');
        holds(off !== 'inverse_z', 'Z of a German keyboard has not switched the depth test off.');
        await press('я', 'KeyZ'); // a Russian one
        equal(await program.setting('depth_test'), 'inverse_z', 'the depth test after Z of a Russian keyboard');
    });

    test('Letters are typed into a field, and Ctrl+V pastes into it', async () => {
        const program = await open('#scene=scenes/lab-room.toml&stage=depth');
        await program.press('Control+,');
        holds(await program.has('settings.search'), 'Ctrl+, has not opened the settings.');
        await program.click('settings.search');
        await program.type('interpol');
        equal(await program.setting('stage'), 'depth', 'the stage after typing into a field');
        holds(await program.has('setting.interpolation'), 'What was typed does not find setting.interpolation.');
        holds(!await program.has('setting.rounding'), 'What was typed does not leave out setting.rounding.');
        await program.press('Control+a');
        await program.page.evaluate(() => navigator.clipboard.writeText('rounding'));
        await program.press('Control+v');
        await until(() => program.has('setting.rounding'), 'what was pasted finds setting.rounding', 5);
        holds(!await program.has('setting.interpolation'), 'What was pasted has not replaced what was typed.');
        await program.press('Control+a', 'Control+x');
        equal(await program.copied(), 'rounding', 'what Ctrl+X has taken');
        for (const letter of 'é„ß') {
            // Playwright has no such keys.
            await program.page.evaluate(key => document.getElementById('canvas').dispatchEvent(
                new KeyboardEvent('keydown', {key, code: 'KeyE', bubbles: true, cancelable: true})), letter);
            await program.page.evaluate(key => document.getElementById('canvas').dispatchEvent(
                new KeyboardEvent('keyup', {key, code: 'KeyE', bubbles: true})), letter);
        }
        await program.rest();
        await program.press('Control+a', 'Control+c');
        equal(await program.copied(), 'é„ß', 'what Ctrl+C has copied of letters beyond ASCII');
    });

    test('A shift of the middle button and the wheel move and zoom the picture', async () => {
        const program = await open('#scene=scenes/lab-room.toml&stage=depth');
        const picture = async () => (await program.line('picture')).split(' ').map(Number);
        const {x, y} = await program.place('canvas');
        await program.page.mouse.move(x, y);
        const before = await picture();
        await program.page.mouse.wheel(0, -300);
        await program.rest();
        const zoomed = await picture();
        holds(zoomed[2] > before[2], `The wheel has not enlarged the picture: ${before} and then ${zoomed}`);
        const under = ([left, top, scale]) => [(x - left) / scale, (y - top) / scale];
        holds(Math.hypot(under(before)[0] - under(zoomed)[0], under(before)[1] - under(zoomed)[1]) < 1.5,
            `What lies under the pointer has moved: ${under(before)} and then ${under(zoomed)}`);
        await program.page.mouse.down();
        await program.page.mouse.move(x + 40, y + 25, {steps: 4});
        await program.page.mouse.up();
        await program.rest();
        const moved = await picture();
        holds(Math.hypot(moved[0] - zoomed[0] - 40, moved[1] - zoomed[1] - 25) < 8, `A drag by 40,25 has moved the picture from ${zoomed} to ${moved}.`);
    });

    test('Ctrl+C copies a command line, and Ctrl+Shift+C a link that shows the same view', async () => {
        const program = await open('#lesson=05-row-table&step=3');
        await program.press('4', '.', 'Control+c');
        const line = await until(async () => (await program.copied()).startsWith('rasterwalk ') && program.copied(), 'a command line is copied', 5);
        holds(line.startsWith('rasterwalk --lesson 05-row-table --step 3'), `Copied was: ${line}`);
        await program.press('Control+Shift+C');
        const link = await until(async () => (await program.copied()).startsWith('http') && program.copied(), 'a link is copied', 5);
        holds(link.startsWith(place.site.url + '#lesson=05-row-table&step=3&'), `Copied was: ${link}`);
        const [settings, picture] = [reportedSettings(await program.report()), await program.picture()];
        const other = await program.visit.go(link.slice(place.site.url.length));
        equal(reportedSettings(await other.report()), settings, 'the settings in a page opened by the link');
        holds(picture.equals(await other.picture()), 'The page opened by the link shows another picture.');
    });

    test('Without a clipboard the text is shown, to be copied by hand', async () => {
        const visit = await Visit.begin(browser, place.site);
        await visit.context.addInitScript(() => Object.defineProperty(navigator, 'clipboard', {value: undefined}));
        const program = await visit.go('#lesson=05-row-table&step=3');
        const asked = new Promise(done => program.page.once('dialog', dialog => { done(dialog.defaultValue()); dialog.dismiss(); }));
        await program.press('Control+c');
        equal(await asked, 'rasterwalk --lesson 05-row-table --step 3', 'what is shown');
    });

    test('A tap is a click, and two fingers zoom the picture without one', async () => {
        const program = await open('#scene=scenes/lab-room.toml&stage=depth', {hasTouch: true, viewport: {width: 1280, height: 800}, deviceScaleFactor: 1.5});
        const {x, y} = await program.place('stage.rows');
        await program.page.touchscreen.tap(x, y);
        await program.rest();
        equal(await program.setting('stage'), 'rows', 'the stage after a tap on it');
        const before = (await program.line('picture')).split(' ').map(Number);
        const undoBefore = reportedSettings(await program.report());
        const canvas = await program.place('canvas');
        const touch = (type, ...distances) => program.protocol.send('Input.dispatchTouchEvent', {
            type, touchPoints: distances.map((distance, id) => ({x: canvas.x + distance, y: canvas.y, id})),
        });
        await touch('touchStart', -40);
        await touch('touchStart', -40, 40);
        for (let spread = 50; spread <= 160; spread += 10) await touch('touchMove', -spread, spread);
        await touch('touchEnd');
        await program.rest();
        const after = (await program.line('picture')).split(' ').map(Number);
        holds(after[2] > before[2] * 1.2, `Two fingers have not enlarged the picture: ${before} and then ${after}`);
        equal(reportedSettings(await program.report()), undoBefore, 'the settings after two fingers');
        await program.page.touchscreen.tap(x, y);
        await program.rest();
        await program.page.touchscreen.tap((await program.place('stage.fill')).x, y);
        await program.rest();
        equal(await program.setting('stage'), 'fill', 'the stage after a tap that follows two fingers');
    });

    test('A finger on a field brings up the keys of the screen, and what they type arrives', async () => {
        const program = await open('#scene=scenes/lab-room.toml&stage=depth', {hasTouch: true});
        await program.press('Control+,');
        const {x, y} = await program.place('settings.search');
        await program.page.touchscreen.tap(x, y);
        await program.rest();
        equal(await program.page.evaluate(() => document.activeElement.id), 'typing', 'what has the keyboard');
        await program.page.keyboard.insertText('rounding');
        await program.rest();
        await until(() => program.has('setting.rounding'), 'what was typed finds setting.rounding', 5);
        holds(!await program.has('setting.interpolation'), 'What was typed does not leave out setting.interpolation.');
        await program.press('Backspace');
        await program.type('g');
        holds(await program.has('setting.rounding'), 'Backspace or a letter has been lost or doubled.');
    });
}

export const reportedSettings = report => report.split('\n').filter(line => /^(setting|cursor) /.test(line)).join('\n');
