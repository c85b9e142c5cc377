// A sheet as a PDF with its letters embedded, so that its words can be searched and copied.
/** @import { LineStyle, Path, Pen, Sheet, TextStyle } from '../types.js' */
import { inkOf, PAPER } from '../draw/colours.js';
import { leadOf, widthOf } from './letters.js';
import { enlarged } from './sheet.js';

const FAMILY = 'Workbench';

/** @typedef {typeof import('./libraries.js')} Libraries */

// A pen that draws into a document whose unit is the pixel of CSS.
/**
 * @param {import('jspdf').jsPDF} pdf
 * @returns {Pen}
 */
function penOf(pdf) {
  const opaque = (fill, stroke) => pdf.setGState(pdf.GState({ opacity: fill, 'stroke-opacity': stroke }));
  return {
    path(points, { stroke, width = 1, dash = [], fill, close } = {}) {
      const lines = stroke && stroke !== 'none' ? inkOf(stroke) : null,
        area = fill && fill !== 'none' ? inkOf(fill) : null;
      if ((!lines && !area) || !points.some(Boolean)) return;
      opaque(area?.alpha ?? 1, lines?.alpha ?? 1);
      if (area) pdf.setFillColor(area.hex);
      if (lines) pdf.setDrawColor(lines.hex).setLineWidth(width).setLineJoin('round').setLineDashPattern(dash, 0);
      let down = false;
      for (const point of points) {
        if (point) down ? pdf.lineTo(point[0], point[1]) : pdf.moveTo(point[0], point[1]);
        down = Boolean(point);
      }
      if (close) pdf.close();
      if (area && lines) pdf.fillStroke();
      else if (area) pdf.fill();
      else pdf.stroke();
    },
    text(words, x, y, { size = 11, weight = 400, align, colour = PAPER.text, turn } = {}) {
      if (!words) return;
      const lead = leadOf(widthOf(words, size, weight), align),
        { hex, alpha } = inkOf(colour);
      opaque(alpha, 1);
      pdf
        .setFont(FAMILY, weight >= 600 ? 'bold' : 'normal')
        .setFontSize(size * 0.75)
        .setTextColor(hex);
      if (turn) pdf.text(String(words), x, y + lead, { angle: 90 });
      else pdf.text(String(words), x - lead, y);
    },
    image(source, x, y, w, h) {
      opaque(1, 1);
      pdf.addImage(enlarged(source, w, h), 'PNG', x, y, w, h, undefined, 'FAST');
    },
    clip(x, y, w, h, draw) {
      pdf.saveGraphicsState();
      pdf.rect(x, y, w, h, null).clip().discardPath();
      draw();
      pdf.restoreGraphicsState();
    },
    width: widthOf,
  };
}

/**
 * A sheet as a PDF of one page.
 * @param {Libraries} libraries - app/offline/pdf.js
 * @param {Pick<Sheet, 'width' | 'height'>} sheet
 * @param {(pen: Pen) => void} draw
 * @param {{ title: string, caption: string }} about
 * @returns {ArrayBuffer}
 */
export function pdfOf({ jsPDF, regular, bold }, { width, height }, draw, { title, caption }) {
  const pdf = new jsPDF({
    unit: 'px',
    hotfixes: ['px_scaling'], // a pixel is 1/96 inch, not 1/72 of something else
    format: [width, height],
    orientation: width > height ? 'landscape' : 'portrait',
    compress: true,
    putOnlyUsedFonts: true, // the others would be named without being embedded, which printers refuse
  });
  for (const [weight, font] of Object.entries({ normal: regular, bold })) {
    pdf.addFileToVFS(`${weight}.ttf`, font);
    pdf.addFont(`${weight}.ttf`, FAMILY, weight);
  }
  pdf.setProperties({ title, subject: caption });
  draw(penOf(pdf));
  return pdf.output('arraybuffer');
}
