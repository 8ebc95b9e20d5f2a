// The words of the exercises, which come with them.

import type { Text } from "../core";

export const WORDS = {
  title: { en: "Exercises", fr: "Exercices" },
  about: {
    en: "Work it out, then ask the simulation. Fractions, powers and degrees may be typed: pi/6, 2^0.5, 30 deg.",
    fr: "Cherchez, puis interrogez la simulation. On peut taper des fractions, des puissances et des degrés : pi/6, 2^0.5, 30 deg.",
  },
  here: { en: "This system only", fr: "Ce système seulement" },
  print: { en: "Print", fr: "Imprimer" },
  answer: { en: "Your answer", fr: "Votre réponse" },
  check: { en: "Check", fr: "Vérifier" },
  hint: { en: "Hint", fr: "Indice" },
  open: { en: "Open the run", fr: "Ouvrir le calcul" },
  computing: { en: "The simulation is running …", fr: "La simulation tourne…" },
  right: { en: "Right. The simulation gives", fr: "Juste. La simulation donne" },
  small: { en: "Too small: the simulation gives more.", fr: "Trop petit : la simulation donne plus." },
  large: { en: "Too large: the simulation gives less.", fr: "Trop grand : la simulation donne moins." },
  unread: { en: "This is not a number:", fr: "Ce n'est pas un nombre :" },
  stopped: { en: "The simulation was stopped.", fr: "La simulation a été arrêtée." },
  none: { en: "There is no exercise for this system.", fr: "Il n'y a pas d'exercice pour ce système." },
} as const satisfies Record<string, Text>;
