# The smallest mu_s that holds, relative to tan(angle), over the damping ratio; theory of one degree of freedom.
load style
set xlabel "damping ratio"
set ylabel "smallest μ_s / tan α"
set logscale x
set xrange [0.04:30]
set yrange [0.95:2.3]
t(a) = tan(a * pi / 180)
root(z) = sqrt(abs(1 - z * z))
turn(z) = root(z) < 1e-6 ? 1 : (z < 1 ? acos(z) : acosh(z)) / root(z)
on(m, a, x) = strcol("model") eq m && column("angle_deg") == a ? x : NaN
plot 1 linetype 10, 1 + exp(-2 * x * turn(x)) linetype 10 dashtype 2 title "one degree of freedom", \
     for [a in "5 10 20 30"] folder."/threshold.csv" using "damping_ratio":(on("yamane_nakamura", a + 0, column("mu_s") / t(a + 0))) with points linetype 2 pointtype (a eq "5" ? 6 : a eq "10" ? 4 : a eq "20" ? 8 : 12) title "Yamane and Nakamura, ".a."°", \
     for [a in "5 10 20 30"] "" using "damping_ratio":(on("mass_splitting", a + 0, column("mu_s") / t(a + 0))) with points linetype 1 pointtype (a eq "5" ? 6 : a eq "10" ? 4 : a eq "20" ? 8 : 12) title (a eq "5" ? "mass_splitting" : "")
