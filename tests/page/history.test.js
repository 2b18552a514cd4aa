// What Back leads to: the entries that a visit makes, without a browser.
import assert from "node:assert/strict";
import { mock, test } from "node:test";
import { Entries, OFTEN, sceneOf } from "../../docs/try/app/history.js";

// A history as a browser keeps it, and a visitor who waits.
function visit() {
  const entries = [""];
  let clock = 0;
  mock.timers.enable({ apis: ["setTimeout"] });
  const told = new Entries((address) => entries.push(address),
    (address) => { entries[entries.length - 1] = address; }, () => entries.at(-1), () => clock);
  const wait = (time) => {
    clock += time;
    mock.timers.tick(time);
  };
  return { entries, told, wait, end: () => mock.timers.reset() };
}

const scene = (potential, values = "") => `#potential=${potential}&axes=a,b${values}`;

test("numbers, axes, their ends and the mode are no part of a scene", () => {
  assert.equal(sceneOf("#potential=k3&set=l%3D1&axes=l,I1&ends=0,1&show=embed&spin=pi3_0&set=I1%3D2"),
    sceneOf("#potential=k3&spin=pi3_0"));
  assert.notEqual(sceneOf("#potential=k3&orbit=1"), sceneOf("#potential=k3"));
});

test("the first scene takes the place of the address that was opened", () => {
  const { entries, told, wait, end } = visit();
  told.follow(scene("k3"));
  wait(OFTEN);
  assert.deepEqual(entries, [scene("k3")]);
  end();
});

test("each scene that is picked is one entry, with its newest numbers", () => {
  const { entries, told, wait, end } = visit();
  told.follow(scene("a"));
  wait(OFTEN);
  told.follow(scene("a", "&set=l%3D1"), "");
  told.follow(scene("a", "&set=l%3D2"), "");
  wait(10);
  told.follow(scene("a", "&set=l%3D3"), "");
  told.follow(scene("b"), "");
  wait(2 * OFTEN);
  told.follow(scene("b", "&set=l%3D4"), "");
  wait(OFTEN);
  assert.deepEqual(entries, [scene("a", "&set=l%3D3"), scene("b", "&set=l%3D4")]);
  end();
});

test("what the library fills in makes no entry", () => {
  const { entries, told, wait, end } = visit();
  told.follow(scene("a"));
  wait(OFTEN);
  told.follow(scene("b"), "");
  wait(OFTEN);
  told.follow(`${scene("b")}&equilibrium=E1`);
  wait(OFTEN);
  assert.deepEqual(entries, [scene("a"), `${scene("b")}&equilibrium=E1`]);
  end();
});

test("what is typed letter by letter is one entry; in another field, or after a number, another", () => {
  const { entries, told, wait, end } = visit();
  const typed = (field, ...texts) => {
    for (const text of texts) {
      told.follow(scene(text), field);
      wait(150);
      told.follow(`${scene(text)}&equilibrium=E1`);
      wait(700);
    }
  };
  told.follow(scene("a"));
  wait(OFTEN);
  typed("potential", "m", "m0", "m0*", "m0*k", "m0*k3");
  typed("inertia", "x", "xy");
  assert.equal(entries.length, 3);
  told.follow(`${scene("xy", "&set=l%3D1")}&equilibrium=E1`, "");
  wait(OFTEN);
  typed("inertia", "xyz");
  assert.deepEqual(entries, ["a", "m0*k3", "xy", "xyz"].map((text) => scene(text, text === "xy" ? "&set=l%3D1" : "")
    + (text === "a" ? "" : "&equilibrium=E1")));
  end();
});

test("a letter that is typed and taken away again makes no entry", () => {
  const { entries, told, wait, end } = visit();
  told.follow(scene("a"));
  wait(0);
  wait(OFTEN);
  told.follow(scene("ab"), "potential");
  wait(100);
  told.follow(scene("a", "&set=l%3D1"), "potential");
  wait(OFTEN);
  assert.deepEqual(entries, [scene("a", "&set=l%3D1")]);
  end();
});

test("an address that the browser brings makes no second entry, and ends what was to be written", () => {
  const { entries, told, wait, end } = visit();
  told.follow(scene("a"));
  wait(OFTEN);
  told.follow(scene("b"), "potential");
  entries[0] = scene("c");
  told.arrived(scene("c"));
  told.follow(`${scene("c")}&equilibrium=E1`);
  wait(OFTEN);
  assert.deepEqual(entries, [`${scene("c")}&equilibrium=E1`]);
  end();
});

test("what was to be written is not, if the browser has just gone back", () => {
  const { entries, told, wait, end } = visit();
  told.follow(scene("a"));
  wait(OFTEN);
  told.follow(scene("b"), "");
  wait(2 * OFTEN);
  told.follow(scene("b", "&set=l%3D1"), "");
  entries.pop();
  wait(OFTEN);
  told.arrived(scene("a"));
  assert.deepEqual(entries, [scene("a")]);
  end();
});

test("a browser is never given more than a hundred addresses in half a minute", () => {
  const { told, wait, end } = visit();
  let taken = 0, last = "";
  told.push = told.replace = (address) => {
    taken += 1;
    last = address;
  };
  told.here = () => last;
  for (let n = 0; n < 3000; n++) {
    told.follow(scene(`a${Math.floor(n / 7)}`, `&set=l%3D${n}`), "");
    wait(10);
  }
  assert.ok(taken <= 100, String(taken));
  end();
});
