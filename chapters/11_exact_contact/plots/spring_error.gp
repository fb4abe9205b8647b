# The natural map of springs over their stiffness: alone, and with passes that remember.
load style
set xlabel "h = k Δt² / m"
set ylabel "natural map"
set logscale xy
set format x "10^{%L}"
set format y "10^{%L}"
set yrange [1e-16:10]
set key above
data = folder."/spring_error.csv"
plot data using "h":"block" with lines linetype 1 dashtype 2 title "block, one solve", \
     data using "h":"block_2_passes" with lines linetype 2 dashtype 2 title "block, 2 passes", \
     data using "h":"many" with lines linetype 1 title "54 contacts, one solve", \
     data using "h":"many_2_passes" with lines linetype 2 title "2 passes", \
     data using "h":"many_4_passes" with lines linetype 3 title "4 passes", \
     data using "h":"many_8_passes" with lines linetype 4 title "8 passes"
