/**
 * The view's legend, drawn into a picture of the view where it stands on the page.
 */

/**
 * @param {HTMLElement} list the legend
 * @param {HTMLElement} view the picture has the view's size, times `ratio`
 * @param {HTMLCanvasElement} canvas
 * @param {number} ratio
 */
export function drawLegend(list, view, canvas, ratio) {
  const pen = canvas.getContext('2d');
  const box = list.getBoundingClientRect();
  // It is empty or hidden.
  if (!pen || !box.width) return;
  const { left, top } = view.getBoundingClientRect();
  const { backgroundColor, borderRadius, font, color } = getComputedStyle(list);
  pen.save();
  pen.scale(ratio, ratio);
  pen.translate(-left, -top);
  pen.fillStyle = backgroundColor;
  pen.beginPath();
  pen.roundRect(box.left, box.top, box.width, box.height, parseFloat(borderRadius) || 0);
  pen.fill();
  pen.font = font;
  pen.textBaseline = 'middle';
  for (const item of list.children) {
    const { left: at, top: above, height } = item.getBoundingClientRect();
    const middle = above + height / 2;
    // Its line is a surface or, where it is dashed, a border.
    const line = getComputedStyle(item, '::before');
    const [across, thick] = [parseFloat(line.width), parseFloat(line.height) || parseFloat(line.borderTopWidth)];
    const dashes = { dotted: [thick, thick], dashed: [3 * thick, 2 * thick] }[line.borderTopStyle] ?? [];
    pen.strokeStyle = parseFloat(line.height) ? line.backgroundColor : line.borderTopColor;
    pen.lineWidth = thick;
    pen.setLineDash(dashes);
    pen.beginPath();
    pen.moveTo(at, middle);
    pen.lineTo(at + across, middle);
    pen.stroke();
    pen.fillStyle = color;
    pen.fillText(item.textContent ?? '', at + across + (parseFloat(getComputedStyle(item).columnGap) || 0), middle);
  }
  pen.restore();
}
