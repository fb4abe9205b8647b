# A line an engine, with default settings: how far a cube of a pyramid moves in two thirds of a second, and the time of a frame, over the cubes.
height = 640
load style
set multiplot layout 2,1 margins 0.13,0.74,0.13,0.98 spacing 0,0.16
set logscale xy
set format y "10^{%L}"
set xlabel "cubes"
set xrange [80:6500]
set key outside right
set linetype 8 linecolor rgb "#9a6a3a"  # the eighth would be black, which a dark page hides
data = folder."/growing.csv"
of(engine) = strcol("engine") eq engine && strcol("way") eq "default" ? column("bodies") : NaN
engines = "'chapter 10' 'chapter 11' Bullet ODE 'MuJoCo of npm' Jolt Rapier"
set ylabel "moved [mm]"
plot for [i=1:words(engines)] data using (of(word(engines, i))):"moved_mm" with linespoints linetype i pointtype 4 + i pointsize 0.9 title word(engines, i)
set ylabel "time of a frame over the first"
plot for [i=1:words(engines)] data using (of(word(engines, i))):"time_over_first_by_clock" with linespoints linetype i pointtype 4 + i pointsize 0.9 title word(engines, i)
unset multiplot
