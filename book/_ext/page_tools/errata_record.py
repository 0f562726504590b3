"""The record behind the errata: every slip of the print with its place, what must stand there, and what follows."""

from __future__ import annotations

from dataclasses import dataclass

from page_tools.markup import Markup, table


@dataclass(frozen=True, slots=True)
class Slip:
    """One slip of the print.

    Attributes
    ----------
    key : str
        Its section is ``sec-erratum-KEY``.
    title : str
        Heading of that section.
    where : str
        Place in the paper.
    printed, must_be : str
        What stands there and what must, as markup.
    consequence : str
        What happens to a reader who takes the print at its word.
    """

    key: str
    title: str
    where: str
    printed: str
    must_be: str
    consequence: str

    @property
    def label(self) -> str:
        """Label of its section."""
        return f"sec-erratum-{self.key}"


SLIPS = (
    Slip("hypotheses", "Which hypothesis gives which bound", "introduction",
         "the upper bound and the lower estimate come \"through the static and kinematic hypothesis, respectively\"",
         "the upper bound comes through the kinematic hypothesis, the lower estimate through the static one",
         "The bounds are exchanged. Figure 1 and the text on equation (4) have them right."),
    Slip("limits", "The limits of equation (16)", "(16)",
         "$\\int_{\\ell-r_m}^{\\ell-r_M}$, twice", "$\\int_{\\ell-r_M}^{\\ell-r_m}$",
         "None for $g^{\\mathrm{total}}$: both integrals change their sign, and the quotient does not. Each by itself "
         "would be negative."),
    Slip("mode", "The name of $r_{50}$", "below (19)",
         "$r_{50}$ and $\\ell_{50}$ are the sample means",
         "they are the most frequent sizes, the modes of (18) and (19)",
         "With means in the place of modes sizes are too small, and contacts in a volume too many. The stiffness "
         "stays."),
    Slip("lognormal", "Lognormal branch lengths", "(19)",
         "for lognormal sizes $g(\\ell)$ remains a lognormal density", "nearly so, for narrow gradations",
         "The tail of long branches is too thin, and the kinematic stiffness of wide gradations too small."),
    Slip("shear-stiffness", "The shear stiffness of a contact", "(21)",
         "$k_r = \\lambda\\bigl(f_r/(f_n\\tan\\phi_\\mu)\\bigr)^{1/2} k_n$",
         "$k_r = \\lambda\\bigl(1 - f_r/(f_n\\tan\\phi_\\mu)\\bigr)^{1/3} k_n$",
         "Contacts without shear force would have no shear stiffness. Tables III to V cannot be had."),
    Slip("fabric-tensor", "The fabric tensor", "below (23)",
         "$N_{ij} = \\tfrac{2}{15}\\delta_{ij} + \\tfrac13 D_{ij}$",
         "$N_{ij} = \\tfrac13\\delta_{ij} + \\tfrac{2}{15} D_{ij}$",
         "The contact forces of the paper's packings come out too large and too unequal. Table III cannot be had."),
    Slip("grain-modulus", "The shear modulus of the grains", "parametric study, material",
         "$G_s = 31$ Pa", "$G_s = 31$ GPa", "Every stiffness is too small by a factor of a million. Ratios stay."),
    Slip("isotropic", "Stiffness of the isotropic assemblies", "effect of gradation",
         "5465, 2665 and 134 MPa for the axial, the shear and the coupling stiffness at 28 kPa",
         "about a tenth of that", "The printed values are ten times as stiff as the model has it. Ratios "
         "stay."),
    Slip("uniformity", "Independence of uniformity", "effect of gradation, curves 4 to 6",
         "the stiffness is independent of the uniformity of the assembly",
         "it does not depend on the mean size; independence of uniformity does not follow from (11), (12), (16) and "
         "(17)",
         "The equations and the printed stiffness of curves 4 to 6 exclude one another."),
    Slip("shear", "Which component is which", "text on Table II",
         "$C_{66}$ and $C_{44}$ are \"the shear-stiffness component on the vertical plane and horizontal plane\"",
         "$C_{66} = C_{2323}$ is shear *in* a vertical plane, $C_{44} = C_{1212}$ shear *in* the horizontal plane",
         "Whoever reads *on* as the plane that the stress acts on exchanges the two."),
    Slip("caption", "The caption of Table III", "caption of Table III", "$D_{33} = 0$", "$D_{33} = 0.3$",
         "Whoever follows the caption finds case 1 of Table II in the place of case 1 of Table III."),
    Slip("two-values", "Two values of Table IV", "Table IV", "$C_{11}/C_{33} = 1.857$ and $1.744$",
         "$0.857$ and $0.774$", "Packings with more vertical contacts would be stiffer horizontally."),
    Slip("normal-stiffness", "The normal stiffness in Figure 7(c)", "text on Figure 7",
         "the normal contact stiffness is \"hardly influenced\" by $D^{r}_{33}$", "it is not influenced at all",
         "None; the truth is simpler than the print."),
    Slip("decimals", "The third decimals of Tables II to V", "Tables II to V",
         "ratios to three decimals", "the exact values of {numref}`tab-verdicts`",
         "A program that is tested against the tables seems wrong in the third decimal. No measurement would notice."),
    Slip("invariant", "The invariant that remains constant", "text on Table V",
         "\"the first invariant of stress tensor $I_1 = (\\sigma_{33}+2\\sigma_{11})/3$\"",
         "the mean stress, a third of the first invariant", "None for Table V, whose ratios do not feel the level."),
    Slip("appendix", "The title of Appendix I", "Appendix I",
         "\"Proof of the generalized kinetic hypothesis\"",
         "proof of the generalised static hypothesis, as the text calls equation (22)",
         "A reader may take (22) for the kinematic hypothesis, whose forces are others."),
)
"""In the order of the paper."""

OF_KEY = {slip.key: slip for slip in SLIPS}


def summary() -> Markup:
    """Every slip with its place and its consequence."""
    rows = [[f"{{ref}}`{slip.title.replace('$r_{50}$', 'r50')} <{slip.label}>`", slip.where, slip.consequence]
            for slip in SLIPS]
    return table(["slip", "where", "consequence for who takes it at its word"], rows, label="tab-errata",
                 look="words-first errata", align="lll", take_away="errata.csv",
                 taken=[["slip", "where", "printed", "must be", "consequence"],
                        *([slip.title, slip.where, slip.printed, slip.must_be, slip.consequence] for slip in SLIPS)],
                 caption=f"The {len(SLIPS)} slips of the print, in the order of the paper.")


def stated(key: str) -> Markup:
    """What is printed, what it must be, and what follows."""
    slip = OF_KEY[key]
    return Markup(f"- **Printed**, {slip.where}: {slip.printed}.\n- **Must be:** {slip.must_be}.\n"
                  f"- **Consequence:** {slip.consequence}\n")


def proved(holds: object, words: str, shown: Markup | None = None) -> Markup:
    """Put below a table what the machine has just checked; what does not hold stops the build."""
    if not bool(holds):
        raise AssertionError(f"this proof fails: {words}")
    return Markup(f"{shown.text if shown else ''}\n✓ **Checked** while this page is built: {words}.\n")
