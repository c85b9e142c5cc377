// What app/offline/pdf.js is built from.
export * from './libraries.js';
