# Growth of a spinning bar's energy: marked, the most in 200 steps; dashed, the formula for the first step.
load style
set key bottom right
set logscale xy
set xlabel "turn in one step, |ω| Δt [rad]"
set ylabel "growth of the energy [%]"
set xrange [0.01:0.25]
set yrange [0.001:60]
data = folder."/spinning_bar.csv"
of(young) = column("young_pa") == young ? column("omega_dt") : NaN
set arrow from 0.01, 1 to 0.25, 1 nohead linetype 10
set label "1%" at 0.0105, 1.4 textcolor rgb ink
plot data using (of(1e7)):"largest_percent" with linespoints linetype 2 title "E = 10 MPa", \
     data using (of(2.5e6)):"largest_percent" with linespoints linetype 4 title "2.5 MPa", \
     data using (of(1e6)):"largest_percent" with linespoints linetype 3 title "1 MPa", \
     data using (of(1e5)):"largest_percent" with linespoints linetype 1 title "0.1 MPa", \
     data using (of(1e7)):"formula_percent" with lines linetype 10 title "formula", \
     data using (of(2.5e6)):"formula_percent" with lines linetype 10, \
     data using (of(1e6)):"formula_percent" with lines linetype 10, \
     data using (of(1e5)):"formula_percent" with lines linetype 10
