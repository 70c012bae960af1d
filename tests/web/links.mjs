// Links into the program, and the address that follows it.

import {serve, Visit} from './browser.mjs';
import {equal, holds, note, test} from './checks.mjs';
import {comparePicture} from './pictures.mjs';

/// The message for each wrong link.
const wrongLinks = [
    ['lesson=nonsense', "there is no lesson 'nonsense'"],
    ['lesson=05-row-tabel', "Did you mean '05-row-table'?"],
    ['lesson=05-row-table&step=99', 'step'],
    ['step=3', 'step can only be used with lesson.'],
    ['stage=nonsense', 'nonsense'],
    ['stage', 'which is not a name and a value, like step=3.'],
    ['stage=', 'without a value.'],
    ['stage=rows&stage=depth', 'twice.'],
    ['stage=%zz', 'but a % must be followed by two hexadecimal digits'],
    ['stage=%ff', 'which is not plain UTF-8 text on one line.'],
    ['stage=%0a', 'which is not plain UTF-8 text on one line.'],
    ['scene=../../etc/passwd', 'leads out of the lessons folder.'],
    ['scene=%2e%2e/%2e%2e/etc/passwd', 'leads out of the lessons folder.'],
    ['scene=/lessons/scenes/fence.toml', 'leads out of the lessons folder.'],
    ['scene=scenes/../../state/rasterwalk/progress.toml', 'leads out of the lessons folder.'],
    ['scene=https://example.org/scene.toml', "there is no file 'https://example.org/scene.toml'"],
    ['scene=//example.org/scene.toml', "scene.toml"],
    ['scene=scenes/nothing.toml', "there is no file 'scenes/nothing.toml'"],
    ['scene=scenes', 'scenes'],
    ['scene=-', "'-'"],
    ['lesson=../README', 'leads out of the lessons folder.'],
    ['lesson=https://example.org/lesson', "https://example.org/lesson"],
    ['render', 'which is not a name and a value, like step=3.'],
    ['render=1', "a link cannot set 'render'."],
    ['o=x.png', "a link cannot set 'o'."],
    ['output=x.png', "a link cannot set 'output'."],
    ['json=1', "a link cannot set 'json'."],
    ['stage=rows&__proto__=1', "a link cannot set '__proto__'."],
    ['set=rounding=florr', 'florr'],
    ['size=100000000x100000000', '100000000x100000000'],
    ['a'.repeat(9000), 'the link is longer than 8192 bytes.'],
    ['&'.repeat(8000), 'which is not a name and a value'],
];

/// Those that are also opened in a new page.
const hostileLinks = /^scene=(\.\.|https)|^stage=%zz|^render=|^a{9}/;

async function checkRefusal(program, link, words) {
    const shown = '#' + (link.length > 60 ? link.slice(0, 60) + ' ...' : link);
    if (!await program.has('status.trouble') && !await program.has('start.notice')) note(`${shown}: nothing is said at the bottom.`);
    if (!await program.hasSaid('This link does not work: ')) note(`${shown} is not refused.`);
    if (!await program.hasSaid(words)) note(`${shown}: it is not said: ${words}`);
}

export function testLinks(place) {
    const {browser} = place;

    test('A link to a step of a lesson shows its picture and its settings', async () => {
        const visit = await Visit.begin(browser, place.site);
        const program = await visit.go('#lesson=05-row-table&step=3');
        equal(await program.setting('stage'), 'rows', 'the stage');
        equal(await program.hash(), '#lesson=05-row-table&step=3', 'the address');
        holds(await program.has('tab.rows'), 'The tab of the row table is not on the screen.');
        await comparePicture(place, program, ['--lesson', '05-row-table', '--step', '3']);
    });

    test('A link with many options sets all of them', async () => {
        const visit = await Visit.begin(browser, place.site);
        const program = await visit.go('#scene=scenes/lab-room.toml&stage=pixel_light&set=interpolation=affine&set=rounding=floor' +
            '&size=300x200&to=t12/v1&pixel=150,100&zoom=2&centre=150,100&tab=history');
        for (const [name, value] of [['stage', 'pixel_light'], ['interpolation', 'affine'], ['rounding', 'floor'], ['viewport.size', '300x200']]) {
            equal(await program.setting(name), value, `the setting ${name}`);
        }
        equal(await program.cursor(), 't12/v1', 'the moment');
        const [left, top, scale] = (await program.line('picture')).split(' ').map(Number);
        equal(scale, 2, 'pixels of the screen a pixel of the picture');
        const canvas = await program.place('canvas');
        const middle = [(canvas.x - left) / scale, (canvas.y - top) / scale];
        holds(Math.hypot(middle[0] - 150, middle[1] - 100) < 2, `In the middle of the canvas is ${middle}, not 150,100.`);
        holds(await program.has('history.pixel'), 'The history of the pixel is not on the screen.');
        await comparePicture(place, program, ['--stage', 'pixel_light', '--set', 'interpolation=affine', '--set', 'rounding=floor',
            '--size', '300x200', '--to', 't12/v1']);
    });

    test('A link without a lesson stays in the address, so that a reload shows the same view', async () => {
        const visit = await Visit.begin(browser, place.site);
        const program = await visit.go('#scene=scenes/fence.toml&stage=depth');
        equal(await program.hash(), '#scene=scenes/fence.toml&stage=depth', 'the address');
        const picture = await program.picture();
        await program.reload();
        holds(picture.equals(await program.picture()), 'After a reload the page shows another picture.');
    });

    test('A wrong or hostile link opens the program and says what is wrong', async () => {
        const visit = await Visit.begin(browser, place.site);
        for (const [link, words] of [wrongLinks[0], ...wrongLinks.filter(([link]) => hostileLinks.test(link))]) {
            const program = await visit.go('#' + link);
            await checkRefusal(program, link, words);
            if (!await program.setting('stage')) note(`#${link.slice(0, 60)}: the program has not opened.`);
            await program.close();
        }
        const known = new Set(place.site.files.map(name => '/' + name).concat('/'));
        const asked = place.site.asked.filter(path => !known.has(path) && path !== '/lessons/own.txt');
        equal(asked, [], 'what was asked of the server that is not of the site');
    });

    test('A wrong link in a page that is open leaves the view as it is', async () => {
        const visit = await Visit.begin(browser, place.site);
        const program = await visit.go('#stage=depth');
        for (const [link, words] of wrongLinks) {
            await program.follow(link);
            if (await program.setting('stage') !== 'depth') note(`#${link.slice(0, 60)} has changed the stage.`);
            await checkRefusal(program, link, words);
        }
        await program.follow('stage=rows');
        equal(await program.setting('stage'), 'rows', 'the stage after a link that is right');
    });

    test('The address follows the step, and a reload keeps it', async () => {
        const visit = await Visit.begin(browser, place.site);
        const program = await visit.go('#lesson=05-row-table&step=3');
        await program.press('PageDown');
        equal(await program.hash(), '#lesson=05-row-table&step=4', 'the address after Page down');
        const picture = await program.picture();
        await program.reload();
        equal(await program.hash(), '#lesson=05-row-table&step=4', 'the address after a reload');
        holds(picture.equals(await program.picture()), 'After a reload the page shows another picture.');
        await program.press('PageUp', 'PageUp');
        equal(await program.hash(), '#lesson=05-row-table&step=2', 'the address after Page up twice');
    });

    test('Another link in the same page shows another step, and undo brings scene and settings back', async () => {
        const visit = await Visit.begin(browser, place.site);
        const program = await visit.go('#lesson=05-row-table&step=3');
        await program.follow('lesson=08-depth-buffer&step=2');
        equal(await program.hash(), '#lesson=08-depth-buffer&step=2', 'the address');
        await comparePicture(place, program, ['--lesson', '08-depth-buffer', '--step', '2']);
        await program.press('Control+z');
        equal(await program.setting('stage'), 'rows', 'the stage after undo');
        await program.press('End');
        await comparePicture(place, program, ['--lesson', '05-row-table', '--step', '3', '--to', 'end']);
    });

    test('The page lies in a folder of a site as well as at its top', async () => {
        const site = await serve(place.site.folder, '/teaching/3d/');
        const visit = await Visit.begin(browser, site);
        const program = await visit.go('#scene=models/globe.obj&stage=pixel_light');
        await comparePicture(place, program, ['--scene', 'models/globe.obj', '--stage', 'pixel_light']);
        equal(visit.strangeRequests(), [], 'requests beyond the folder');
        await visit.close();
        await site.close();
    });

    test('The page lets nothing be fetched from elsewhere', async () => {
        const elsewhere = await serve(place.site.folder);
        const context = await browser.newContext({viewport: {width: 1000, height: 700}}); // with its policy
        const page = await context.newPage();
        await page.goto(place.site.url);
        await page.waitForFunction(() => performance.getEntriesByName('first-picture').length > 0, null, {timeout: 30000});
        const answer = await page.evaluate(url => fetch(url, {mode: 'no-cors'}).then(() => 'fetched', () => 'refused'), elsewhere.url + 'page.js');
        equal(answer, 'refused', 'what becomes of a request to another server');
        equal(elsewhere.asked, [], 'what the other server was asked for');
        await context.close();
        await elsewhere.close();
    });
}
