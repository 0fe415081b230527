// uPlot draws with as many pixels as the screen has. Two per CSS pixel at least, so that plots are sharp on paper, too.
// Imported before uPlot, which asks when it is loaded.
const screenRatio = Object.getOwnPropertyDescriptor(window, 'devicePixelRatio');
Object.defineProperty(window, 'devicePixelRatio', {
  configurable: true,
  get: () => Math.max(2, Number(screenRatio?.get?.call(window) ?? screenRatio?.value ?? 1)),
});
