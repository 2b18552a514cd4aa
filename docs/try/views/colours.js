// The colours of the picture of a body; those of the verdicts are those of try.css.

/**
 * @typedef {object} Colours
 * @property {string} ink letters and axes
 * @property {string} quiet the frame in space
 * @property {string} line circles
 * @property {Record<string, string>} verdicts of a path, by the verdict; "" of none
 * @property {number[][]} body red, green and blue of its faces across axis 1, 2, 3, and of that where axis 3 leaves
 * @property {number[][]} wheel its slices by turns
 */

/** @type {Colours} */
export const LIGHT = {
  ink: "#1f2328", quiet: "#57606a", line: "#c4ccd6",
  verdicts: { STABLE: "#0b6b3a", UNSTABLE: "#a8201a", UNDECIDED: "#7a5200", "": "#57606a" },
  body: [[214, 229, 243], [163, 195, 224], [104, 155, 200], [232, 188, 96]],
  wheel: [[66, 74, 86], [196, 203, 212]] };

/** @type {Colours} */
export const DARK = {
  ink: "#e6e8eb", quiet: "#a3abb5", line: "#4a5563",
  verdicts: { STABLE: "#63d399", UNSTABLE: "#ff9088", UNDECIDED: "#e8bf62", "": "#a3abb5" },
  body: [[184, 203, 222], [132, 166, 198], [82, 129, 172], [212, 168, 78]],
  wheel: [[48, 55, 66], [188, 196, 206]] };
