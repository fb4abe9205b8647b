# A point a setting: how deep a stack rests, and what part of its amplitude a swing loses, over processor time.
height = 640
load style
set multiplot layout 2,1 margins 0.13,0.74,0.13,0.98 spacing 0,0.16
set logscale xy
set format xy "10^{%L}"
set xlabel "processor time of a frame over ours"
set xrange [0.01:30]
set key outside right
set linetype 8 linecolor rgb "#9a6a3a"  # the eighth would be black, which a dark page hides
data = folder."/error_over_time.csv"
of(scene, engine) = strcol("scene") eq scene && strcol("engine") eq engine ? column("error") : NaN
engines = "'chapter 10' 'chapter 11' Bullet ODE 'MuJoCo of npm' Jolt Rapier DART"
set ylabel "stack: depth [µm]"
plot for [i=1:words(engines)] data using "time_over_ours_by_clock":(of("stack", word(engines, i))) with points linetype i pointtype 4 + i pointsize 0.9 title word(engines, i)
set ylabel "pipe of 120: amplitude lost"
plot for [i=1:words(engines)] data using "time_over_ours_by_clock":(of("pipe_120", word(engines, i))) with points linetype i pointtype 4 + i pointsize 0.9 title word(engines, i)
unset multiplot
