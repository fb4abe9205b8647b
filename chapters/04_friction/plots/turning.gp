# The path of a block whose sideways gravity turns, and how far friction is off the slip's opposite.
height = 520
load style
set multiplot layout 2,1 margins 0.12,0.98,0.135,0.97 spacing 0,0.14
unset key
set xlabel "x [m]"
set ylabel "z [m]"
plot folder."/turning.csv" using "x_m":"z_m" with lines linetype 1
set xlabel "time [s]"
set ylabel "angle error [°]"
set xrange [0:8]
set logscale y
plot folder."/turning.csv" using "time_s":"angle_error_deg" with lines linetype 1
unset multiplot
