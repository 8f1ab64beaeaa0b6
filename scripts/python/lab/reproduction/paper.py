"""What the paper says in numbers, by the label of its table, figure or section."""

# Table total_comp_times: average of five starts (s), laptop with 8 cores, Ipopt with MA27, distances on all cores.
TOTAL_WALL_S = {"peg1": 85.76, "peg2": 171.33, "peg3": 391.22, "peg4": 380.18, "peg5": 343.57}

# Sec. results, Efficiency of SDF: one cube-cube distance, in words; Fig. sdfresults itself is not given as numbers.
DISTANCE_US = {
    "values": "10",
    "Jacobian": "about a third of the values",
    "Hessian": "slightly more than the Jacobian",
}

# Sec. results:peginhole on Fig. hessianapprox_comp, by Hessian and tol, in words; the figure is not given as numbers.
HESSIANS = {
    ("exact", "1e-2"): "converges",
    ("gauss-newton", "1e-2"): "5 times the iterations of exact",
    ("l-bfgs", "1e-2"): "10 times the iterations of exact",
    ("exact", "1e-6"): "converges",
    ("gauss-newton", "1e-6"): "3 of 5 fail",
    ("l-bfgs", "1e-6"): "5 of 5 fail",
}

# Sec. clamp: 5 starts x 6 magnitudes of the offset x 6 homotopy steps.
CLAMP_TRAJECTORIES = 180

# Sec. clamp on Fig. realworldresults: the figure itself is not given as numbers.
FORCE_MODE = "80 to 90 % on the diagonal, 149 of 150 in the lower right triangle"
ITERATIONS = "the smaller the final smoothing, the more motions succeed"
