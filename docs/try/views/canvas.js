// A square canvas of the page, to be painted anew.

/**
 * Its context, empty, in pixels of the page.
 * @param {HTMLCanvasElement} canvas
 * @param {number} size its width
 * @returns {any}
 */
export function cleared(canvas, size) {
  const sharp = devicePixelRatio, side = Math.round(size * sharp), context = canvas.getContext("2d");
  if (canvas.width !== side) canvas.width = canvas.height = side;
  context?.setTransform(sharp, 0, 0, sharp, 0, 0);
  context?.clearRect(0, 0, size, size);
  return context;
}
