// The student's files: dropped, chosen, and handed out.

import {copyFileSync, cpSync, mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {until, Visit} from './browser.mjs';
import {equal, holds, note, test} from './checks.mjs';
import {reportedSettings} from './hands.mjs';
import {comparePicture, renderNatively} from './pictures.mjs';
import {readPng} from './png.mjs';

export function testFiles(place) {
    const {browser} = place;
    const open = async (fragment, options) => (await Visit.begin(browser, place.site, options)).go(fragment);
    const own = join(place.folder, 'student');
    mkdirSync(own, {recursive: true});
    const made = (name, content) => { writeFileSync(join(own, name), content); return join(own, name); };
    const copied = (from, name) => { copyFileSync(join(place.lessons, from), join(own, name)); return join(own, name); };

    test('A scene that is dropped opens, and undo brings the view before back', async () => {
        const program = await open('#scene=scenes/hexagon.toml&stage=fill');
        const before = await program.picture();
        await program.drop(copied('scenes/fence.toml', 'mine.toml'));
        await comparePicture(place, program, ['--scene', 'scenes/fence.toml']);
        await program.press('Control+z');
        await until(async () => before.equals(await program.picture()), 'undo shows the view before', 5);
    });

    test('A model that is dropped with its materials and images has them', async () => {
        const program = await open('#stage=pixel_light');
        const names = ['globe.obj', 'globe.mtl', 'globe-earth.png', 'globe-wood.png'];
        await program.drop(...names.map(name => join(place.lessons, 'models', name)));
        await comparePicture(place, program, ['--scene', 'models/globe.obj', '--stage', 'pixel_light']);
        await program.drop(join(place.lessons, 'models/globe.obj'));
        await until(() => program.has('status.trouble'), 'it is said that the materials are missing', 5);
        const alone = await program.picture();
        holds(!alone.equals(await renderNatively(place, ['--scene', 'models/globe.obj', '--stage', 'pixel_light'])), 'A model alone still has its images.');
    });

    test('A folder that is dropped opens with what lies in it', async () => {
        const folder = join(own, 'a folder');
        mkdirSync(join(folder, 'images'), {recursive: true});
        copyFileSync(join(place.lessons, 'models/globe.obj'), join(folder, 'globe.obj'));
        writeFileSync(join(folder, 'globe.mtl'), readFileSync(join(place.lessons, 'models/globe.mtl'), 'utf8').replaceAll('map_Kd ', 'map_Kd images/'));
        for (const name of ['globe-earth.png', 'globe-wood.png']) copyFileSync(join(place.lessons, 'models', name), join(folder, 'images', name));
        const program = await open('#stage=pixel_light');
        await program.drop(folder);
        await until(async () => (await program.picture()).equals(
            await renderNatively(place, ['--scene', 'models/globe.obj', '--stage', 'pixel_light'])), 'the model of the folder has its images', 8);
    });

    test('A lesson that is dropped with its scene opens', async () => {
        const folder = join(own, 'course');
        mkdirSync(join(folder, 'scenes'), {recursive: true});
        writeFileSync(join(folder, '91-mine.md'), readFileSync(join(place.lessons, '05-row-table.md'), 'utf8')
            .replace('scenes/one-triangle.toml', 'scenes/mine.toml'));
        copyFileSync(join(place.lessons, 'scenes/one-triangle.toml'), join(folder, 'scenes/mine.toml'));
        const program = await open('#stage=depth');
        await program.drop(folder);
        await until(async () => await program.setting('stage') === 'rows', 'the lesson opens', 8);
        await comparePicture(place, program, ['--lesson', '05-row-table', '--step', '0']);
        await program.press('PageDown'); // to the question below the opening's text
        await program.press('PageDown');
        await comparePicture(place, program, ['--lesson', '05-row-table', '--step', '1']);
        equal((await program.hash()).includes('mine'), false, 'the address names the lesson that only this student has');
    });

    test('A picture that is dropped is diagnosed', async () => {
        const words = ['--scene', 'scenes/one-triangle.toml', '--stage', 'fill'];
        const picture = made('mine.png', await renderNatively(place, [...words, '--set', 'rounding=floor']));
        const program = await open('#scene=scenes/one-triangle.toml&stage=fill');
        await program.dropAtOnce(picture);
        await until(async () => (await program.widgets('lab.')).length > 0, 'the laboratory looks at the picture', 20);
    });

    test('What is broken is told in a sentence, and changes nothing', async () => {
        const program = await open('#scene=scenes/lab-room.toml&stage=depth');
        const settings = reportedSettings(await program.report());
        const files = [
            made('broken.toml', '[camera\nposition = 3'), made('empty.toml', ''), made('empty.obj', ''), made('empty.md', ''), made('empty.png', ''),
            made('zeros.obj', Buffer.alloc(100000)), made('no-picture.png', 'no picture'), made('broken.walk.toml', 'scene = 3'),
            made('no-lesson.md', '# No lesson\n'), made('strange.xyz', 'who knows'), made('no ending', 'who knows'), made('rows.txt', 'these are no rows'),
            made('half.png', readFileSync(join(place.lessons, 'models/globe-earth.png')).subarray(0, 60)),
            made('huge-picture.png', hugePicture()),
        ];
        for (const file of files) {
            const before = await program.page.evaluate(() => window.eval('openedCount'));
            await program.press('Escape');
            await program.drop(file);
            await until(() => program.page.evaluate(before => window.eval('openedCount') > before, before), 'the file arrives', 5);
            await program.rest();
            if (!await program.has('status.trouble') && !await program.has('lab.path')) note(`${file}: nothing is said.`);
            const now = reportedSettings(await program.report());
            if (now !== settings) note(`${file}: the settings are others than before.`);
        }
        equal(await program.page.evaluate(() => document.getElementById('sentence').hidden), true, 'the program runs');
    });

    test('Odd names are nothing special', async () => {
        const program = await open('#scene=scenes/lab-room.toml&stage=depth');
        const names = ['a b.toml', 'größe ü 漢字 🙂.toml', "it's \"quoted\" & <b>.toml", '#hash?query=1%20.toml', '.hidden.toml', '-o.toml',
            '--scene=x.toml', 'a\\b.toml', 'two\nlines.toml', '\t.toml', 'x'.repeat(240) + '.toml', 'UPPER.TOML'];
        for (const name of names) {
            await program.follow('scene=scenes/lab-room.toml&stage=depth&to=t' + names.indexOf(name));
            await program.drop(copied('scenes/fence.toml', name));
            const seen = await program.picture();
            if (!seen.equals(await renderNatively(place, ['--scene', 'scenes/fence.toml']))) note(`${JSON.stringify(name)} does not open.`);
        }
    });

    test('Ctrl+O lets the student choose files', async () => {
        const program = await open('#scene=scenes/lab-room.toml&stage=depth');
        for (const name of ['fence', 'hexagon']) {
            const chooser = program.page.waitForEvent('filechooser', {timeout: 8000});
            await program.press('Control+o');
            await (await chooser).setFiles([join(place.lessons, `scenes/${name}.toml`)]);
            await until(async () => (await program.picture()).equals(await renderNatively(place, ['--scene', `scenes/${name}.toml`])),
                'the scene that was chosen opens', 8);
        }
        const chooser = program.page.waitForEvent('filechooser', {timeout: 8000});
        await program.click('menu.File');
        await program.click('menu.file.open');
        await (await chooser).setFiles(['globe.mtl', 'globe.obj', 'globe-earth.png', 'globe-wood.png'].map(name => join(place.lessons, 'models', name)));
        await until(() => program.has('stage.texture'), 'the model that was chosen by the menu opens', 8);
        await program.click('stage.texture');
        await comparePicture(place, program, ['--scene', 'models/globe.obj', '--stage', 'pixel_light']);
    });

    test('Ctrl+S hands out the view, which opens again when it is dropped', async () => {
        const program = await open('#lesson=05-row-table&step=3');
        await program.press('4', '.');
        const [settings, picture] = [reportedSettings(await program.report()), await program.picture()];
        const saved = await program.download(() => program.press('Control+s'));
        equal(saved.name, '05-row-table-step-3.walk.toml', 'the name of the view');
        const file = join(own, saved.name);
        await saved.saveAs(file);
        await program.follow('stage=depth&scene=scenes/fence.toml');
        await program.drop(file);
        await until(async () => reportedSettings(await program.report()) === settings, 'the view opens again', 8);
        holds(picture.equals(await program.picture()), 'The view shows another picture than when it was saved.');
        const again = await program.download(() => program.press('Control+s'));
        equal(again.name, '05-row-table-step-3.walk.toml', 'the name of the view when it is saved again');
        equal(readFileSync(again.path, 'utf8'), readFileSync(file, 'utf8'), 'the view when it is saved again');
    });

    test('A view of a scene that was dropped opens with that scene beside it', async () => {
        const program = await open('#stage=depth');
        const scene = copied('scenes/fence.toml', 'my fence.toml');
        await program.drop(scene);
        await program.press('3');
        const picture = await program.picture();
        const saved = await program.download(() => program.press('Control+s'));
        const file = join(own, saved.name);
        await saved.saveAs(file);
        await program.reload();
        await program.follow('stage=edges');
        await program.drop(file, scene);
        await until(async () => picture.equals(await program.picture()), 'the view opens again', 8);
    });

    test("F12 hands out a picture of the window's size", async () => {
        const program = await open('#lesson=05-row-table&step=3', {viewport: {width: 1200, height: 800}, deviceScaleFactor: 1.5});
        await program.page.mouse.move(3, 3);
        await program.rest();
        const saved = await program.download(() => program.press('F12'));
        holds(/^rasterwalk-[\d-]+\.png$/.test(saved.name), `The picture is called ${saved.name}.`);
        const png = readPng(readFileSync(saved.path));
        equal([png?.width, png?.height], [1800, 1200], 'its size');
        holds(new Set(png.rows.map(row => row.toString('latin1'))).size > 100, 'The picture is empty.');
    });
}

/// A PNG that claims 60000 x 60000 pixels, and has none.
function hugePicture() {
    const bytes = Buffer.from('89504e470d0a1a0a0000000d494844520000ea600000ea60080200000000000000', 'hex');
    return Buffer.concat([bytes, Buffer.from('0000000049454e44ae426082', 'hex')]);
}
