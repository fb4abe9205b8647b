# The ground's force on each body over time, beside its weight.
height = 520
load style
set multiplot layout 2,1 margins 0.12,0.98,0.135,0.96 spacing 0,0.06
set xrange [0:2.5]
set ylabel "force [N]"
names = "bar cube"
weights = "49.05 9.81"
tops = "400 110"
do for [i=1:2] {
    name = word(names, i)
    set yrange [0:word(tops, i)+0]
    set format x (i == 2 ? "%g" : "")
    set xlabel (i == 2 ? "time [s]" : "")
    plot word(weights, i)+0 linetype 10 title name.": weight", \
         folder."/ground.csv" using (strcol("method") eq "DPF" ? column("time_s") : NaN):"force_n" every 2::(i-1) with lines linetype 2 title "DPF", \
         "" using (strcol("method") eq "CPF" ? column("time_s") : NaN):"force_n" every 2::(i-1) with lines linetype 1 title "CPF"
}
unset multiplot
