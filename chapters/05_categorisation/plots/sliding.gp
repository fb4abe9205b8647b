# The sliding cube, labelled: its pairs by kind and label, and what they give sideways.
height = 620
load style
set multiplot layout 3,1 margins 0.12,0.98,0.11,0.97 spacing 0,0.04
file = folder."/sliding.csv"
set xrange [0:1]
set format x ""
set ylabel "pairs"
set key top center horizontal maxrows 2
set yrange [0:24]
plot file using "time_s":"vf_regular" with steps linetype 1 title "VF regular", \
     "" using "time_s":"ee_regular" with steps linetype 3 title "EE regular", \
     "" using "time_s":"vf_hooked" with steps linetype 2 title "VF hooked", \
     "" using "time_s":"ee_hooked" with steps linetype 4 title "EE hooked"
set yrange [*:*]
set key top right
set ylabel "sideways impulse [N s]"
plot file using "time_s":"sideways_n_s" with steps linetype 6 title "of all pairs", \
     "" using "time_s":"hooked_sideways_n_s" with steps linetype 2 dashtype 3 title "of hooked pairs"
set format x "%g"
set xlabel "time [s]"
set ylabel "speed [m/s]"
unset key
plot 0 linetype 10, file using "time_s":"speed_m_per_s" with lines linetype 1
unset multiplot
