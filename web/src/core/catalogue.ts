// The catalogue as the core writes it (crates/precess/src/json.rs), under the cards' own names.

export interface Text {
  en: string;
  fr: string;
}

/** A named quantity; `symbol` is LaTeX, `unit` is empty for a pure number. */
export interface Quantity {
  name: string;
  symbol: string;
  unit: string;
  text: Text;
}

/** A coordinate of first order has a start, one of second order a start of its velocity too. */
export type Coordinate = Quantity &
  ({ order: 1; start: number } | { order: 2; start: number; start_dot: number });

/** A number (a bound that is null is none; `open`: the bounds do not belong to it), a list, a choice. */
export type Parameter = Quantity &
  (
    | { default: number; low: number | null; high: number | null; open: boolean }
    | { default: number[] }
    | { fields: string[]; default: number[][] }
    | { default: string; choices: string[] }
  );

/** An invariant ought to stay constant where the parameters of `when_zero` are zero. */
export type Observable = Quantity & ({ kind: "signal" } | { kind: "invariant"; when_zero: string[] });

export interface System {
  id: string;
  /** What it stands with: `tops`, `pendulums` ... */
  family: string;
  title: Text;
  about: Text;
  source: string;
  coordinates: Coordinate[];
  /** Names of the state's numbers: coordinates, then velocities. */
  state: string[];
  parameters: Parameter[];
  observables: Observable[];
  /** Other names under which a start may be given. */
  starts: Quantity[];
  /** The system's own events. */
  events: { name: string; text: Text }[];
  /** Pictures, the most telling first: pairs (horizontal, vertical) of names. */
  views: { pairs: [string, string][]; equal_scales: boolean }[];
  /** Whether a scenario may give it a body, `[system.body]`. */
  takes_body: boolean;
  /** LaTeX: (name, meaning) of what occurs several times, (left, right) of each equation. */
  equations: { definitions: [string, string][]; equations: [string, string][] };
  defaults: { method: string; until: number; dt: number };
}

export interface Method {
  id: string;
  title: Text;
  about: Text;
  order: number;
  adaptive: boolean;
  separable_only: boolean;
  closed_form_only: boolean;
  symplectic: boolean;
  reversible: boolean;
  source: string;
  options: { name: string; default: number; low: number; high: number; text: Text }[];
}

/** A scenario that comes with the program. */
export interface Scenario {
  file: string;
  title: string;
  title_fr: string;
  /** What to notice. */
  note: Text;
  /** The file itself (TOML). */
  text: string;
}

export interface Catalogue {
  systems: System[];
  methods: Method[];
  scenarios: Scenario[];
}
