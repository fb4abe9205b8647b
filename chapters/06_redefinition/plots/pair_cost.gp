# What one pair takes, stage by stage (thesis figure 7.17): with mass-splitting friction, with the thesis', and after the impact.
height = 420
load style
set style data histograms
set style histogram rowstacked
set style fill solid 0.85 noborder
set boxwidth 0.6
set ylabel "time per pair [ns]"
set yrange [0:*]
set xtics scale 0
set bmargin 4
set key outside right top reverse Left
plot folder."/pair_cost.csv" using "resolve":xtic(strcol("pair")."\n".strcol("run")) linetype 1 title "resolve", \
     "" using "categorise" linetype 2 title "categorise", \
     "" using "redefine" linetype 3 title "redefine", \
     "" using "dpf" linetype 4 title "impulse, DPF", \
     "" using (column("cpf")-column("dpf")) linetype 5 title "CPF on top", \
     "" using "friction" linetype 6 title "friction"
