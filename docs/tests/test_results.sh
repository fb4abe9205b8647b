#!/usr/bin/env bash
# Which results hold, and how experiments run beside each other: a copy of the course command, in a folder with a space and an umlaut,
# with false programs that write down what they ran.
set -u
cd "$(dirname "$(readlink -f "$0")")/../.." || exit 1
failed=0
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
here="$scratch/Größe & mehr"
mkdir -p "$here/chapters/01_particle_plane/plots" "$here/chapters/"{solvers,engines} "$here/common/"{scenes,meshes,experiments/verification} "$here/cmake" \
    "$here/bin" "$here/build/release/bin"
cp course "$here"
cp cmake/*.sh cmake/*.py cmake/packages.txt "$here/cmake"
list='{"drop", "a drop", drop}, {"ground", "a ground", ground},'
echo "$list" | tee "$here/common/experiments/verification/main.cpp" "$here/chapters/solvers/main.cpp" >"$here/chapters/01_particle_plane/main.cpp"
: >"$here/chapters/engines/main.cpp" # no experiments
echo 'plot 1' >"$here/chapters/01_particle_plane/plots/drop.gp"
echo '{}' >"$here/common/scenes/ground.json"
: >"$here/build/release/build.ninja"
cd "$here" || exit 1
printf '01_particle_plane ground 1 1 3\nsolvers ground 1 1 1 alone\n' >cmake/experiments.txt
export PATH=$here/bin:$PATH
unset ENDURING_BUILD CI
printf '#!/bin/bash\n' >bin/cmake # builds nothing

program() { # NAME FOLDER: runs an experiment, or both; writes a table of it and names it, or with --part nothing
    cat >"build/release/bin/$1" <<END
#!/bin/bash
words=" \$* " out=build/results/$2 ran=\$1
[[ \$words != *" --quick "* ]] || out=build/results-quick/$2
[[ ! \$words =~ " --out "(.*)" --" && ! \$words =~ " --out "(.*)" "\$ ]] || out=\${BASH_REMATCH[1]}
out=\${out% --*}
[[ \$words != *" --full"* ]] || exit 2
[[ ! \$words =~ --part\ ([^ ]*) ]] || ran+=.\${BASH_REMATCH[1]}
echo "$1/\$ran" >>"$scratch/ran"
echo begins >>"$scratch/$1.\${ran//\//of}"
[[ ! -e "$scratch/slow" ]] || { echo "\$ran" >>"$scratch/begun"; sleep 30; }
[[ ! -e "$scratch/stop" || \$1 != drop ]] || { echo "no, it breaks"; exit 1; }
[[ \$words != *" --part "* ]] || exit 0
[[ \$words != *" elsewhere "* ]] || exit 0
mkdir -p "\$out"
for word in "\$@"; do [[ \$word == --scene ]] && echo other >"\$out/drop.csv"; done
[[ \$1 == -* ]] || echo 1 >"\$out/\$1.csv"
echo "  \$1  \$1.csv"
END
    chmod +x "build/release/bin/$1"
}
chmod +x bin/cmake
program base 00_base
program chapter01 01_particle_plane
program solvers solvers

expect() { # WHAT-RAN DESCRIPTION ARGUMENT...: what a command runs
    local got
    rm -f "$scratch/ran"
    ./course "${@:3}" >"$scratch/said" 2>&1 </dev/null
    got=$(sort "$scratch/ran" 2>/dev/null | paste -sd' ')
    if [[ $got != "$1" ]]; then
        printf 'FAILED: %s: "%s" ran, and should have been "%s"\n%s\n' "$2" "$got" "$1" "$(cat "$scratch/said")"
        failed=1
    fi
}
says() { # PATTERN: the last command
    grep -q -e "$1" "$scratch/said" || { printf 'FAILED: no line with "%s" in\n%s\n' "$1" "$(cat "$scratch/said")"; failed=1; }
}
everything=(run --no-install)
all='base/drop base/ground chapter01/drop chapter01/ground solvers/drop solvers/ground'

expect "$all" "nothing is there yet" "${everything[@]}"
says '6 experiments on .* cores: about'
says 'chapter 1, drop: .* s; '
says 'A first picture\|all is there after'
[[ $(tail -1 "$scratch/ran") == solvers/ground ]] || { echo "FAILED: what measures time did not run last"; failed=1; }
expect '' "all is there" "${everything[@]}"
expect '' "and --quick is the same" run --quick --no-install
expect '' "the book takes the same" docs --quick --no-install
touch build/release/bin/*
expect '' "the same programs, built again" "${everything[@]}"
echo '# more' >>build/release/bin/chapter01
expect 'chapter01/drop chapter01/ground' "another program" "${everything[@]}"
echo '{"dt": 1}' >common/scenes/ground.json
expect "$all" "another scene" "${everything[@]}"
touch common/scenes/ground.json
expect '' "the same scene, saved again" "${everything[@]}"
echo 'plot 2' >chapters/01_particle_plane/plots/drop.gp
expect 'chapter01/drop chapter01/ground' "another plot" "${everything[@]}"
echo '# comment' >chapters/01_particle_plane/chapter.md
expect '' "another text" "${everything[@]}"
rm build/results-quick/solvers/drop.csv
expect 'solvers/drop' "a result is gone" "${everything[@]}"

# A full run is another one; in it large experiments come in parts, and are joined when all of these are there.
expect 'chapter01/drop chapter01/ground chapter01/ground.1/3 chapter01/ground.2/3 chapter01/ground.3/3' "a full run" run 1 --full --no-install
[[ $(tail -1 "$scratch/ran") == chapter01/ground ]] || { echo "FAILED: the parts were joined before they were there"; failed=1; }
[[ -e build/results/01_particle_plane/.made_by ]] || { echo "FAILED: nobody has made the full results"; failed=1; }

# What fails stops no other, and is named; the next command takes it up again.
touch "$scratch/stop"
rm build/results-quick/{00_base,01_particle_plane}/*.csv
expect 'base/drop base/ground chapter01/drop chapter01/ground' "runs that break" "${everything[@]}"
says 'failed: chapter 1, drop: exit status 1; what it printed: build/results-quick/.runs/logs/done.01_particle_plane.drop.txt'
says '     | no, it breaks'
if ./course "${everything[@]}" >/dev/null 2>&1; then echo "FAILED: what broke ends with 0"; failed=1; fi
[[ ! -e build/results-quick/01_particle_plane/.made_by ]] || { echo "FAILED: what broke counts as made"; failed=1; }
rm "$scratch/stop"
expect 'base/drop chapter01/drop' "what broke does not hold" "${everything[@]}"

# What is named again runs again; a run that was stopped goes on.
expect 'chapter01/drop' "one experiment, by the same program" run 1 drop --no-install
expect '' "that changes nothing" "${everything[@]}"
rm build/results-quick/01_particle_plane/ground.csv
expect 'chapter01/ground' "a chapter of which one is missing" run 1 --no-install
expect 'chapter01/drop chapter01/ground' "a chapter of which all is there" run 1 --no-install
touch "$scratch/slow"
setsid bash -c 'exec ./course run 1 --no-install' >/dev/null 2>&1 </dev/null &
for ((i = 0; i < 100; ++i)); do [[ ! -e $scratch/begun ]] || break; sleep 0.1; done
kill -INT -- -$! 2>/dev/null
for ((i = 0; i < 100; ++i)); do kill -0 $! 2>/dev/null || break; sleep 0.1; done
if kill -0 $! 2>/dev/null; then echo "FAILED: Ctrl-C does not stop it"; failed=1; kill -KILL -- -$!; fi
rm "$scratch/slow"
expect 'chapter01/drop chapter01/ground' "what was stopped" run 1 --no-install
mkdir "$scratch/site" # an edge hears of Ctrl-C also when it comes while Python loads, whose own errors then swallow it
cat >"$scratch/site/sitecustomize.py" <<'END'
import os, signal, sys
try:
    if any(word.endswith("run_one.py") for word in sys.orig_argv):
        os.kill(os.getpid(), signal.SIGINT)
except KeyboardInterrupt:
    pass
END
PYTHONPATH=$scratch/site expect '' "what was stopped while it began" run 1 --no-install
expect 'chapter01/drop chapter01/ground' "and what it left" run 1 --no-install

# What goes behind -- runs by itself, in full.
expect 'chapter01/--scene' "an own scene into the results" run 1 --no-install -- --scene own.json
expect 'chapter01/drop chapter01/ground chapter01/ground.1/3 chapter01/ground.2/3 chapter01/ground.3/3' "they do not hold then" run 1 --full --no-install
expect '' "the small ones do" "${everything[@]}"
expect 'chapter01/elsewhere' "results elsewhere" run 1 --no-install -- elsewhere
expect '' "these change nothing" "${everything[@]}"
echo '# yet more' >>build/release/bin/chapter01
expect 'chapter01/drop' "one experiment, by another program" run 1 drop --no-install
[[ ! -e build/results-quick/01_particle_plane/.made_by ]] || { echo "FAILED: results of two programs count as one's"; failed=1; }
expect 'chapter01/ground' "the rest of that program" "${everything[@]}"
if find build/results build/results-quick -name '*.part' | grep .; then echo "FAILED: a file .part stays"; failed=1; fi
exit $failed
