# Four drops, each method below and above its stable step (thesis figure 7.1).
height = 560
load style
set multiplot layout 2,2 margins 0.12,0.98,0.125,0.94 spacing 0.1,0.13
set xrange [0:10]
set yrange [-0.15:0.75]
set ytics 0,0.2
panel = "abcd"
what = "'CPF, Δt = 0.14 s' 'CPF, Δt = 0.17 s' 'DPF, Δt = 0.11 s' 'DPF, Δt = 0.13 s'"
do for [i=1:4] {
    set title word(panel, 1)[i:i].")  ".word(what, i) offset 0,-0.6
    set xlabel (i > 2 ? "time [s]" : "")
    set ylabel (i % 2 ? "height [m]" : "")
    plot 0 linetype 10, \
         folder."/drop.csv" using (strcol("panel") eq panel[i:i] ? column("time_s") : NaN):"height_m" \
         with linespoints linetype (i < 3 ? 1 : 2) linewidth 1 pointsize 0.35
}
unset multiplot
