// The exercises that follow P, as questions to the simulation. A card says what is run and what of it is asked; the answer
// is computed when somebody checks theirs.

import type { Text } from "../core";
import type { Scenario } from "../lab/scenario";
import type { Asked } from "./answer";

export interface Exercise {
  id: string;
  source: string;
  question: Text;
  /** What to think of, for whoever asks. */
  hint: Text;
  /** Of the answer; empty for a pure number. */
  unit: string;
  scenario: Scenario;
  asked: Asked;
  /** Relative. */
  tolerance: number;
}

type Values = Record<string, string>;

/** A run under the card's own method, sampled finely. */
function of(system: string, parameters: Values, start: Values, run: Values, when = ""): Scenario {
  // Whatever is watched for is called "it"; `stop` ends the run there.
  const [crossing = "", direction = "rising", stop = ""] = when.split(",").map((part) => part.trim());
  const rest = crossing
    ? `[[event]]\nname = "it"\nwhen = "${crossing}"\ndirection = "${direction}"\nstop = ${String(stop === "stop")}\n`
    : "";
  return { title: "", label: "", system, parameters, start, method: "", run, rest };
}

const period: Asked = { kind: "period", event: "it" };

export const EXERCISES: readonly Exercise[] = [
  {
    id: "simple-period",
    source: "P 2",
    question: {
      en: "A harmonic oscillator x'' + ω² x = 0 has ω = 3 rad/s. How long does one oscillation take?",
      fr: "Un oscillateur harmonique x'' + ω² x = 0 a pour pulsation ω = 3 rad/s. Combien de temps dure une oscillation ?",
    },
    hint: {
      en: "x = x₀ cos(ω t) comes back when ω t has grown by a full turn.",
      fr: "x = x₀ cos(ω t) revient quand ω t a augmenté d'un tour.",
    },
    unit: "s",
    scenario: of("harmonic_oscillator", { omega: "3" }, {}, { until: "10", every: "0.01" }, "x = 0"),
    asked: period,
    tolerance: 0.005,
  },
  {
    id: "large-swing",
    source: "P, ex. 1.2",
    question: {
      en: "A pendulum with g/l = 1 s⁻² is let go at rest at 49π/50 (rad), almost upright. What is its period? (Small swings take 2π s.)",
      fr: "Un pendule pour lequel g/l = 1 s⁻² est lâché sans vitesse à 49π/50 (rad), presque à la verticale vers le haut. Quelle est sa période ? (Les petites oscillations durent 2π s.)",
    },
    hint: {
      en: "The formula 2π √(l/g) no longer holds: measure on the graph of θ, or compute 4 K(sin(θ₀/2)), K being the complete elliptic integral.",
      fr: "La formule 2π √(l/g) ne vaut plus : mesurez sur la courbe de θ, ou calculez 4 K(sin(θ₀/2)), K étant l'intégrale elliptique complète.",
    },
    unit: "s",
    scenario: of(
      "pendulum",
      { l: "9.81" },
      { theta: "49*pi/50" },
      { until: "60", every: "0.02" },
      "theta = 0",
    ),
    asked: period,
    tolerance: 0.01,
  },
  {
    id: "ellipse",
    source: "P, ex. 1.3",
    question: {
      en: "A mass pulled towards the centre with x'' = −4 x, y'' = −4 y starts at (1 m, 0) with the velocity (0, 1 m/s). It runs round an ellipse: how far does y go?",
      fr: "Une masse rappelée vers le centre, x'' = −4 x et y'' = −4 y, part du point (1 m, 0) avec la vitesse (0, 1 m/s). Quel est le demi-axe de son ellipse selon y ?",
    },
    hint: {
      en: "Along each axis it is a harmonic oscillator: y = (1/ω) sin(ω t).",
      fr: "Selon chaque axe, c'est un oscillateur harmonique : y = (1/ω) sin(ω t).",
    },
    unit: "m",
    scenario: of("planar_oscillator", { c: "4" }, {}, { until: "10", every: "0.002" }),
    asked: { kind: "largest", of: "y" },
    tolerance: 0.005,
  },
  {
    id: "speed-below",
    source: "P 3",
    question: {
      en: "A pendulum of 1 m (g = 9.81 m/s²) is let go at rest at 60 degrees. How fast does it turn when it passes the lowest point?",
      fr: "Un pendule de 1 m (g = 9,81 m/s²) est lâché sans vitesse à 60 degrés. Quelle est sa vitesse angulaire au point le plus bas ?",
    },
    hint: {
      en: "What it loses in height it gains in speed: l θ'²/2 = g (1 − cos θ₀).",
      fr: "Ce qu'il perd en hauteur, il le gagne en vitesse : l θ'²/2 = g (1 − cos θ₀).",
    },
    unit: "rad/s",
    scenario: of("pendulum", {}, { theta: "60 deg" }, { until: "4", every: "0.001" }),
    asked: { kind: "largest", of: "theta_dot" },
    tolerance: 0.005,
  },
  {
    id: "spring-period",
    source: "P 6.1",
    question: {
      en: "A mass of 0.5 kg slides without friction at the end of a spring of 8 N/m. What is its period?",
      fr: "Une masse de 0,5 kg glisse sans frottement au bout d'un ressort de raideur 8 N/m. Quelle est sa période ?",
    },
    hint: {
      en: "The heavier, the slower: the mass stands above the fraction line.",
      fr: "Plus c'est lourd, plus c'est lent : la masse est au numérateur.",
    },
    unit: "s",
    scenario: of("spring", { m: "0.5", k: "8" }, { x: "0.2" }, { until: "6", every: "0.005" }, "x = 0"),
    asked: period,
    tolerance: 0.005,
  },
  {
    id: "hanging-spring",
    source: "P 6.2",
    question: {
      en: "A spring of 4 N/m is 20 cm long. A mass of 100 g is hung on it and let go at once (g = 9.81 m/s²). How long does the spring become at most?",
      fr: "Un ressort de raideur 4 N/m mesure 20 cm. On y accroche une masse de 100 g qu'on lâche aussitôt (g = 9,81 m/s²). Quelle est la plus grande longueur du ressort ?",
    },
    hint: {
      en: "It swings about the length at which the spring carries the weight, and starts above it by as much as it will go below.",
      fr: "La masse oscille autour de la longueur où le ressort porte le poids ; elle descend au-dessous autant qu'elle part au-dessus.",
    },
    unit: "m",
    scenario: of(
      "spring",
      { m: "0.1", k: "4", g: "9.81", l0: "0.2" },
      { x: "-0.24525" },
      { until: "4", every: "0.001" },
    ),
    asked: { kind: "largest", of: "length" },
    tolerance: 0.005,
  },
  {
    id: "damped-period",
    source: "P 7",
    question: {
      en: "An oscillator is damped: x'' + 1.2 x' + x = 0. How long is it from one passage through x = 0 upwards to the next?",
      fr: "Un oscillateur est amorti : x'' + 1,2 x' + x = 0. Combien de temps s'écoule entre deux passages par x = 0 en montant ?",
    },
    hint: {
      en: "The damping slows it down: ω² = 1 − (b/2)².",
      fr: "L'amortissement le ralentit : ω² = 1 − (b/2)².",
    },
    unit: "s",
    scenario: of("spring", { b: "1.2" }, { x: "1" }, { until: "20", every: "0.01" }, "x = 0"),
    asked: period,
    tolerance: 0.005,
  },
  {
    id: "over-the-hill",
    source: "P, ex. 4.1",
    question: {
      en: "In the potential U = x²/2 − x³/3 a ball of mass 1 starts at the bottom of the valley, x = 0, without friction. With which speed at least does it get over the hill at x = 1?",
      fr: "Dans le potentiel U = x²/2 − x³/3, une bille de masse 1 part du fond de la vallée, x = 0, sans frottement. Quelle vitesse lui faut-il au moins pour passer la bosse en x = 1 ?",
    },
    hint: {
      en: "At the limit all its energy is potential energy on top of the hill.",
      fr: "À la limite, toute son énergie est potentielle au sommet de la bosse.",
    },
    unit: "",
    scenario: of(
      "cubic_well",
      { b: "0" },
      { x: "0", x_dot: "1" },
      { until: "60", every: "0.1" },
      "x = 1.5, rising, stop",
    ),
    asked: { kind: "threshold", event: "it", part: "start", of: "x_dot", between: [0.2, 1.5] },
    tolerance: 0.005,
  },
  {
    id: "over-the-hill-damped",
    source: "P, ex. 4.2",
    question: {
      en: "The same ball, now with the friction b = 0.17: x'' = −0.17 x' − x + x². With which speed at x = 0 does it just get over the hill? Try.",
      fr: "La même bille, avec le frottement b = 0,17 : x'' = −0,17 x' − x + x². Avec quelle vitesse en x = 0 passe-t-elle tout juste la bosse ? Essayez.",
    },
    hint: {
      en: "There is no formula. Start runs with more and with less speed, and halve what lies between.",
      fr: "Il n'y a pas de formule. Lancez des calculs avec plus et avec moins de vitesse, et coupez en deux ce qui reste.",
    },
    unit: "",
    scenario: of(
      "cubic_well",
      { b: "0.17" },
      { x: "0", x_dot: "1" },
      { until: "60", every: "0.1" },
      "x = 1.5, rising, stop",
    ),
    asked: { kind: "threshold", event: "it", part: "start", of: "x_dot", between: [0.2, 1.5] },
    tolerance: 0.01,
  },
  {
    id: "limit-cycle",
    source: "P 8",
    question: {
      en: "Van der Pol's oscillator x'' = 0.1 (1 − x²) x' − x is fed where |x| < 1 and damped beyond. How far does it swing once it has settled?",
      fr: "L'oscillateur de Van der Pol x'' = 0,1 (1 − x²) x' − x est entretenu pour |x| < 1 et freiné au-delà. Quelle est son amplitude une fois établie ?",
    },
    hint: {
      en: "Over one oscillation x = A cos t as much must be fed as is lost: the mean of (1 − x²) x'² is zero.",
      fr: "Sur une oscillation x = A cos t, il faut autant d'apport que de perte : la moyenne de (1 − x²) x'² est nulle.",
    },
    unit: "",
    scenario: of("van_der_pol", { b0: "0.1" }, {}, { until: "160", every: "0.01" }),
    asked: { kind: "largest", of: "x", after: 140 },
    tolerance: 0.01,
  },
  {
    id: "relaxation-period",
    source: "P, ex. 5",
    question: {
      en: "Van der Pol's oscillator x'' = 1.6 (1 − x²) x' − x no longer swings like a sine. What is the period of its limit cycle?",
      fr: "L'oscillateur de Van der Pol x'' = 1,6 (1 − x²) x' − x n'a plus rien d'une sinusoïde. Quelle est la période de son cycle limite ?",
    },
    hint: {
      en: "Wait until it has settled, and read the time between two passages through zero.",
      fr: "Attendez qu'il soit établi, puis lisez le temps entre deux passages par zéro.",
    },
    unit: "",
    scenario: of("van_der_pol", { b0: "1.6" }, {}, { until: "80", every: "0.02" }, "x = 0"),
    asked: period,
    tolerance: 0.01,
  },
  {
    id: "resonance",
    source: "P, ex. 6.3",
    question: {
      en: "An oscillator x'' + 0.2 x' + x = sin t is driven at its own frequency. How far does it swing once it has settled?",
      fr: "Un oscillateur x'' + 0,2 x' + x = sin t est excité à sa propre fréquence. Quelle est son amplitude une fois établie ?",
    },
    hint: {
      en: "In resonance the friction alone answers the force: 0.2 x' = sin t.",
      fr: "À la résonance, seul le frottement répond à la force : 0,2 x' = sin t.",
    },
    unit: "",
    scenario: of(
      "driven_oscillator",
      { p: "0.2", q: "1", frequency: "1" },
      {},
      { until: "140", every: "0.005" },
    ),
    asked: { kind: "largest", of: "x", after: 120 },
    tolerance: 0.005,
  },
  {
    id: "two-planets",
    source: "P, ex. 9",
    question: {
      en: "Two planets of masses 10 and 1 are 2 apart and pass one another at right angles to the line between them with the relative speed 1.98 (constant of gravitation 1). After how long are they back?",
      fr: "Deux planètes de masses 10 et 1, à la distance 2, se croisent perpendiculairement à la droite qui les joint avec la vitesse relative 1,98 (constante de gravitation 1). Au bout de combien de temps reviennent-elles ?",
    },
    hint: {
      en: "Kepler: T² = 4π² a³/(k M) with M = 11, and v² = k M (2/r − 1/a).",
      fr: "Kepler : T² = 4π² a³/(k M) avec M = 11, et v² = k M (2/r − 1/a).",
    },
    unit: "",
    scenario: of(
      "n_body",
      { masses: "[10; 1]" },
      {
        x0: "-1",
        y0: "0",
        x1: "1",
        y1: "0",
        x0_dot: "0",
        y0_dot: "0.18",
        x1_dot: "0",
        y1_dot: "-1.8",
      },
      { until: "12", every: "0.01" },
      "yg1 = 0",
    ),
    asked: period,
    tolerance: 0.005,
  },
  {
    id: "thrown-round",
    source: "P, ex. 11.1",
    question: {
      en: "A pendulum on a rod of 1 m (g = 9.81 m/s²) hangs at rest and is struck. Which angular velocity must it be given to go round?",
      fr: "Un pendule à tige de 1 m (g = 9,81 m/s²) pend au repos et reçoit un coup. Quelle vitesse angulaire faut-il lui donner pour qu'il fasse un tour ?",
    },
    hint: {
      en: "It has to arrive on top, 2 l higher, with some speed left.",
      fr: "Il doit arriver en haut, 2 l au-dessus, avec encore un peu de vitesse.",
    },
    unit: "rad/s",
    scenario: of(
      "pendulum",
      {},
      { theta: "0", theta_dot: "5" },
      { until: "8", every: "0.05" },
      "theta = 3.2, rising, stop",
    ),
    asked: { kind: "threshold", event: "it", part: "start", of: "theta_dot", between: [3, 9] },
    tolerance: 0.005,
  },
  {
    id: "taut-string",
    source: "P, ex. 11.2",
    question: {
      en: "The same mass on a string of 1 m. Which angular velocity at the bottom keeps the string taut all the way round?",
      fr: "La même masse au bout d'un fil de 1 m. Quelle vitesse angulaire en bas garde le fil tendu pendant tout le tour ?",
    },
    hint: {
      en: "On top the weight alone must be what bends the path: g = l θ'² there.",
      fr: "En haut, le poids suffit tout juste à courber la trajectoire : g = l θ'².",
    },
    unit: "rad/s",
    scenario: of(
      "pendulum",
      {},
      { theta: "0", theta_dot: "5" },
      { until: "4", every: "0.05" },
      "tension = 0, falling, stop",
    ),
    asked: { kind: "threshold", event: "it", part: "start", of: "theta_dot", between: [6.4, 9] },
    tolerance: 0.005,
  },
  {
    id: "slack-string",
    source: "P, ex. 11.2",
    question: {
      en: "The mass on the string of 1 m gets 2 √(g/l) at the bottom (g = 9.81 m/s²), which would just bring a rod to the top. At which angle from the downward vertical does the string go slack?",
      fr: "La masse au bout du fil de 1 m reçoit en bas 2 √(g/l) (g = 9,81 m/s²), ce qui mènerait tout juste une tige en haut. À quel angle de la verticale descendante le fil se détend-il ?",
    },
    hint: {
      en: "Write the tension by the energy: m g (2 + 3 cos θ). Degrees may be typed: 30 deg.",
      fr: "Écrivez la tension à l'aide de l'énergie : m g (2 + 3 cos θ). On peut taper des degrés : 30 deg.",
    },
    unit: "rad",
    scenario: of(
      "pendulum",
      {},
      { theta: "0", theta_dot: "2*9.81^0.5" },
      { until: "3", every: "0.01" },
      "tension = 0, falling, stop",
    ),
    asked: { kind: "crossing", event: "it", of: "theta" },
    tolerance: 0.005,
  },
  {
    id: "tension",
    source: "P 9.1",
    question: {
      en: "A pendulum of 1 kg and 1 m is let go at rest at 60 degrees (g = 9.81 m/s²). What is the largest force on its pivot?",
      fr: "Un pendule de 1 kg et 1 m est lâché sans vitesse à 60 degrés (g = 9,81 m/s²). Quelle est la plus grande force sur son pivot ?",
    },
    hint: {
      en: "At the bottom the rod carries the weight and bends the path: m g + m l θ'².",
      fr: "En bas, la tige porte le poids et courbe la trajectoire : m g + m l θ'².",
    },
    unit: "N",
    scenario: of("pendulum", {}, { theta: "60 deg" }, { until: "4", every: "0.001" }),
    asked: { kind: "largest", of: "tension" },
    tolerance: 0.005,
  },
  {
    id: "stretched",
    source: "P 9.2",
    question: {
      en: "A pendulum on a spring (mass 0.2, stiffness 0.1, natural length 1, g = 0.098) hangs straight down and is let go at its natural length. How long does it become at most?",
      fr: "Un pendule à ressort (masse 0,2, raideur 0,1, longueur à vide 1, g = 0,098) pend à la verticale et on le lâche à sa longueur à vide. Quelle est sa plus grande longueur ?",
    },
    hint: {
      en: "Twice as far as the length at which it would hang still: the natural length is not the length of equilibrium.",
      fr: "Deux fois plus loin que la longueur d'équilibre, qui n'est pas la longueur à vide.",
    },
    unit: "m",
    scenario: of("elastic_pendulum", {}, { l: "1", theta_dot: "0" }, { until: "20", every: "0.005" }),
    asked: { kind: "largest", of: "l" },
    tolerance: 0.005,
  },
  {
    id: "waterwheel",
    source: "P, ex. 8",
    question: {
      en: "A leaking waterwheel (torque π g R a of the water a to one side, R = 1 m, friction 10 kg m²/s, leak 1 s⁻¹) is filled by 1.5 kg/s at the top: a' = ω b − a, b' = 1.5 − ω a − b. It soon turns steadily. How fast?",
      fr: "Une roue à eau percée (couple π g R a de l'eau a d'un côté, R = 1 m, frottement 10 kg m²/s, fuite 1 s⁻¹) reçoit 1,5 kg/s en haut : a' = ω b − a, b' = 1,5 − ω a − b. Elle tourne bientôt régulièrement. À quelle vitesse ?",
    },
    hint: {
      en: "Nothing changes any more: π g R a = 10 ω, a = ω b and b = 1.5 − ω a. Divide the first by ω.",
      fr: "Plus rien ne change : π g R a = 10 ω, a = ω b et b = 1,5 − ω a. Divisez la première par ω.",
    },
    unit: "rad/s",
    scenario: of("malkus_waterwheel", { inflow: "1.5" }, {}, { until: "60", every: "0.02" }),
    asked: { kind: "end", of: "theta_dot" },
    tolerance: 0.005,
  },
  {
    id: "over-a-magnet",
    source: "P, ex. 7",
    question: {
      en: "A pendulum over three magnets (pull to the centre 4, strengths 1, magnets 0.2 below the plane at (0.5, 0), (−0.25, ±0.433)) is let go at rest above the first magnet. It does not stay there. At which x does it come to rest?",
      fr: "Un pendule au-dessus de trois aimants (rappel vers le centre 4, forces 1, aimants 0,2 sous le plan en (0,5 ; 0) et (−0,25 ; ±0,433)) est lâché sans vitesse au-dessus du premier. Il n'y reste pas. En quel x s'arrête-t-il ?",
    },
    hint: {
      en: "The pull to the centre, 4 x, and that of the two other magnets are held by the first magnet: (0.5 − x)/((0.5 − x)² + 0.2²)^(3/2). Solve it by trying.",
      fr: "Le rappel vers le centre, 4 x, et l'attraction des deux autres aimants sont équilibrés par le premier : (0,5 − x)/((0,5 − x)² + 0,2²)^(3/2). Résolvez par tâtonnement.",
    },
    unit: "",
    scenario: of(
      "magnetic_pendulum",
      {},
      { x: "0.5", y: "0", x_dot: "0", y_dot: "0" },
      { until: "150", every: "0.05" },
    ),
    asked: { kind: "end", of: "x" },
    tolerance: 0.005,
  },
  {
    id: "tongue",
    source: "P, ex. 6.1",
    question: {
      en: "A pendulum x'' = −(1 − 0.2 sin α t) x is shaken a little faster than twice in each of its own swings (α = 2). Up to which α does it still swing itself up?",
      fr: "Un pendule x'' = −(1 − 0,2 sin α t) x est secoué un peu plus vite que deux fois par oscillation propre (α = 2). Jusqu'à quel α s'amplifie-t-il encore de lui-même ?",
    },
    hint: {
      en: "Put x = A cos(α t/2) + B sin(α t/2) with slowly changing A and B: near α = 2 ω they grow as long as |α − 2 ω| < h ω/2.",
      fr: "Posez x = A cos(α t/2) + B sin(α t/2), A et B variant lentement : près de α = 2 ω, ils croissent tant que |α − 2 ω| < h ω/2.",
    },
    unit: "rad/s",
    scenario: of(
      "parametric_oscillator",
      { h: "0.2" },
      { x: "0.2", x_dot: "0.2" },
      { until: "1200", every: "1" },
      "x = 100, rising, stop",
    ),
    asked: { kind: "threshold", event: "it", part: "parameters", of: "alpha", between: [2.05, 2.3] },
    tolerance: 0.005,
  },
];
