// The page in a real browser: what a student does, and what must result from it.
//   node tests/web/page.mjs SITE NATIVE_RASTERWALK [SHOTS_FOLDER [PATTERN...]]
// SITE is the folder that ui/hosts/web/build writes. A failure leaves a picture of the page in SHOTS_FOLDER
// (none: -). Only the tests whose names match one of the patterns run.

import {mkdirSync, mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';
import {serve, startBrowser, Visit} from './browser.mjs';
import {note, noteCount, runTests} from './checks.mjs';
import {testFiles} from './files.mjs';
import {testHands} from './hands.mjs';
import {testLinks} from './links.mjs';
import {testPictures} from './pictures.mjs';
import {testScreen} from './screen.mjs';
import {testStorage} from './storage.mjs';
import {testTeacher} from './teacher.mjs';

const [site, native, shots = '-', ...patterns] = process.argv.slice(2);
if (!site || !native) {
    console.error('usage: node tests/web/page.mjs SITE NATIVE_RASTERWALK [SHOTS_FOLDER [PATTERN...]]');
    process.exit(2);
}

const place = {
    root: fileURLToPath(new URL('../..', import.meta.url)),
    lessons: fileURLToPath(new URL('../../lessons', import.meta.url)),
    native: resolve(native),
    folder: mkdtempSync(join(tmpdir(), 'rasterwalk-page-')),
    site: await serve(resolve(site)),
    browser: await startBrowser(),
};

testPictures(place);
testLinks(place);
testHands(place);
testStorage(place);
testFiles(place);
testScreen(place);
testTeacher(place);

let shotCount = 0;

/// Checks what holds for every page, whatever the test was.
async function endVisits() {
    for (const visit of [...Visit.open]) {
        for (const message of visit.messages) note(`The page has written to the console: ${message}`);
        const strange = visit.strangeRequests();
        if (strange.length) note(`The page has asked for what is no file of the site: ${[...new Set(strange)].join(' ')}`);
        if (noteCount() && shots !== '-') {
            mkdirSync(shots, {recursive: true});
            for (const page of visit.context.pages()) {
                await page.screenshot({path: join(shots, `failed-${++shotCount}.png`)}).catch(() => null);
            }
        }
        await visit.close();
    }
}

const failed = await runTests(patterns, endVisits);
await place.browser.close();
await place.site.close();
rmSync(place.folder, {recursive: true, force: true});
process.exit(failed ? 1 : 0);
