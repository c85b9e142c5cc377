// The shapes of what the modules hand to each other. Sizes: A actions, G discounts, H bins between the sensitivities
// (in `Seen`; in `Model` H is the number of sensitivities), K rows of tau-space, N whole steps, V distinct rewards, r
// usable singular values. An array of shape (n, m) is a Float64Array in row-major order. A row is `time_step` steps of
// the world long. Values and rewards are in units of reward; horizons and steps are in steps of the world.

/** How a linear solver treats its components: app/js/core/filters.js. */
export type FilterKind = 'tikhonov' | 'truncated' | 'damped' | 'iterative';

/** What stands before the arrays of a payload: laplace_core/payloads/lens.py. */
export interface Header {
  /** Interpolated discounts between any two that were trained. */
  added: number;
  world: string;
  state: string;
  /** Names, (A,). */
  actions: string[];
  /** K. */
  steps: number;
  /** Length of a row, in steps of the world. */
  time_step: number;
  acting_gamma: number;
  learned: boolean;
  /** How tau-space is decoded; of a solver that is not linear, `filter` and `free` are those of Tikhonov. */
  solver: string;
  filter: FilterKind;
  /** Components that are not filtered, the first ones. */
  free: number;
  /** Whether the browser can decode by this solver itself. */
  follows: boolean;
  /** The settings of `Arrays.decoded`, where the server has decoded. */
  decoded_for?: Partial<State> | null;
  simulated?: { action: number; count: number };
  /** Kind (f8, f4, u2), place in bytes, and shape of each array. */
  arrays: Record<string, ['f8' | 'f4' | 'u2', number, number[]]>;
}

/** Arrays of a payload, by the names of laplace_core/payloads/lens.py; those of the transforms are in `Grid`. */
export interface Arrays {
  /** Sensitivities, (H,), in reward. */
  thetas: Float64Array;
  /** Sensitivities that begin at the lowest reward that occurs. */
  clipped_thetas?: Float64Array;
  gammas: Float64Array;
  paper_gammas?: Float64Array;
  /** Of a gamma-space with open ends: edges (B+1,) and values (B,) of its bins. */
  bin_edges?: Float64Array;
  bin_values?: Float64Array;
  /** Gamma-space itself, (A, G, B), and its constant channel, (A, G), where there is no basis of rewards. */
  differences: Float64Array;
  constant: Float64Array;
  /** The last tail, (A, G), where the non-negative solver needs it beside the differences. */
  above?: Float64Array;
  /** What the server decoded, before any rescaling: (A, K, B), (A, K), and values of every horizon, (A, K). */
  decoded?: Float64Array;
  decoded_survival?: Float64Array;
  decoded_values?: Float64Array;
  /** The decode matrix whose kernels are drawn beside what the server decoded, (n, G). */
  matrix?: Float64Array;
  /** Of a network's sensitivities on the axis of its activation, (H,). */
  places?: Float64Array;
  /** The truth, where `Model.truth` says that there is one: (V,), (A, N, V) and (A, K). */
  rewards: Float64Array;
  timeline: Float64Array;
  optimum: Float64Array;
  /** What was simulated, (N, B+1) and (5, N), where `Header.simulated` says that there is something. */
  simulated_tails?: Float64Array;
  simulated_lines?: Float64Array;
  /** Parts of the transforms and bases of rewards: laplace_core/payloads/lens.py. */
  [name: string]: any;
}

/** Values over the discounts of each action in the components of a transform. */
export interface Projected {
  /** (r, width) an action. */
  projected: Float64Array[];
  /** The constant channel, (r,) an action. */
  constants: Float64Array[];
}

/** The same, and with each discount decoded by the row of the next one. */
export interface Components extends Projected {
  readonly late: Projected;
}

/** Columns of gamma-space: one a distinct reward, or, where `plain`, one a bin. */
export interface Columns extends Components {
  width: number;
  /** (G, width) an action. */
  values: Float64Array[];
  /** The constant channel, (G,) an action. */
  steps: Float64Array[];
  plain?: boolean;
}

/** A grid of discounts and the components of its transform, for one linear solver. */
export interface Grid {
  name: '' | 'paper_';
  G: number;
  r: number;
  K: number;
  /** (G,), each between 0 and 1. */
  gammas: Float64Array;
  filter: FilterKind;
  free: number;
  /** Whether the solver is Tikhonov of order 0, with discounts that count alike and are not filtered. */
  plain: boolean;
  /** (G, r). */
  U: Float64Array;
  /** From values over the discounts to components, (r, G): weighted and filtered. */
  Ut: Float64Array;
  /** Singular values, (r - free,), the largest first. */
  s: Float64Array;
  /** The timeline that belongs to each component, (K, r). */
  V: Float64Array;
  /** F, (G, K). */
  transform: Float64Array;
  /** Filter over the discounts, (G, G). */
  smoothing?: Float64Array;
  /** Of the non-negative solver: its system, (q, K), and what turns masses over the discounts into its data, (q, G). */
  reduced: Float64Array;
  turned: Float64Array;
  columns: { shared: Columns; per_gamma?: Columns };
}

/** What continuations of the state came to that begin with one action; arrays (N,). */
export interface Simulation {
  action: number;
  count: number;
  /** N. */
  length: number;
  /** Edges of the bins. */
  width: number;
  /** Probability to lie above each edge, in 65,535ths, (N, width). */
  tails: Float64Array;
  reward: Float64Array;
  rewardError: Float64Array;
  survival: Float64Array;
  survivalError: Float64Array;
  /** W1 distance that chance alone makes, in reward. */
  chance: Float64Array;
}

/** A payload as the lens holds it: app/js/core/model.js. */
export interface Model {
  header: Header;
  arrays: Arrays;
  A: number;
  K: number;
  /** Number of sensitivities. */
  H: number;
  /** Length of a row, in steps of the world. */
  dt: number;
  /** Whole steps of the truth. */
  length: number;
  /** Deadlines, in steps of the world, (K,). */
  horizons: Float64Array;
  truth: boolean;
  /** Whether the slope of the activation can be changed. */
  sloped: boolean;
  simulated?: Simulation;
  grids: { own: Grid; paper?: Grid };
  /** What was computed, by name: `remember` of algebra.js. */
  cache: Record<string, { text: string; value: any }>;
  /** The payload; none of a model that a player made of a step. */
  bytes?: Uint8Array;
  id?: string;
}

/** What the controls hold: laplace_core/payloads/state.py. */
export interface State {
  /** Regularisation of the inverse, in singular values. */
  alpha: number;
  /** The rule that chose alpha, or `typed`. */
  selector: string;
  /** Steepness of the activation, per reward. */
  slope: number;
  /** Share of the trained slope of a network, from 0 to 1. */
  slope_share: number;
  /** Deadline, in steps of the world. */
  horizon: number;
  /** Steps of the episode that are over. */
  used: number;
  /** Width of the deadline as a share of the horizon. */
  softness: number;
  value_gamma: number;
  /** Standard deviation of (1 - gamma) Q. */
  noise: number;
  noise_seed: number;
  normalise: 'none' | 'survival' | 'paper';
  fold: boolean;
  mixed: boolean;
  paper_grid: boolean;
  clip: boolean;
  constant: boolean;
  shift: boolean;
  added: number;
  action: number;
  look: string;
}

/** What a solver makes of each action, before rows are rescaled. */
export interface Timelines {
  n: number;
  /** Tau-space, (n, H), a new array. */
  rows(a: number): Float64Array;
  survival(a: number): Float64Array;
  /** Expected reward by row, (n,), a new array. */
  rewards(a: number): Float64Array;
  /** What a row holds at least that is not rounding, (n,). */
  rounding?(a: number): Float64Array;
}

/** An inverse of `n` rows. */
export interface Inverse {
  n: number;
  /** Components (r, width) to rows (n, width). */
  decode(right: Float64Array, width: number): Float64Array;
  /** A target over the rows, (K,), to weights over the components, (r,). */
  weights(target: Float64Array): Float64Array;
  /** Kept by `rowNorms`, (n,). */
  norms?: Float64Array;
}

/** An inverse that gets a row more with every `add`. */
export interface GrowingInverse extends Inverse {
  add(): GrowingInverse;
}

/** The truth under a state; arrays one an action. */
export interface Truth {
  /** Expected reward by row, (K,). */
  rewards: Float64Array[];
  survival: Float64Array[];
  /** Probability of each reward by row, (K, V). */
  chances: Float64Array[];
  /** The same by whole step, (N,). */
  steps: { rewards: Float64Array[]; survival: Float64Array[] };
  /** Value of each horizon as it is read, (K,). */
  values: Float64Array[];
  /** Value of each horizon with a hard deadline at the acting discount, (K,). */
  hard: Float64Array[];
  acting: number;
}

export interface Decoded {
  grid: Grid;
  columns: Columns;
  /** Edges of the bins, (H+1,), what each counts as, (H,), and their number. */
  thetas: Float64Array;
  midpoints: Float64Array;
  H: number;
  /** Whether the outermost bins hold all that lies beyond the sensitivities. */
  open: boolean;
  /** Rows that were decoded. */
  n: number;
  inverse: Inverse;
  /** Rows of the horizon that is read, and of the time that is left. */
  readRow: number;
  leftRow: number;
  /** Tau-space of the shown action, (n, H). */
  tau: Float64Array;
  /** (n,) an action. */
  survival: Float64Array[];
  rewards: Float64Array[];
  /** Value of each horizon, (K,) an action; NaN where it was left out. */
  values: Float64Array[];
  /** Whether no horizon was left out. */
  whole: boolean;
  /** Size of the terms that values are sums of. */
  scale: number;
  chosen: number;
  chosenAt(row: number): number;
  /** Discounts d(tau) of every horizon, (K, K). */
  d: Float64Array;
  /** Columns to bins, (width, H); none where the columns are the bins. */
  map?: Float64Array | null;
  /** Noise at level 1. */
  hum: (Components & { differences: Float64Array[]; above: Float64Array; steps: Float64Array[] }) | null;
  /** What a softer slope leaves in each bin, and the most that it misses. */
  soft: { map: Float64Array; off: number } | null;
}

export interface DecodedWithTruth extends Decoded {
  truth: Truth;
  /** Activation of each reward in each bin, (V, H). */
  masses: Float64Array;
  /** Best value of every action at a row, (A,). */
  optimumAt(row: number): number[];
  best: number;
  bestAt(row: number): number;
  /** What the choice loses, in reward. */
  regret: number;
}

export interface DecodedAlone extends Decoded {
  truth?: undefined;
  masses: null;
  optimumAt?: undefined;
  best?: undefined;
  bestAt?: undefined;
  regret?: undefined;
}

/** Everything that a state of the controls shows of a model: `see` of app/js/core/maths.js. */
export type Seen = DecodedWithTruth | DecodedAlone;

/** The bins of a space. */
export type Bins = Pick<Decoded, 'thetas' | 'H' | 'open'>;

/** For each bin, the bins that are added up from, to (exclusive), and what a certain reward leaves in them; (H,). */
export interface Windows {
  from: Int32Array;
  to: Int32Array;
  whole: Float64Array;
}

/** An artefact that is switched on and off. */
export interface Switch {
  label: string;
  help: string;
  on: Partial<State>;
  off: Partial<State>;
  isOn(state: State): boolean;
}

/** What a switch does: the most probability that it moves in a row, regrets with and without it, another choice. */
export interface Effect {
  size: number;
  /** There where there is a truth. */
  on?: number;
  off?: number;
  flips: boolean;
}

/** What the value weighs each row with, and what it should; (K,). */
export interface Kernel {
  wanted: Float64Array;
  actual: Float64Array;
  /** How much noise it lets through. */
  gain: number;
}

/** The window through which a row is seen, (K,); the rest in steps of the world. */
export interface Resolution {
  kernel: Float64Array;
  peak: number;
  half: number;
  low: number;
  high: number;
}

export type Point = [number, number];
/** A line through points, in pixels; where there is none the line is interrupted. */
export type Path = (number[] | null | undefined)[];
/** Low and high end. */
export type Range = number[];

/** A rectangle, in pixels. */
export interface Box {
  x: number;
  y: number;
  w: number;
  h: number;
}

export interface LineStyle {
  stroke?: string;
  width?: number;
  dash?: number[];
  fill?: string;
  close?: boolean;
}

export interface TextStyle {
  size?: number;
  weight?: number;
  align?: 'left' | 'center' | 'right';
  colour?: string;
  /** Written upwards. */
  turn?: boolean;
}

/** What draws, on a canvas or into an SVG; places are in pixels. */
export interface Pen {
  path(points: Path, style?: LineStyle): void;
  text(words: string, x: number, y: number, style?: TextStyle): void;
  image(source: HTMLCanvasElement, x: number, y: number, w: number, h: number): void;
  /** Draws within a rectangle only. */
  clip(x: number, y: number, w: number, h: number, draw: () => void): void;
  /** Width of words. */
  width(words: string, size: number, weight?: number): number;
}

/** A pen that writes the parts of an SVG. */
export interface SvgPen extends Pen {
  parts: string[];
}

/** Colours of the page, as CSS. */
export interface Colours {
  text: string;
  soft: string;
  primary: string;
  paper: string;
  font: string;
  wash: string;
  mark: string;
  halo: string;
  empty: string;
}

/** Scales of a picture: values to pixels and back. */
export interface Scale {
  box: Box;
  X(value: number): number;
  Y(value: number): number;
  x: Range;
  y: Range;
  toX(px: number): number;
  toY(py: number): number;
}

/** A value on an axis, or a value and its words. */
export type Tick = number | (number | string)[];

export interface Axes {
  x: Range;
  y: Range;
  /** What x is linear in, as a function of x, and its inverse. */
  across?: ((value: number) => number)[];
  xTicks?: Tick[] | Range;
  yTicks?: Tick[] | Range;
  xTitle?: string;
  yTitle?: string;
  colours: Pick<Colours, 'text' | 'soft'>;
  grid?: boolean;
}

/** The place that is pointed at: theta in reward, tau as a row, gamma as an index. */
export interface Hover {
  theta?: number;
  tau?: number;
  gamma?: number;
}

/** Angles of the camera of a surface, in radians. */
export interface Camera {
  turn: number;
  tilt: number;
}

/** What came after an action in an episode: laplace_core/trained/rollouts.py. */
export interface Followed {
  rewards: number[];
  action: number;
  /** Steps until it was over; null where it was cut off. */
  over: number | null;
}

/** All that a picture of the lens is drawn from. */
export interface Scene {
  model: Model;
  state: State;
  seen: Seen;
  kernel: Kernel;
  resolution: Resolution;
  colours: Colours;
  hover: Hover;
  /** The row of the view. */
  at: number;
  /** The view that is kept as A. */
  pinned?: Seen;
  pinnedOf?: State;
  followed?: Followed | null;
  /** Ranges of theta, of rows of gamma-space and of rows of tau-space that are shown. */
  zoom: { theta?: Range; gamma?: Range; tau?: Range };
  camera: Camera;
  /** Whether all of theta is drawn before anybody zooms, or only where rewards are; and where they have been. */
  wide: boolean;
  reached?: Range;
  /** A rectangle that is being drawn, in pixels. */
  band?: { panel: Panel; from: number[]; to: number[] };
  world?: WorldPanel;
  /** What pictures keep from one drawing to the next, by name. */
  images: Record<string, any>;
}

/** What `simulated.js` needs of a scene. */
export type ModelAndState = Pick<Scene, 'model' | 'state'>;

/** A picture of the lens. */
export interface Panel {
  name: string;
  title: string;
  /** What it shows, in two lines, and the formula. */
  why: [string, string];
  /** Of a space, what its rows are. */
  rows?: 'gamma' | 'tau';
  draw(pen: Pen, w: number, h: number, scene: Scene): Scale;
  /** What a place of the picture, in its own units, points to. */
  point(scene: Scene, x: number, y: number): Hover;
  /** What the picture shows, in words. */
  words(scene: Scene): string;
}

/** The graph of a world, drawn by plotly. */
export interface WorldPanel {
  box: ChartBox;
  show(graph: Graph): void;
  picture(format: 'png' | 'svg'): Promise<string>;
}

/** The world as a plotly figure in JSON, in words, and what its zoom belongs to. */
export interface Graph {
  figure: string;
  alt: string;
  revision: string;
}

/** The sentence over the pictures. */
export interface Verdict {
  tone: 'bad' | 'warn' | 'ok' | 'unknown' | 'smeared' | 'ruined' | 'pending';
  sentence: string;
  /** Largest error of a value, in reward. */
  error?: number;
  /** Share of the timeline that is misplaced. */
  timeline?: number;
}

/** A state that an example or a remedy leads to. */
export interface Preset {
  name: string;
  /** Whether it can be shown with the present payload. */
  here: boolean;
  state: Partial<State>;
}

/** What the server tells the lens: app/components/lens/__init__.py. */
export interface Told {
  state: State;
  /** Where Reset leads. */
  base: State;
  name?: string;
  id?: string;
  revision?: number;
  presets?: Preset[];
  /** The library's verdict on a state, with the labels of its remedies. */
  said?: (Verdict & { state: State; remedies: string[] }) | null;
  world?: Graph | null;
  pinnable?: boolean;
  pinned?: boolean;
  pin?: State | null;
  /** Title of the rule that chose alpha. */
  rule?: string | null;
  /** The solver whose timeline is being computed, while that of another one is drawn. */
  coming?: string | null;
  lead?: { id: string; step: number } | null;
  followed?: Followed | null;
  /** Whether the action of the pictures is the one that was taken, as long as nobody chooses another. */
  follows?: boolean;
  /** The guided story, and which of its steps is shown; none where a page has none. */
  story?: { at: number; steps: { name: string; words: string; href: string; panel: string }[] } | null;
  plotly?: string;
  /** Whether a server listens. */
  live?: boolean;
  /** The world as a still picture, in a separate file. */
  still?: string;
  /** The page that a lens is saved as. */
  template?: () => Promise<string>;
  /** What the lens before handed over. */
  kept?: { scene: Pick<Scene, 'zoom' | 'camera'>; focus?: string; pending?: Partial<State> };
}

/** The report to the server when a control is released. */
export interface Released {
  state: State;
  preset?: string;
  remedy?: number;
  picked?: number;
  pin?: boolean;
  /** Another solver. */
  solver?: string;
  /** A step of the story; 0 ends it. */
  story?: number;
  /** The action that was taken is to be shown again. */
  follow?: boolean;
}

/** What a control asks for: a change of the state, or a word. */
export type Wish = (
  change:
    (Partial<State> & { preset?: Preset }) | 'play' | 'seed' | 'undo' | 'redo' | 'reset' | 'pin' | 'follow' | 'wide',
  released?: boolean,
) => void;

/** The lens, as the hub and Streamlit's entry know it. */
export interface Lens {
  host: HTMLElement;
  show(next: Model, news: Partial<Told>, moved: boolean): void;
  readonly lead: Told['lead'];
  readonly model: Model;
  readonly state: State;
  readonly seen: Seen;
  readonly hover: Hover;
  leave(): NonNullable<Told['kept']>;
}

/** The lens, as it is saved. */
export interface Saved {
  host: HTMLElement;
  scene: Scene;
  told: Told;
  panels: { panel: Panel; canvas: HTMLCanvasElement }[];
  drawOne(pen: Pen, each: { panel: Panel }, w: number, h: number): Scale | null;
  world?: WorldPanel;
  readonly verdict: string;
}

/** A printed sheet, in pixels of CSS: its panels, the first line of its caption and where its lines begin. */
export interface Sheet {
  width: number;
  height: number;
  cells: Box[];
  caption: number;
  left: number;
}

/** The player whose cursor the lens follows. */
export interface Leader {
  id: string;
  readonly step: number;
  over(model: Model): [Model, Partial<Told>];
}

/** Places of a slider, from 0 to count, and the values that they stand for. */
export interface Places {
  count: number;
  at(place: number): number;
  of(value: number): number;
}

/** What `component` of cursor.js keeps of what it mounted. */
export interface Mounted {
  stop(): void;
  /** Moves the cursor, as Python asks for. */
  place(step: number): void;
  cursor: Pick<Stepper, 'step' | 'to'>;
  news?(told: any): void;
}

/** A cursor over steps. */
export interface Stepper {
  bar: HTMLInputElement;
  moves: HTMLButtonElement[];
  to(step: number): void;
  stop(): void;
  readonly step: number;
  /** Python has moved it and needs no report. */
  place(step: number): void;
  /** It is dragged over a picture, whose `toStep` knows where a step lies. */
  over(canvas: HTMLCanvasElement): void;
}

/** A message of Streamlit to a component. */
export interface Message {
  data: any;
  parentElement: HTMLElement;
  setTriggerValue(name: string, value: unknown): void;
}

/** A box that plotly draws into, with what it is to show. */
export type ChartBox = HTMLElement & {
  wanted: { figure: string; revision: string; name: string };
  clickable: boolean;
  report: (name: string, value: any) => void;
  drawn?: string | null;
  listening?: boolean;
  data?: object[];
  layout?: { shapes?: object[] };
  /** Comes with plotly. */
  on: (event: string, heard: (event: any) => void) => void;
};

/** An episode, as laplace_core/payloads/player.py packs it: N steps, A actions, O numbers in an observation. */
export interface Reel {
  id: string;
  steps: number;
  /** A. */
  actions: number;
  terminated: boolean;
  acting_gamma: number;
  rule: string;
  horizon: number | null;
  /** Actions taken, (N,). */
  taken: Float64Array;
  /** 1 where the action is not the greedy one, (N,). */
  differs: Float64Array;
  rewards: Float64Array;
  surprise: Float64Array;
  received: Float64Array;
  predicted: Float64Array;
  /** (N, A). */
  values: Float64Array;
  greedy_values: Float64Array;
  /** (N + 1, O). */
  observations: Float32Array;
  /** JPEG files one after the other, and where each ends, (N + 1,). */
  frames: Uint8Array<ArrayBuffer>;
  ends: Float64Array;
  /** Of an agent with a gamma-space: (N, A, G, H+1), what a level is worth, (G,), and (N, A, G). */
  levels?: Int16Array;
  scales?: Float64Array;
  constant?: Float32Array;
  /** Of an agent that learned a distribution of the return: (N, A, M). */
  locations?: Float32Array;
  masses?: Float32Array;
  /** Of an agent that knows the time to go: (N, T, A). */
  horizon_values?: Float32Array;
}

/** An episode of an agent with a gamma-space. */
export type SpaceReel = Reel & Required<Pick<Reel, 'levels' | 'scales' | 'constant'>>;

declare global {
  /** plotly.js, once it is loaded; it comes without types. */
  var Plotly: any;
  interface HTMLElement {
    /** Of a lens: work of the last redraws, in ms. */
    frames?: number[];
    /** Of a player: the same. */
    times?: number[];
    lens?: Lens;
  }
  interface HTMLCanvasElement {
    /** Of a panel: its scales as it was drawn last. */
    scale?: Scale;
    /** Of a timeline: the step at a place, in pixels. */
    toStep?: (px: number) => number;
  }
}

/** Columns of the non-negative solver: app/js/core/nonnegative.js. */
export interface NonnegativeColumns {
  /** Largest singular value of the system. */
  size: number;
  /** The timeline at an alpha, (K, B). */
  at(alpha: number): Float64Array;
}

/** A payload of the page of the inverse: laplace_core/payloads/inverse.py. B bins, r components, a alphas. */
export interface InverseModel {
  header: {
    solver: string;
    /** The linear solver that alpha is chosen by. */
    linear: string;
    /** The solver whose choices are mapped: another one where the own takes too long at many alphas. */
    mapped: string | null;
    filter: FilterKind;
    /** Components that are not filtered, the first ones. */
    free: number;
    /** Sum of squares of what no component reaches. */
    outside: number;
    columns: number;
    /** Names of the rules, and which alpha each of them takes. */
    rules: string[];
    chosen: number[];
    steps: number;
    time_step: number;
    /** The first alpha of the sweep that is drawn. */
    first: number;
    open: boolean;
    actions: string[];
    action: number;
    /** Deviation of the expected reward at a discount over that of one value. */
    gain: number;
    decoded_at: number | null;
  };
  arrays: Record<string, Float64Array>;
  G: number;
  K: number;
  B: number;
  r: number;
  /** Length of a row, in steps of the world. */
  dt: number;
  /** U^T W, (r, G). */
  Ut: Float64Array;
  /** (G, K). */
  transform: Float64Array;
  /** The masses in their components, (r, B). */
  components: Float64Array;
  /** Expected reward over the discounts, (G,). */
  means: Float64Array;
  /** U^T W F, (r, K). */
  seenThrough: Float64Array;
  horizons: Float64Array;
  nonnegative?: NonnegativeColumns;
  bins: Bins;
}

/** What an alpha makes of the data: app/js/inverse/maths.js. */
export interface Made {
  alpha: number;
  /** (r,) each. */
  kept: Float64Array;
  lost: Float64Array;
  residual: number;
  size: number;
  degrees: number;
  /** (K, B). */
  tau: Float64Array;
  /** (K,). */
  rewards: Float64Array;
  /** The rewards over the discounts again, (G,). */
  back: Float64Array;
  /** Whether the timeline belongs to another alpha, because this solver answers when alpha is released. */
  still: boolean;
  /** Standard deviation that the noise makes, and what smoothing adds, (K,). */
  noise?: Float64Array;
  bias?: Float64Array;
}

/** What a hand has set on the page of the inverse. */
export interface InverseState {
  alpha: number;
  /** T, in steps of the world. */
  horizon: number;
  axis: 'gamma' | 'time';
}

/** What the server tells the page of the inverse: app/components/inverse/__init__.py. */
export interface InverseTold {
  name: string;
  id: string;
  revision: number;
  state: InverseState;
  /** The sentence about this alpha. */
  said: { tone: 'ok' | 'warn' | 'bad' | 'unknown'; sentence: string; state: InverseState };
  /** What the rules of the payload are called. */
  rules: Record<string, { title: string; why: string; formula: string }>;
  /** The rule in use; null of an alpha that was set by hand. */
  rule: string | null;
  /** Horizons and the action that is certainly best there, -1 of none; null while that is computed. */
  certified: [number, number][] | null;
  /** The band of a solver that is not linear, at this alpha; null of others and while it is drawn. */
  band: { alpha: number; noise: number[]; bias: number[] } | null;
}

/** All that a picture of the page of the inverse is drawn from. */
export interface InverseScene {
  model: InverseModel;
  told: InverseTold;
  state: InverseState;
  made: Made;
  colours: Colours;
  images: Record<string, any>;
}

/** A picture of the page of the inverse. */
export interface InversePanel {
  name: string;
  title: string;
  /** Two lines behind the question mark; the second one is the formula. */
  why: [string, string];
  /** The words beside the title. */
  note?(scene: InverseScene): string;
  /** What the picture shows, in numbers, for those who cannot see it; by default the note. */
  words?(scene: InverseScene): string;
  draw(pen: Pen, w: number, h: number, scene: InverseScene): Scale;
  /** Where a hand at a place of the picture, in pixels, puts the state; there where it can be dragged. */
  drag?(scene: InverseScene, scale: Scale, x: number, y: number): Partial<InverseState>;
  /** Whether a finger at a place takes hold of what is dragged up and down, so that the page does not scroll. */
  handle?(scene: InverseScene, scale: Scale, x: number, y: number): boolean;
}
