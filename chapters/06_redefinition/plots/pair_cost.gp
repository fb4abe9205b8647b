# What one pair takes, stage by stage (thesis figure 7.17): with mass-splitting friction, with the thesis', and after the impact.
# A bar is what it takes with CPF; with DPF, all other stages being the same, it is as high as the mark.
height = 460
load style
set style data histograms
set style histogram rowstacked
set style fill solid 0.85 noborder
set boxwidth 0.6
set ylabel "time per pair [ns]"
set yrange [0:*]
set xtics scale 0
stats folder."/pair_cost.csv" using "resolve" nooutput
set xrange [-0.6:STATS_records - 0.4]
set bmargin 5
set key outside right top reverse Left invert
in_two_lines(run) = run eq "mass_splitting" ? "mass\nsplitting" : run eq "thesis" ? "thesis'\nfriction" : run
plot folder."/pair_cost.csv" using "resolve":xtic(strcol("pair")."\n".in_two_lines(strcol("run"))) linetype 5 title "resolve", \
     "" using "categorise" linetype 3 title "categorise", \
     "" using (column("redefine") > 0 ? column("redefine") : 0) linetype 4 title "redefine", \
     "" using "cpf" linetype 1 title "impulse, CPF", \
     "" using "friction" linetype 6 title "friction", \
     "" using 0:"with_dpf" with points linetype 2 pointtype 13 pointsize 1 title "all, with DPF"
