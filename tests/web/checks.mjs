// Names tests with sentences, runs them one after another, and says what was expected and what was seen.

const tests = [];
let noted = [];

/// A test; `run` throws a Failure, or notes faults with note().
export function test(sentence, run) {
    tests.push({sentence, run});
}

export class Failure extends Error {}

const shown = value => typeof value === 'string' ? value : JSON.stringify(value);

export function equal(seen, expected, what) {
    if (shown(seen) !== shown(expected)) {
        throw new Failure(`${what}:\n    expected ${shown(expected)}\n    seen     ${shown(seen)}`);
    }
}
export function holds(condition, what) {
    if (!condition) throw new Failure(what);
}

/// Notes a fault; the test continues.
export function note(what) {
    noted.push(what);
}

export const noteCount = () => noted.length;

const longestList = 20;
const longestTest = 600; // seconds

/// Runs the tests whose sentences match one of the patterns, or all; returns how many failed.
export async function runTests(patterns, afterEach) {
    const chosen = tests.filter(({sentence}) => !patterns.length || patterns.some(part => new RegExp(part, 'i').test(sentence)));
    let failed = 0;
    for (const {sentence, run} of chosen) {
        const began = performance.now();
        noted = [];
        let timer;
        const late = new Promise((_, fail) => {
            timer = setTimeout(() => fail(new Failure(`not done after ${longestTest} s`)), 1000 * longestTest);
        });
        try {
            await Promise.race([run(), late]);
        } catch (fault) {
            noted.push(fault instanceof Failure ? fault.message : fault.stack);
        }
        clearTimeout(timer);
        try {
            await afterEach();
        } catch (fault) {
            noted.push(fault instanceof Failure ? fault.message : fault.stack);
        }
        const seconds = ((performance.now() - began) / 1000).toFixed(1);
        console.log(`${noted.length ? 'FAILED' : 'passed'}  ${sentence} (${seconds} s)`);
        for (const what of noted.slice(0, longestList)) console.log('  ' + what.split('\n').join('\n  '));
        if (noted.length > longestList) console.log(`  and ${noted.length - longestList} more`);
        if (noted.length) ++failed;
    }
    if (!chosen.length) {
        console.log('No test has such a name.');
        return 1;
    }
    console.log(failed ? `${failed} of ${chosen.length} tests of the page failed.` : `${chosen.length} tests of the page passed.`);
    return failed;
}
