// A copy of the site with an added lesson, scene and model.

import {copyFileSync, cpSync, mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {serve, until, Visit} from './browser.mjs';
import {equal, holds, note, test} from './checks.mjs';
import {comparePicture} from './pictures.mjs';

const lesson = `<!-- lesson
title = "A lesson of my own"
section = "Of my own"
minutes = 5
about = "What a teacher has added."
program = "yours"
scene = "scenes/own.toml"
set = ["stage=fill"]
-->
# A lesson of my own

It begins here.

## The model

<!-- step
scene = "models/own.obj"
set = ["stage=pixel_light"]
-->

It goes on with a model.
`;

/// Copies the site and adds the teacher's files to it; `lines` go into lessons/own.txt.
async function ownSite(place, name, lines) {
    const folder = join(place.folder, name);
    cpSync(place.site.folder, folder, {recursive: true});
    mkdirSync(join(folder, 'lessons/own'), {recursive: true});
    const scene = readFileSync(join(place.lessons, 'scenes/fence.toml'), 'utf8');
    writeFileSync(join(folder, 'lessons/91-own.md'), lesson);
    writeFileSync(join(folder, 'lessons/own/92-deeper.md'), lesson.replaceAll('own', 'own'));
    writeFileSync(join(folder, 'lessons/scenes/own.toml'), scene.replace(/^name = .*/m, 'name = "My own"'));
    writeFileSync(join(folder, 'lessons/models/own.obj'),
        readFileSync(join(place.lessons, 'models/globe.obj'), 'utf8').replace('globe.mtl', 'Größe 1.mtl'));
    copyFileSync(join(place.lessons, 'models/globe.mtl'), join(folder, 'lessons/models/Größe 1.mtl'));
    writeFileSync(join(folder, 'lessons/own.txt'), lines.join('\n') + '\n');
    return serve(folder);
}

const ownLines = ['91-own.md', 'own/92-deeper.md 999', 'scenes/own.toml', 'models/own.obj', 'models/Größe 1.mtl'];

async function showsOwn(place, site, visit) {
    const program = await visit.go('#lesson=91-own&step=1');
    equal(await program.hash(), '#lesson=91-own&step=1', 'the address');
    equal(await program.setting('stage'), 'pixel_light', 'the stage');
    await comparePicture(place, program, ['--scene', 'models/globe.obj', '--stage', 'pixel_light']);
    await program.press('PageUp');
    equal(await program.hash(), '#lesson=91-own&step=0', 'the address after Page up');
    await comparePicture(place, program, ['--scene', 'scenes/fence.toml', '--stage', 'fill']);
    return program;
}

export function testTeacher(place) {
    const {browser} = place;

    test('A lesson of a teacher opens by its link, and stands in the list', async () => {
        const site = await ownSite(place, 'own', ownLines);
        const visit = await Visit.begin(browser, site);
        const program = await showsOwn(place, site, visit);
        await program.follow('lesson=own/92-deeper&step=1');
        equal(await program.hash(), '#lesson=own/92-deeper&step=1', 'the address of a lesson in a folder');
        await program.follow('lesson=91-own');
        await program.page.setViewportSize({width: 1600, height: 5000});
        await program.press('l');
        const names = await program.widgets('lesson.');
        holds(names.some(name => name.includes('91-own')), `The list of lessons has no 91-own: ${names.join(' ')}`);
        await visit.close();
        await site.close();
    });

    const showsOwnBeside = async lines => {
        const site = await ownSite(place, 'wrong', [...lines, ...ownLines, ...lines]);
        const visit = await Visit.begin(browser, site);
        try {
            await showsOwn(place, site, visit);
            const outside = visit.requests.filter(url => !url.startsWith(site.url + 'lessons/') && !site.files.includes(url.slice(site.url.length)) && url !== site.url);
            if (outside.length) note(`The page has asked beyond the lessons: ${outside.join(' ')}`);
        } catch (fault) {
            note(`${JSON.stringify(lines)}: ${fault.message}`);
        } finally {
            // A missing file is reported where the teacher looks for it.
            visit.messages = visit.messages.filter(text => !/^lessons: the list holds|404/.test(text));
            visit.requests = [];
            await visit.close();
            await site.close();
        }
    };
    test('Lines in own.txt that name nothing, or lead out of the folder, do no harm', () => showsOwnBeside([
        'nothing-here.md', 'nothing-here.png 100', '../index.html', '/etc/passwd', 'https://example.org/evil.md', '//example.org/evil.md',
        'models/../../page.js', './page.js', 'a\\b.md', '%2e%2e/page.js', '#not a file', '  ', '\u0000', 'x'.repeat(5000) + '.md', 'scenes/',
    ]));
    for (const line of ['scenes', 'models 12', 'scenes/own.toml/inner.md', 'models/own.obj/inner.obj', '05-row-table.md/inner.png']) {
        test(`A line in own.txt that takes a folder for a file, or a file for a folder, does no harm: ${line}`, () => showsOwnBeside([line]));
    }
    test('A wrong size in own.txt does no harm', async () => {
        for (const line of ['models/own.obj 999999999999', 'models/own.obj 3', 'models/own.obj 0']) await showsOwnBeside([line]);
    });

    test('A site without files.txt, or with an empty one, still opens', async () => {
        const folder = join(place.folder, 'bare');
        cpSync(place.site.folder, folder, {recursive: true});
        writeFileSync(join(folder, 'lessons/files.txt'), '');
        const site = await serve(folder);
        const visit = await Visit.begin(browser, site);
        const program = await visit.go('#lesson=05-row-table&step=3');
        await comparePicture(place, program, ['--lesson', '05-row-table', '--step', '3']);
        await program.follow('scene=models/globe.obj');
        await until(() => program.has('status.trouble'), 'it is said that there is no such model', 5);
        await visit.close();
        await site.close();
    });

    test('A file of the site that cannot be fetched is told in a sentence', async () => {
        const visit = await Visit.begin(browser, place.site);
        await visit.context.route('**/models/globe.obj', route => route.abort());
        const program = await visit.go('#lesson=05-row-table&step=3');
        await program.follow('scene=models/globe.obj');
        await until(() => program.has('status.trouble'), 'it is said that the model cannot be read', 5);
        equal(await program.hash().then(hash => hash.includes('globe')), true, 'the address is that of the link');
        await program.press('PageDown');
        holds(await program.setting('stage'), 'The program has stopped.');
        visit.messages = visit.messages.filter(text => !/ERR_FAILED|XMLHttpRequest/.test(text));
        await visit.context.unroute('**/models/globe.obj');
        await program.follow('scene=models/globe.obj&stage=pixel_light');
        await comparePicture(place, program, ['--scene', 'models/globe.obj', '--stage', 'pixel_light']);
    });
}
