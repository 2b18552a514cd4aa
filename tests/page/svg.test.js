// Pictures as SVG: what is drawn stands in it, where it was drawn, as XML that can be read.
import assert from "node:assert/strict";
import { test } from "node:test";
import { composed, named, svg } from "../../docs/try/views/picture.js";
import { Svg } from "../../docs/try/views/svg.js";

const TAG = /<(\/?)(\w+)((?: [\w:-]+="[^"<]*")*)(\/?)>([^<]*)/g;
const ATTRIBUTE = / ([\w:-]+)="([^"<]*)"/y, ENTITY = /&#(\d+);/g;
const plain = (text) => {
  assert.doesNotMatch(text.replace(ENTITY, ""), /[&<]/);
  return text.replace(ENTITY, (_, code) => String.fromCharCode(code));
};

// The elements of XML, with their attributes and texts; what is not well formed is refused.
function parsed(xml) {
  const elements = [], open = [];
  assert.doesNotMatch(xml, /(?![\t\n\r])\p{Cc}|[\p{Cs}\ufffe\uffff]/u);
  for (const [, close, name, inside, single, text] of xml.matchAll(TAG)) {
    if (close) assert.equal(open.pop().name, name);
    const found = { name, text: plain(text), of: {} };
    for (const [, key, value] of inside.matchAll(new RegExp(ATTRIBUTE, "g"))) {
      assert.ok(!(key in found.of), `${key} twice`);
      found.of[key] = plain(value);
    }
    if (close) continue;
    elements.push(found);
    if (!single) open.push(found);
  }
  assert.equal(open.length, 0);
  assert.equal(xml.replace(/<[^<>]*>[^<]*/g, ""), "");
  return elements;
}

const drawn = (draw, encoded) => {
  const picture = new Svg(100, 80, "A & B", encoded);
  draw(picture);
  return parsed(String(picture));
};
const places = (d) => d.match(/-?[\d.]+/g).map(Number);

test("a path has its vertices, its width, its colour, its dashes", () => {
  const [root, title, path] = drawn((context) => {
    context.strokeStyle = "rgb(1, 2, 3)";
    context.lineWidth = 1.5;
    context.globalAlpha = 0.25;
    context.setLineDash([4, 2]);
    context.beginPath();
    for (const [n, point] of [[1, 2], [3.14159, -4], [5, 6]].entries()) context[n ? "lineTo" : "moveTo"](...point);
    context.closePath();
    context.stroke();
  });
  assert.deepEqual([root.of.viewBox, title.text], ["0 0 100 80", "A & B"]);
  assert.deepEqual(path.of, { d: "M1 2L3.14 -4L5 6Z", fill: "none", stroke: "rgb(1, 2, 3)",
    "stroke-width": "1.5", "stroke-dasharray": "4 2", opacity: "0.25" });
});

test("translate and scale place what is drawn, and their inverses bring it back", () => {
  const found = drawn((context) => {
    context.fillStyle = "blue";
    context.translate(10, 20);
    context.scale(2, 2);
    context.translate(1, 0);
    context.font = "italic 600 10px system-ui, sans-serif";
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillText("π < \"k\" & \0", 3, 4);
    context.fillRect(0, 0, 4, 5);
    context.translate(-1, 0);
    context.scale(1 / 2, 1 / 2);
    context.translate(-10, -20);
    context.fillRect(0, 0, 4, 5);
  });
  assert.equal(found[2].text, "π < \"k\" & \ufffd");
  assert.deepEqual(found[2].of, { x: "18", y: "35", fill: "blue", "text-anchor": "middle", "font-size": "20",
    "font-weight": "600", "font-style": "italic", "font-family": "system-ui, sans-serif" });
  assert.deepEqual(found.slice(3).map(({ of }) => of), [{ x: "12", y: "20", width: "8", height: "10", fill: "blue" },
    { x: "0", y: "0", width: "4", height: "5", fill: "blue" }]);
});

test("a circle begins where a canvas begins it, and closes", () => {
  const [, , { of: { d, "stroke-width": width } }] = drawn((context) => {
    context.scale(2, 2);
    context.beginPath();
    context.arc(25, 20, 15, Math.PI / 2, 2.5 * Math.PI);
    context.stroke();
  });
  assert.equal(d, "M50 70A30 30 0 0 1 50 10A30 30 0 0 1 50 70");
  assert.equal(width, "2");
});

test("an image is a part of the picture", () => {
  const data = "data:image/png;base64,AA==";
  const [, , image] = drawn((context) => context.drawImage({}, 1, 2, 4, 3), () => data);
  assert.deepEqual(image.of, { x: "1", y: "2", width: "4", height: "3", preserveAspectRatio: "none",
    style: "image-rendering:pixelated", href: data });
});

const SEEN = { title: "Heavy & \"sleeping\" top", line: `U = m0*k3${" + a*k3".repeat(40)}, ${"1".repeat(250)}`,
  verdict: { text: "✓ Stable", colour: "#0b6b3a", more: "" }, key: [{ text: "stable", colour: "#9ad7c5" }],
  numbers: ["I1 = 1", "l = 2*sqrt(2)"], inks: { ink: "#111", quiet: "#555", line: "#ccc", paper: "#fff" },
  views: [400, 440].map((height) => ({ width: 400, height, draw: (context) => {
    context.beginPath();
    context.moveTo(0, 0);
    context.lineTo(400, height);
    context.stroke();
  } })) };

test("the picture of a scene has all that is seen, nothing over another, nothing outside", () => {
  const found = parsed(svg(SEEN)), { width, height } = composed(SEEN);
  const texts = found.filter(({ name }) => name === "text");
  for (const text of [SEEN.title, "✓ Stable", "stable", "I1\u00a0=\u00a01, l\u00a0=\u00a02*sqrt(2)"]) {
    assert.equal(texts.filter((one) => one.text === text).length, 1, text);
  }
  const line = texts.filter(({ of }) => of["font-size"] === "15").slice(0, -1).map(({ text }) => text);
  assert.equal(line.join("").replaceAll(" ", ""), SEEN.line.replaceAll(" ", ""));
  assert.ok(line.every((part) => part.length * 8 < width - 40));
  const bases = texts.map(({ of }) => Number(of.y));
  assert.deepEqual(bases, bases.toSorted((a, b) => a - b));
  assert.ok(bases.at(-1) < height);
  const [first, second] = found.filter(({ of }) => of.stroke && of.d.includes("L") && !of.d.includes("Z"))
    .map(({ of }) => places(of.d));
  assert.ok(first[2] < second[0] && second[2] < width && first[1] === second[1]);
  assert.ok(first[1] > bases.find((_, n) => texts[n].text === "✓ Stable") && second[3] < bases.at(-2) - 12);
});

test("a file's name says the scene, in letters that every system takes", () => {
  assert.equal(named(SEEN, "svg"), "gyrostat-heavy-sleeping-top.svg");
  assert.equal(named({ ...SEEN, title: "" }, "png").length, "gyrostat-.png".length + 60);
  assert.equal(named({ ...SEEN, title: "Å/..\\\0" }, "svg"), "gyrostat-a.svg");
});
