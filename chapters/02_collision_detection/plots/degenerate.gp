# Touches missed and invented by the textbook without tolerances, for each kind of hard query.
height = 420
load style
set lmargin 22
set style fill solid 0.85 noborder
set boxwidth 0.7
set xlabel "wrong answers of the textbook, tolerances 0"
set ylabel ""
set xrange [0:21]
set key outside top center horizontal
set grid noytics
data = folder."/degenerate_categories.csv"  # columns: 1 category, 4 "missed + invented" with tolerances 0
missed(row) = real(word(strcol(4), 1))
invented(row) = real(word(strcol(4), 3))
name(row) = system("echo ".strcol(1)." | tr _ ' '")
plot data skip 1 using (0.5 * missed(0)):0:(0):(missed(0)):($0 - 0.35):($0 + 0.35):ytic(name(0)) \
         with boxxyerror linetype 2 title "missed", \
     data skip 1 using (missed(0)):0:(missed(0)):(missed(0) + invented(0)):($0 - 0.35):($0 + 0.35) \
         with boxxyerror linetype 4 title "invented"
