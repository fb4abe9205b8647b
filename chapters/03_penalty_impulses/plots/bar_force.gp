# The vertical force of the cube on the bar, around the largest smooth step of each method (thesis figure 7.4).
height = 640
load style
set multiplot layout 4,2 margins 0.09,0.99,0.11,0.95 spacing 0.05,0.045
set xrange [0:4]
set yrange [-0.2:4.5]
set xtics 0,1
set ytics 0,1
methods = "DPF CPF"
do for [row=1:4] {
    dt = 0.004 + 0.002*row
    do for [m=1:2] {
        set title (row == 1 ? word(methods, m) : "") offset 0,-0.6
        set format x (row == 4 ? "%g" : "")
        set xlabel (row == 4 ? "time [s]" : "")
        set format y (m == 1 ? "%g" : "")
        set ylabel (m == 1 ? "force [kN]" : "")
        set label 1 sprintf("Δt = %.3f s", dt) at graph 0.97,0.82 right textcolor rgb ink
        chosen(x) = strcol("figure") eq "7.4" && strcol("method") eq word(methods, m) && abs(column("dt_s") - dt) < 1e-9 ? x : NaN
        plot 0.7848 linetype 10, folder."/bar_force.csv" using "time_s":(chosen(column("force_n")/1000)) with lines linetype 3-m linewidth 0.8
    }
}
unset multiplot
