// The page draws the same bits as the native program.

import {execFile} from 'node:child_process';
import {readdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {promisify} from 'node:util';
import {Visit} from './browser.mjs';
import {holds, note, test} from './checks.mjs';
import {firstDifference} from './png.mjs';

export const stages = ['points', 'edges', 'rows', 'fill', 'depth', 'vertex_light', 'pixel_light'];
const run = promisify(execFile);

const environment = place => ({...process.env, RASTERWALK_LESSONS: place.lessons});

/// The PNG that the native program writes.
export async function renderNatively(place, words) {
    const file = join(place.folder, 'native.png');
    await run(place.native, ['render', ...words, '-o', file], {env: environment(place)});
    return readFileSync(file);
}

/// Notes the difference, if the page's picture is not the one that these words of a command line give.
export async function comparePicture(place, program, words) {
    const [seen, expected] = await Promise.all([program.picture(), renderNatively(place, words)]);
    if (seen.equals(expected)) return;
    writeFileSync(join(place.folder, 'page.png'), seen);
    note(`${words.join(' ')}: ${firstDifference(seen, expected)}`);
}

const fragmentOf = words => words.reduce((text, word) =>
    text + (word.startsWith('--') ? (text ? '&' : '') + word.slice(2) + '=' : encodeURIComponent(word)), '');

async function compareAll(place, all) {
    holds(all.length > 0, 'There is nothing to draw.');
    const visit = await Visit.begin(place.browser, place.site);
    const program = await visit.go();
    for (const words of all) {
        await program.followAtOnce(fragmentOf(words));
        await comparePicture(place, program, words);
    }
    await program.rest();
}

export function testPictures(place) {
    const names = (folder, ending) => readdirSync(join(place.lessons, folder)).filter(name => name.endsWith(ending)).map(name => `${folder}/${name}`);
    test('Every scene and model has the same bits at each stage as the native program draws', () => {
        const files = [...names('scenes', '.toml'), ...names('models', '.obj')];
        return compareAll(place, files.flatMap(file => stages.map(stage => ['--scene', file, '--stage', stage])));
    });
    test('Every step of every lesson has the picture that the native program draws', async () => {
        const {stdout} = await run(place.native, ['lessons', '--json'], {env: environment(place)});
        await compareAll(place, JSON.parse(stdout).lessons.flatMap(({id, steps}) =>
            Array.from({length: steps}, (_, step) => ['--lesson', id, '--step', String(step)])));
    });
    test('Views of depth, triangles and overdraw, and moments in between, have the same bits', () => compareAll(place, [
        ['--stage', 'depth', '--view', 'depth'],
        ['--stage', 'pixel_light', '--view', 'triangle'],
        ['--stage', 'fill', '--view', 'overdraw'],
        ['--stage', 'depth', '--view', 'depth', '--depth-range', '0.2,0.4'],
        ['--stage', 'edges', '--to', 't20/e1/s7'],
        ['--stage', 'rows', '--to', 't12/e2'],
        ['--stage', 'vertex_light', '--to', 't12/r37/c5'],
        ['--stage', 'pixel_light', '--set', 'interpolation=affine', '--set', 'rounding=floor'],
        ['--stage', 'pixel_light', '--size', '640x300'],
        ['--bug', 'B9'],
    ]));
}
