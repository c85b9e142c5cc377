// What only a PDF needs: its writer, and the letters that it embeds. `npm run build` puts them into one file,
// app/offline/pdf.js, which the app serves as print/pdf.js; a page loads it when a PDF is saved, and never before.
export { jsPDF } from 'jspdf';
export { default as bold } from './fonts/bold.ttf';
export { default as regular } from './fonts/regular.ttf';
