//! The observables of a body on a table.

use super::body::length;
use super::top::{Seen, Top};
use crate::attitude;
use crate::inertia::apply;
use crate::rotation::{cross, dot};
use precess_scalar::Scalar;
use precess_system::Card;

/// What the laws of rolling, sliding or flight say besides the acceleration; along the table's axes.
pub(super) struct Found<S> {
    pub place: [S; 2],
    pub velocity: [S; 2],
    /// Of G above the table, and its rate.
    pub height: S,
    pub rise: S,
    pub slip: [S; 2],
    /// On the body.
    pub force: [S; 3],
    /// The moment about the normal.
    pub drill: S,
    /// The friction that rolling without slipping needs.
    pub needed: S,
    pub denominator: S,
    pub regime: S,
}

/// Observables of every body, before the Euler angles.
const COMMON: usize = 21;

/// The observables' names and texts, in the order of [`measure`].
pub(super) fn observables(top: &Top, card: Card, slides: bool) -> Card {
    // What drills turns the body about the normal, which the lever r is not.
    let held: &[&str] = if slides { &["damping", "spot"] } else { &["damping"] };
    let mut free = vec!["damping"];
    if slides {
        free.push("mu");
    }
    if top.of_table() > 3 {
        free.extend(["shake_x", "shake_z"]);
    }
    let card = card.invariant_if("energy", "J", &free, "total energy", "énergie totale");
    let (en, fr) = ("Jellett's quantity, -L.r", "grandeur de Jellett, -L.r");
    let card = if top.form.is_spherical() {
        card.invariant_if("jellett", "kg m^3/s", held, en, fr)
    } else {
        card.signal("jellett", "kg m^3/s", en, fr)
    };
    let card = attitude::angles(contact(motion(card)));
    let card = if top.form.has_routh() {
        let en = "Routh's quantity, constant for a symmetric body that rolls on a sphere";
        let fr = "grandeur de Routh, constante pour un corps symétrique qui roule sur une sphère";
        card.signal("routh", "kg m^2/s", en, fr)
    } else {
        card
    };
    if slides { card } else { shares(card) }
}

/// A body that rolls turns about its contact point, so the kinetic energy is a sum over the axes.
fn shares(card: Card) -> Card {
    (1..=3).fold(card, |card, k| {
        let en = format!("kinetic energy of the turning about axis {k}");
        let fr = format!("énergie cinétique de la rotation autour de l'axe {k}");
        card.signal(&format!("kinetic{k}"), "J", &en, &fr)
    })
}

/// Energies, height, spins.
pub(super) fn motion(card: Card) -> Card {
    card.signal("kinetic", "J", "kinetic energy", "énergie cinétique")
        .signal("potential", "J", "potential energy", "énergie potentielle")
        .signal("z", "m", "height of the centre of mass", "hauteur du centre de masse")
        .signal("spin_axis", "rad/s", "spin about the body's axis", "rotation autour de l'axe du corps")
        .signal("spin", "rad/s", "spin about the vertical", "rotation autour de la verticale")
        .signal("regime", "", "regime: 0 slides, 1 rolls, 2 flies", "régime : 0 glisse, 1 roule, 2 vole")
}

/// What the table does, and where.
pub(super) fn contact(card: Card) -> Card {
    card.signal("normal", "N", "normal force of the table", "réaction normale de la table")
        .signal("friction_force", "N", "force of friction", "force de frottement")
        .signal(
            "friction_needed",
            "N",
            "friction that rolling without slipping needs",
            "frottement que demande le roulement sans glissement",
        )
        .signal("painleve", "1/kg", "Painlevé's denominator", "dénominateur de Painlevé")
        .signal("slip_x", "m/s", "slip along x", "glissement selon x")
        .signal("slip_y", "m/s", "slip along y", "glissement selon y")
        .signal("slip", "m/s", "slip of the contact point", "glissement du point de contact")
        .signal(
            "power",
            "W",
            "power of friction and damping",
            "puissance du frottement et de l'amortissement",
        )
        .signal(
            "contact_x",
            "m",
            "contact point on the table, abscissa",
            "point de contact sur la table, abscisse",
        )
        .signal(
            "contact_y",
            "m",
            "contact point on the table, ordinate",
            "point de contact sur la table, ordonnée",
        )
        .signal("contact1", "m", "contact point on the body, axis 1", "point de contact sur le corps, axe 1")
        .signal("contact2", "m", "contact point on the body, axis 2", "point de contact sur le corps, axe 2")
        .signal("contact3", "m", "contact point on the body, axis 3", "point de contact sur le corps, axe 3")
}

/// The observables.
#[inline(always)]
pub(super) fn measure<S: Scalar>(top: &Top, seen: &Seen<S>, found: &Found<S>, out: &mut [S]) {
    let Seen { body, rows, omega, touch, ground, .. } = seen;
    let r = touch.r;
    let momentum = apply(body.inertia, *omega);
    let [vx, vy] = found.velocity;
    let kinetic = (body.mass * (vx * vx + vy * vy + found.rise * found.rise) + dot(*omega, momentum)) * 0.5;
    let [along_x, along_z] = ground.at_rest();
    let potential = -(body.mass * (along_x * found.place[0] + along_z * found.height));
    let ([ux, uy], [fx, fy, normal]) = (found.slip, found.force);
    let spin = dot(touch.gamma, *omega);
    out[..8].copy_from_slice(&[
        kinetic + potential,
        -dot(momentum, r),
        kinetic,
        potential,
        found.height,
        omega[2],
        spin,
        found.regime,
    ]);
    out[8..16].copy_from_slice(&[
        normal,
        length([fx, fy]),
        found.needed,
        found.denominator,
        ux,
        uy,
        length([ux, uy]),
        fx * ux + fy * uy + found.drill * spin + dot(*omega, seen.torque),
    ]);
    out[16] = found.place[0] + dot(rows[0], r);
    out[17] = found.place[1] + dot(rows[1], r);
    out[18..COMMON].copy_from_slice(&r);
    attitude::observe(seen.attitude, *omega, &mut out[COMMON..]);
    if top.form.has_routh() {
        out[COMMON + attitude::OBSERVABLES] = routh(seen);
    }
}

/// `omega_3 sqrt(I1 I3 + m R^2 I1 sin^2 theta + m I3 (c_3 - R cos theta)^2)`, c from G to the centre of the sphere.
#[inline(always)]
fn routh<S: Scalar>(seen: &Seen<S>) -> S {
    let Seen { body, omega, touch, .. } = seen;
    let (i1, i3) = (body.inertia[0][0], body.inertia[2][2]);
    let [g1, g2, g3] = touch.gamma;
    let (radius, arm) = (body.radius, body.point[2] - body.radius * g3);
    let across = radius * radius * (g1 * g1 + g2 * g2);
    omega[2] * (i1 * i3 + body.mass * (i1 * across + i3 * arm * arm)).sqrt()
}

/// Height of G above the table where the body touches it, and its rate.
#[inline(always)]
pub(super) fn height<S: Scalar>(seen: &Seen<S>) -> [S; 2] {
    let touch = &seen.touch;
    [-dot(touch.gamma, touch.r), -dot(cross(touch.core, touch.gamma), seen.omega)]
}
