# The part of the problems that each solver brings below an error, within a factor of the best one's time.
height = 360
load style
set multiplot layout 1,3 margins 0.11,0.83,0.21,0.87 spacing 0.04,0
set xlabel "time over the best"
set logscale x
set xrange [1:1000]
set xtics ("1" 1, "10" 10, "100" 100, "10^3" 1000)
set yrange [0:105]
set ylabel "problems solved [%]" offset 1,0
data = folder."/profile.csv"
solvers = "ours NSGS Newton ADMM"
has(solver) = strstrt(system("head -1 '".data."'"), solver."_") > 0
do for [i=1:3] {
    set title "to 10^{".word("-4 -6 -8", i)."}"
    if (i == 3) { set key at screen 0.995,0.75 right top vertical } else { unset key }
    if (i > 1) { set format y ""; unset ylabel }
    plot for [s=1:words(solvers)] has(word(solvers, s)) ? data : "/dev/null" using "time_over_best":(column(word(solvers, s)."_".word("1e-4 1e-6 1e-8", i)."_percent")) with steps linetype s linewidth 2 title word(solvers, s)
}
unset multiplot
