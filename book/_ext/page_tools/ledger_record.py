"""The record behind the coverage ledger: every equation, table and figure of the paper, and what its text claims.

What can be read off elsewhere is not kept here: derivations name the equations they start from, docstrings those that
they compute, pages the steps that they show. Kept are what a place of the paper says, which function stands for it,
the test that would fail if it were wrong, and the verdict.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class Verdict(Enum):
    """What became of a place of the paper, and what that means."""

    CONFIRMED = "confirmed", "follows from what stands before it, as printed"
    DEFINITION = "definition", "nothing to prove: it names something"
    RULE = "its rule", "the printed digits are those of the paper's own quadrature; the exact value differs"
    NEARLY = "nearly", "holds in a limit and is an approximation elsewhere"
    OPEN = "not unique", "has many solutions, of which one must be chosen"
    REDRAWN = "redrawn", "drawn from the text of the paper, not compared with the printed curves point by point"
    MISPRINT = "misprint", "the print is wrong, the model is not"
    REFUTED = "does not follow", "a claim that the equations of the paper do not bear out"

    def __init__(self, words: str, meaning: str) -> None:
        self.words = words
        self.meaning = meaning


@dataclass(frozen=True, slots=True)
class Entry:
    """One place of the paper.

    Attributes
    ----------
    place : str
        ``(7)``, ``Table II``, ``Figure 5``, or where in the text.
    says : str
        What stands there, in a few words.
    rulings : tuple of (Verdict, str)
        Verdicts, each with the label of the section that explains it, empty where the derivation does.
    tested : str
        ``FILE::FUNCTION`` below ``tests``: what fails if the place is computed or judged wrongly.
    computed : tuple of str
        Full names of the functions that stand for it; none where there is only something to prove.
    shown : str
        ``PAGE`` or ``PAGE:LABEL`` of a figure or table, for what no derivation leads to.
    """

    place: str
    says: str
    rulings: tuple[tuple[Verdict, str], ...]
    tested: str
    computed: tuple[str, ...] = ()
    shown: str = ""


CONFIRMED = ((Verdict.CONFIRMED, ""),)
DEFINITION = ((Verdict.DEFINITION, ""),)
REDRAWN = ((Verdict.REDRAWN, ""),)
SUMS, BRANCHES = "granular/test_contacts_sums.py", "granular/test_branch_stiffness.py"
SIZES = "granular/gradation/test_sizes.py"
LENGTHS, FORCES = "granular/gradation/test_branch_lengths.py", "derivations/test_forces.py"
DRAWN, SIZES_DRAWN = "granular/test_figures.py", "granular/test_figures_gradation.py"
GRAINS, KINETIC = "granular/test_evaluate_grains.py", "granular/test_axial_kinetic.py"
SUM_OF_CONTACTS = ("granular.contacts.kernels.stiffness_sum",)
DENSITIES = ("granular.gradation.branch_lengths.branch_lengths",)
CONTACTS = ("granular.number_of_contacts.contacts_per_volume",)
CARRIED = ("granular.spheroid.stress_carried",)
BY_DIRECTION = ("granular.figures.paper_figure_7_9.draw",)
EXACT_AND_RULE = ("granular.routes.axial.evaluate", "granular.routes.midpoint.evaluate")

EQUATIONS = (
    Entry("(1)", "stiffness as a sum over contacts", CONFIRMED,
          f"{SUMS}::test_raw_sum_is_equation_1_as_it_stands", SUM_OF_CONTACTS),
    Entry("(2)", "stiffness of one contact", CONFIRMED,
          f"{SUMS}::test_both_ways_of_summing_are_the_symmetrised_sum", SUM_OF_CONTACTS),
    Entry("(3)", "equal spheres", CONFIRMED,
          "granular/test_contact_law.py::test_walton_rough_limit", ("granular.evaluation.evaluate",)),
    Entry("(4)", "equal spheres as an average over directions", CONFIRMED,
          "granular/test_array_stiffness.py::test_equal_to_the_scalar_routes",
          ("granular.array_stiffness.axial_stiffness",)),
    Entry("(5)", "contacts sorted by direction and length", CONFIRMED,
          f"{BRANCHES}::test_the_deviation_of_spheroids", ("granular.branch_products.deviating",)),
    Entry("(6)", "branches off the contact normals", CONFIRMED,
          f"{BRANCHES}::test_branches_that_are_all_turned_alike",
          ("granular.branch_stiffness.stiffness_by_direction",)),
    Entry("(7)", "branches along the contact normals", CONFIRMED,
          f"{BRANCHES}::test_lengths_along_the_normals_are_eq_7", ("granular.branch_products.along_normals",)),
    Entry("(8)", "contacts in a volume", CONFIRMED,
          "granular/test_number_of_contacts.py::test_crystals_by_counting", CONTACTS),
    Entry("(9)", "grains in a volume", CONFIRMED,
          "granular/test_number_of_contacts.py::test_is_three_N_over_pi_times_one_plus_e", CONTACTS),
    Entry("(10)", "volume of the solid", CONFIRMED,
          "granular/gradation/test_readings.py::test_a_narrow_cut_leaves_equal_spheres",
          ("granular.gradation.cut_sizes.cut",)),
    Entry("(11)", "grains in a volume by their mean cube", CONFIRMED,
          f"{GRAINS}::test_contacts_per_volume_count_grains_of_the_mean_volume",
          ("granular.gradation.stiffness_numbers.numbers_of",)),
    Entry("(12)", "sizes by number from sizes by volume", CONFIRMED,
          "derivations/test_gradation.py::test_number_density", DENSITIES),
    Entry("(13)", "gradation curve", DEFINITION, f"{SIZES}::test_densities_integrate_to_one",
          ("granular.gradation.size_distribution.SizeDistribution.fraction_finer",)),
    Entry("(14)", "branch lengths weighted by direction", DEFINITION,
          "granular/test_directions.py::test_averages_over_the_sphere_are_one", ("granular.fabric.AxialFabric",)),
    Entry("(15)", "branch lengths alike in all directions", DEFINITION,
          f"{GRAINS}::test_sizes_multiply_the_stiffness_of_equal_spheres", ("granular.evaluation.evaluate",)),
    Entry("(16)", "lengths of all branches", ((Verdict.CONFIRMED, ""), (Verdict.MISPRINT, "sec-erratum-limits")),
          f"{LENGTHS}::test_total_density_by_its_definition", DENSITIES),
    Entry("(17)", "lengths of the branches in one direction", DEFINITION,
          f"{LENGTHS}::test_certified_second_moments", DENSITIES),
    Entry("(18)", "lognormal sizes", DEFINITION, f"{SIZES}::test_eq_18_as_printed",
          ("granular.gradation.lognormal.Lognormal",)),
    Entry("(19)", "lognormal branch lengths", ((Verdict.NEARLY, "sec-erratum-lognormal"),),
          "granular/gradation/test_readings.py::test_the_third_moment_of_a_lognormal_sum_is_too_small",
          ("granular.gradation.readings.lognormal_lengths",)),
    Entry("(20)", "normal stiffness of a contact", CONFIRMED,
          f"{FORCES}::test_printed_factor_of_hertz", ("granular.contact_law.normal_stiffness",)),
    Entry("(21)", "shear stiffness of a contact", ((Verdict.MISPRINT, "sec-erratum-shear-stiffness"),),
          f"{FORCES}::test_shear_stiffness_falls_from_full_to_none",
          ("granular.contact_distribution.shear_stiffness",)),
    Entry("(22)", "contact forces by a fabric tensor of any rank", ((Verdict.OPEN, ""),),
          f"{FORCES}::test_rank_four_has_the_least_norm", ("granular.contacts.estimate.estimated_forces",)),
    Entry("(23)", "contact forces by the fabric tensor of rank two", CONFIRMED,
          "granular/test_loading.py::test_forces_balance_the_stress", ("granular.contact_distribution.normal_force",)),
    Entry("(24)", "mean stress as a sum over contacts", CONFIRMED,
          "granular/test_spheroid_forces.py::test_the_sum_over_the_contacts_is_the_given_stress", CARRIED),
    Entry("(25)", "mean stress as an average over directions", CONFIRMED,
          "granular/test_loading.py::test_forces_integrate_to_the_stress", CARRIED),
    Entry("(26)", "the estimate inserted", CONFIRMED, f"{FORCES}::test_axial_forces_return_the_stress"),
    Entry("(27)", "the branch length cancels", CONFIRMED, f"{FORCES}::test_axial_forces_return_the_stress"),
    Entry("(28)", "the mean stress comes back", CONFIRMED, f"{FORCES}::test_rank_four_balances"),
)

TABLES = (
    Entry("Table I", "sizes and spreads of six gradations", CONFIRMED,
          f"{SIZES_DRAWN}::test_printed_coefficients_of_uniformity_follow_from_the_spreads",
          ("granular.figures.paper_figures_3_4.table_i",), "table_i:tab-table-i"),
    Entry("Table II", "fabric alone", ((Verdict.RULE, "sec-erratum-decimals"),),
          "granular/test_reference.py::test_table_ii_by_the_printed_rule",
          ("granular.routes.exact.evaluate", "granular.routes.midpoint.evaluate"), "table_ii:tab-table-ii"),
    Entry("Table III", "contact forces and slip",
          ((Verdict.RULE, "sec-erratum-decimals"), (Verdict.MISPRINT, "sec-erratum-caption")),
          f"{KINETIC}::test_tables_iii_to_v", EXACT_AND_RULE, "table_iii:tab-table-iii"),
    Entry("Table IV", "three packings under isotropic stress",
          ((Verdict.RULE, "sec-erratum-decimals"), (Verdict.MISPRINT, "sec-erratum-two-values")),
          f"{KINETIC}::test_tables_iii_to_v", EXACT_AND_RULE, "table_iv:tab-table-iv"),
    Entry("Table V", "three stress ratios", ((Verdict.RULE, "sec-erratum-decimals"),),
          f"{KINETIC}::test_tables_iii_to_v", EXACT_AND_RULE, "table_v:tab-table-v"),
)

FIGURES = (
    Entry("Figure 1", "kinematic and static hypothesis", CONFIRMED, "granular/test_bounds.py::test_order_of_the_bounds",
          ("granular.array_stiffness.axial_stiffness",), "static:fig-hypotheses"),
    Entry("Figure 2", "coordinates", DEFINITION, "derivations/test_sphere.py::test_sphere_mean_from_circle_and_axis",
          ("granular.figures.axes_and_angles.coordinates",), "conventions:fig-coordinates"),
    Entry("Figure 3", "gradation curves", REDRAWN, f"{SIZES_DRAWN}::test_figure_3_draws_diameters",
          ("granular.figures.paper_figures_3_4.figure_3",), "figure_3:fig-three"),
    Entry("Figure 4", "densities of sizes and lengths", REDRAWN,
          f"{SIZES_DRAWN}::test_densities_of_figure_4_have_area_one",
          ("granular.figures.paper_figures_3_4.figure_4",), "figure_4:fig-four"),
    Entry("Figure 5", "weights over the directions", REDRAWN, f"{DRAWN}::test_surfaces_show_value_as_distance",
          ("granular.figures.paper_figure_5.figure_5",), "figure_5:fig-five"),
    Entry("Figure 6", "stiffness against branch anisotropy", REDRAWN,
          f"{DRAWN}::test_figure_6_against_the_expansion_in_dr",
          ("granular.figures.paper_figure_6.figure_6",), "figure_6:fig-six"),
    Entry("Figure 7", "contacts of four microstructures",
          ((Verdict.REDRAWN, ""), (Verdict.MISPRINT, "sec-erratum-normal-stiffness")),
          "granular/test_figures_mohr.py::test_forces_and_stiffnesses_of_the_papers_assemblies", BY_DIRECTION,
          "figure_7:fig-seven"),
    Entry("Figure 8", "contacts of three packings", REDRAWN,
          "granular/test_figures_mohr.py::test_forces_and_stiffnesses_of_the_papers_assemblies", BY_DIRECTION,
          "figure_8:fig-eight"),
    Entry("Figure 9", "contacts under three stress ratios", REDRAWN,
          "granular/test_figures_contacts.py::test_the_sliding_range_at_stress_ratio_two",
          ("granular.figures.contacts.contacts_figure",), "figure_9:fig-nine"),
)

TEXT = (
    Entry("introduction", "which hypothesis gives which bound", ((Verdict.MISPRINT, "sec-erratum-hypotheses"),),
          "granular/test_bounds.py::test_order_of_the_bounds", ("granular.array_stiffness.axial_stiffness",), "static"),
    Entry("below (19)", "$r_{50}$ is the sample mean", ((Verdict.MISPRINT, "sec-erratum-mode"),),
          f"{SIZES}::test_the_printed_median_is_the_mode", ("granular.gradation.lognormal.Lognormal",), "gradation"),
    Entry("text on $r_{pqik}$", "branches along the normals are adequate", ((Verdict.REFUTED, "sec-collinear"),),
          "book/test_shape_page.py::test_words_on_the_collinear_assumption_come_from_the_library",
          ("granular.collinear.collinear_error",), "shape"),
    Entry("N_ij below (23)", "fabric tensor $N_{ij}$", ((Verdict.MISPRINT, "sec-erratum-fabric-tensor"),),
          f"{FORCES}::test_printed_fabric_tensor_fails", ("granular.effects.kinetic.force_coefficients",)),
    Entry("text, material", "$G_s$ = 31 Pa", ((Verdict.MISPRINT, "sec-erratum-grain-modulus"),),
          "granular/test_contact_law.py::test_the_papers_isotropic_assembly",
          ("granular.contact_law.reference_stiffness",), "errata"),
    Entry("text, stiffness", "5465, 2665 and 134 MPa", ((Verdict.MISPRINT, "sec-erratum-isotropic"),),
          "granular/test_hertz_mindlin.py::test_library_agrees", ("granular.hertz_mindlin.moduli",),
          "claims:tab-implied"),
    Entry("text, curves 1–3", "no influence of the mean size", ((Verdict.CONFIRMED, "sec-mean-size"),),
          f"{GRAINS}::test_the_mean_size_does_not_matter", ("granular.evaluation.evaluate",), "claims:tab-mean-size"),
    Entry("text, curves 4–6", "no influence of uniformity", ((Verdict.REFUTED, "sec-erratum-uniformity"),),
          f"{LENGTHS}::test_uniformity_does_matter", ("granular.gradation.readings.literal",), "claims:tab-uniformity"),
    Entry("text, Table II", "$C_{66}$ is shear on the vertical plane, $C_{44}$ on the horizontal",
          ((Verdict.MISPRINT, "sec-erratum-shear"),),
          "granular/test_elasticity.py::test_the_papers_c44_is_horizontal_shear",
          ("granular.elastic_tensor.ElasticTensor.voigt",), "conventions"),
    Entry("text below Table II", "horizontal shear waves are the fastest", ((Verdict.REFUTED, "sec-other-claims"),),
          "derivations/test_waves.py::test_the_claim_is_not_general", ("granular.waves.waves",)),
    Entry("text, Table V", "the first invariant $I_1$ remains constant", ((Verdict.MISPRINT, "sec-erratum-invariant"),),
          "book/test_errata_page.py::test_every_proof_holds", ("granular.loading.Loading",), "table_v"),
    Entry("Appendix I", "its title: a kinetic hypothesis", ((Verdict.MISPRINT, "sec-erratum-appendix"),),
          "book/test_errata_page.py::test_every_proof_holds", (), "forces"),
)

ENTRIES = (*EQUATIONS, *TABLES, *FIGURES, *TEXT)
