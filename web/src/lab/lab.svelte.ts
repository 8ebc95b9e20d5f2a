// The state of the lab: a list of scenarios (so that everything can be undone), the run of the one at hand, the clock.

import type { Catalogue, Method, Scenario as Preset, System } from "../core";
import first from "../first.toml?raw";
import firstPage from "virtual:first-page";
import type { NamedGraph } from "../scenes/kit/scene";
import { wordsOf, type Words } from "../words";
import { advance, pace, sampleAt } from "./clock";
import { listed } from "./groups";
import { remember, remembered } from "./memory";
import type { Measured } from "./measured";
import { inField, shown, type Language } from "./number";
import { Look } from "./result";
import { Cancelled, Refusal, Runner, type Done } from "./runner";
import { blame, fork, methodOf, systemOf, toml, type Scenario } from "./scenario";
import { scenarioOf, systemIn } from "./toml";
import type { Rival, Variation } from "./variation";

export type Theme = "auto" | "light" | "dark" | "projector";

const FIRST = toml(scenarioOf(first));

/** The language that was chosen, or the browser's. */
export function languageOf(): Language {
  const browsers = navigator.language.toLowerCase().startsWith("fr") ? "fr" : "en";
  return remembered("language", ["en", "fr"]) ?? browsers;
}

const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;

export class Lab {
  catalogue = $state.raw<Catalogue>(firstPage);
  /** The scene alone, to be shown within another page. */
  readonly bare = /[?&]ui=none(&|$)/.test(location.search);
  /** Whether everything is there, not only the first page. */
  whole = $state(false);
  readonly #runner: Runner;
  #everything: Promise<void> | undefined;
  #address: ReturnType<typeof setTimeout> | undefined;

  #history = $state.raw<Scenario[]>([]);
  #at = $state(0);
  language = $state<Language>("en");
  words: Words;
  theme = $state<Theme>("auto");

  look = $state.raw<Look | undefined>(undefined);
  refusal = $state<{ field: string; why: string } | undefined>(undefined);
  /** What has just happened, until the next edit. */
  notice = $state("");
  /** What is read aloud. */
  spoken = $state("");
  progress = $state<number | undefined>(undefined);

  t = $state(0);
  playing = $state(!calm);
  reverse = $state(false);
  loop = $state(true);
  speed = $state(1);
  sample = $derived(this.look ? sampleAt(this.look.times, this.t) : 0);

  /** What the run at hand is compared with, where that is another run. */
  variations = $state.raw<Variation[]>([]);
  rivals = $state.raw<Rival[]>([]);
  /** The graphs with a name that the scene brings. */
  graphs = $state.raw<NamedGraph[]>([]);
  /** So many samples of a run can be trusted, where somebody has asked. */
  trusted = $state.raw<{ look: Look; samples: number } | undefined>(undefined);
  /** The first sample of the run at hand that cannot be trusted; infinity where none is known. */
  horizon = $derived(this.trusted && this.trusted.look === this.look ? this.trusted.samples : Infinity);
  /** What was measured, to be held against the run. */
  measured = $state.raw<Measured | undefined>(undefined);
  /** Of the bodies that are too many for a list, the one at hand. */
  group = $state("");

  static async open(): Promise<Lab> {
    const language = languageOf();
    const [runner, words] = await Promise.all([Runner.open(), wordsOf(language)]);
    return new Lab(runner, language, words);
  }

  private constructor(runner: Runner, language: Language, words: Words) {
    this.#runner = runner;
    this.language = language;
    this.words = $state.raw(words);
    this.theme = remembered("theme", ["auto", "light", "dark", "projector"]) ?? "auto";
    this.#history = [scenarioOf(first)];
    const shown = location.hash.length > 1 ? this.followLink(location.hash) : this.#run();
    void shown.then(() => this.#everythingElse());
  }

  /** Loads what the first page does without. */
  #everythingElse(): Promise<void> {
    this.#everything ??= this.#runner.grow().then((catalogue) => {
      this.catalogue = catalogue;
      this.whole = true;
    });
    return this.#everything;
  }
  /** Runs a scenario by the core that can. */
  async #done(text: string, progress?: (t: number) => void): Promise<Done> {
    if (text !== FIRST) await this.#everythingElse();
    return this.#runner.run(text, progress);
  }

  /** A run beside the one at hand, for whoever asks something of it. */
  compute(text: string): Promise<Done> {
    return this.#done(text);
  }

  get scenario(): Scenario {
    return this.#history[this.#at] ?? scenarioOf(first);
  }
  get system(): System | undefined {
    return systemOf(this.catalogue, this.scenario);
  }
  get method(): Method | undefined {
    return methodOf(this.catalogue, this.scenario);
  }
  get text(): string {
    return toml(this.scenario);
  }
  get canUndo(): boolean {
    return this.#at > 0;
  }
  get canRedo(): boolean {
    return this.#at < this.#history.length - 1;
  }

  number(x: number, digits?: number): string {
    return shown(x, this.language, digits);
  }
  fieldText(text: string): string {
    return inField(text, this.language);
  }
  say(text: { en: string; fr: string }): string {
    return text[this.language];
  }

  async speak(language: Language): Promise<void> {
    [this.words, this.language] = [await wordsOf(language), language];
    remember("language", language);
  }
  dress(theme: Theme): void {
    this.theme = theme;
    remember("theme", theme);
  }

  /** Makes a scenario the one at hand. `instead` replaces the last edit, for drags. */
  edit(scenario: Scenario, instead = false): void {
    const before = this.#history.slice(0, this.#at + (instead ? 0 : 1));
    this.#history = [...before, scenario];
    this.#at = this.#history.length - 1;
    this.#changed();
  }
  undo(): void {
    if (!this.canUndo) return;
    this.#at--;
    this.#changed();
  }
  redo(): void {
    if (!this.canRedo) return;
    this.#at++;
    this.#changed();
  }

  /** A new scenario that starts at the state shown. */
  fork(): void {
    if (!this.look) return;
    const state = this.look.stateAt(this.sample);
    this.t = 0;
    this.edit(fork(this.scenario, state));
  }

  /** The address of the scenario at hand. */
  async link(): Promise<string> {
    const { encode } = await import("./link");
    return `${location.href.replace(/#.*$/s, "")}#${encode(this.text)}`;
  }

  /** Opens what an address holds; what was there before can be had back by undoing. */
  async followLink(hash: string): Promise<void> {
    const { decode } = await import("./link");
    const decoded = decode(hash);
    if (decoded && "text" in decoded && decoded.text !== this.text) {
      await this.openText(decoded.text);
      return;
    }
    if (decoded && "wrong" in decoded) this.notice = this.words.link[decoded.wrong];
    if (!this.look) await this.#run();
  }

  /** Opens a scenario file. What the reader here does not know, the core spells out. */
  async openText(text: string): Promise<void> {
    await this.#everythingElse();
    let scenario: Scenario | undefined;
    try {
      scenario = scenarioOf(text);
    } catch {
      try {
        scenario = scenarioOf((await this.#done(text)).report.scenario);
      } catch (error) {
        this.notice = error instanceof Refusal ? error.message : this.words.link.broken;
      }
    }
    if (scenario && !systemOf(this.catalogue, scenario)) {
      // The core's own sentence says what is wrong with it.
      const refused = this.#done(text).catch((error: unknown) => {
        this.notice = error instanceof Error ? error.message : String(error);
      });
      await refused;
      scenario = undefined;
    }
    if (scenario) this.edit(scenario);
    else if (!this.look) await this.#run();
  }

  #changed(): void {
    this.notice = "";
    // Browsers refuse an address that changes with every move of a drag.
    clearTimeout(this.#address);
    this.#address = setTimeout(() => {
      const { scenario } = this;
      void this.link().then((link) => {
        if (scenario === this.scenario) history.replaceState(null, "", link);
      });
    }, 150);
    void this.#run();
  }

  async #run(): Promise<void> {
    const { scenario, text } = this;
    const fresh = this.look?.result.scenario.system !== scenario.system;
    if (this.#runner.busy) this.#runner.cancel();
    this.progress = undefined;
    try {
      const done = await this.#done(text, (t) => {
        if (scenario === this.scenario) this.progress = t;
      });
      if (scenario !== this.scenario) return;
      this.look = new Look({ ...done, scenario });
      this.refusal = undefined;
      if (fresh) {
        this.speed = pace(this.look.times);
        this.measured = undefined;
      }
      const ends = [this.look.times[0] ?? 0, this.look.times.at(-1) ?? 0];
      if (fresh || this.t < Math.min(...ends) || this.t > Math.max(...ends)) this.t = ends[0] ?? 0;
      void this.#compare();
    } catch (error) {
      if (scenario !== this.scenario) return;
      if (error instanceof Cancelled) this.notice = this.words.cancelled;
      else this.refusal = blame(error instanceof Error ? error.message : String(error), text);
    } finally {
      if (scenario === this.scenario) this.progress = undefined;
    }
  }

  cancel(): void {
    this.#runner.cancel();
  }

  compared({ id }: Variation): boolean {
    return this.variations.some((variation) => variation.id === id);
  }
  /** Compares the run with variations of it, or no longer. */
  vary(...variations: Variation[]): void {
    const others = this.variations.filter(({ id }) => variations.every((variation) => variation.id !== id));
    this.variations = others.length < this.variations.length ? others : [...others, ...variations];
    void this.#compare();
  }

  async #compare(): Promise<void> {
    const { scenario, method, variations } = this;
    const wanted = variations.flatMap((variation) => {
      const varied = variation.of(scenario, method);
      const known = this.rivals.find((rival) => rival.variation === variation);
      const look = known?.look?.result.scenario === scenario ? known.look : undefined;
      return varied ? [{ varied, rival: { variation, look, refusal: "" } }] : [];
    });
    this.rivals = wanted.map(({ rival }) => rival);
    for (const { varied, rival } of wanted) {
      if (rival.look) continue;
      let look: Look | undefined;
      let refusal = "";
      try {
        look = new Look({ ...(await this.#done(toml(varied))), scenario });
      } catch (error) {
        if (error instanceof Cancelled) return;
        refusal = error instanceof Error ? error.message : String(error);
      }
      if (scenario !== this.scenario || variations !== this.variations) return;
      this.rivals = this.rivals.map((one) =>
        one.variation === rival.variation ? { ...one, look, refusal } : one,
      );
    }
  }

  /** Puts the clock on a sample. */
  seek(sample: number): void {
    const times = this.look?.times;
    if (times) this.t = times[Math.min(Math.max(sample, 0), times.length - 1)] ?? 0;
  }
  step(samples: number): void {
    this.playing = false;
    this.seek(this.sample + samples);
  }
  toggle(): void {
    if (!this.playing && this.look && !this.loop) {
      const last = this.reverse ? 0 : this.look.times.length - 1;
      if (this.sample === last) this.seek(this.reverse ? this.look.times.length - 1 : 0);
    }
    this.playing = !this.playing;
  }
  tick(seconds: number): void {
    if (!this.playing || !this.look) return;
    const { t, ended } = advance(this.look.times, this.t, seconds, this);
    this.t = t;
    if (ended) this.playing = false;
  }

  /** What a scenario is called: its own title, or its system's. */
  titleOf(scenario: Scenario | undefined): string {
    const system = scenario && systemOf(this.catalogue, scenario);
    const preset = scenario && this.presetOf(scenario);
    if (preset) return this.presetTitle(preset);
    if (scenario?.title) return scenario.title;
    return system ? this.say(system.title) : "";
  }
  /** The scenario of the program's own that one was made from, told by its title. */
  presetOf({ title, system }: Scenario): Preset | undefined {
    const found = title ? this.catalogue.scenarios.find((preset) => preset.title === title) : undefined;
    return found && systemIn(found.text) === system ? found : undefined;
  }
  presetTitle(preset: Preset): string {
    return (this.language === "fr" && preset.title_fr) || preset.title;
  }

  /** A sentence that says what is shown, to be read aloud. */
  describe(): void {
    const { look, system, sample } = this;
    if (!look || !system) return;
    // Nobody listens to hundreds of numbers.
    const names = listed(look.state, this.group);
    const values = ["t", ...names].map((name) =>
      `${this.meaning(name)} ${this.number(look.at(name, sample), 3)} ${look.unit(name)}`.trim(),
    );
    const unread = look.state.length - names.length;
    if (unread) values.push(`${unread} ${this.words.unread}`);
    const drifts = look.result.report.drifts.map(
      ({ name, relative, largest }) =>
        `${this.words.drift}, ${this.meaning(name)}: ${this.number(relative ?? largest ?? NaN, 2)}`,
    );
    const doubts = sample < this.horizon ? [] : [this.words.beyond];
    const sentence = [this.say(system.title), values.join("; "), ...doubts, ...drifts].join(". ");
    // The same words again are read again only where they change.
    this.spoken = sentence === this.spoken ? `${sentence} ` : sentence;
  }

  /** What a quantity is, in words; its name where the card has none. */
  meaning(name: string): string {
    if (name === "t") return this.words.time.toLowerCase();
    const { system } = this;
    const known = [...(system?.coordinates ?? []), ...(system?.observables ?? []), ...(system?.starts ?? [])];
    const found = known.find((quantity) => quantity.name === name);
    return found ? this.say(found.text) : name;
  }
}
