# A reader's own scene: its energy, and how deep its pairs are.
height = 480
load style
set multiplot layout 2,1 margins 0.13,0.98,0.145,0.97 spacing 0,0.04
set format x ""
set ylabel "energy [J]"
set key top right
plot folder."/energy.csv" using "time_s":"total_j" with lines linetype 3 title "all but the penalty's", \
     "" using "time_s":"kinetic_j" with lines linetype 1 title "kinetic", \
     "" using "time_s":"elastic_j" with lines linetype 4 title "elastic"
set format x "%g"
set xlabel "time [s]"
set ylabel "deepest pair [mm]"
set yrange [0:*]
unset key
plot folder."/penetration.csv" using "time_s":(1000*column("depth_max_m")) with lines linetype 1
unset multiplot
