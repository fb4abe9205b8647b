# A leaning block comes out of a floor: what its bodies gained, and what each account of the springs adds to it.
load style
set xlabel "time [s]"
set ylabel "energy [J]"
set xrange [0:2.2]
set key above
data = folder."/depenetration_energy.csv"
plot data using "time_s":"lifted_j" with lines linetype 1 title "put in by the fading rest offset", \
     data using "time_s":"bodies_j" with lines linetype 2 title "gained by the block", \
     data using "time_s":"damped_j" with lines linetype 3 title "damped", \
     data using "time_s":"rubbed_j" with lines linetype 4 title "rubbed", \
     data using "time_s":"brought_j" with lines linetype 5 title "births less deaths, and jumps"
