# The path of a block whose sideways gravity turns, and the friction on it every quarter of a second.
height = 420
load style
set size ratio -1
set key top left
set xlabel "x [m]"
set ylabel "z [m]"
plot folder."/turning.csv" using "x_m":"z_m" with lines linetype 1 title "path", \
     "" every 25 using "x_m":"z_m":(0.15 * column("fx_n")):(0.15 * column("fz_n")) with vectors linetype 2 title "friction"
