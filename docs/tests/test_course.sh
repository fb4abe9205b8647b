#!/usr/bin/env bash
# The course command as a user meets it: exit codes, messages, lists; what it asks apt for is in test_packages.sh.
set -u
cd "$(dirname "$(readlink -f "$0")")/../.." || exit 1
failed=0
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export ENDURING_ANSWERS=$scratch/answers # not the reader's

expect() { # EXIT-CODE PATTERN ARGUMENT...: the code, and a line of the output
    local code=$1 pattern=$2 output got=0
    shift 2
    output=$(./course "$@" 2>&1 </dev/null) || got=$?
    if [[ $got -ne $code ]] || ! grep -q -e "$pattern" <<<"$output"; then
        printf 'FAILED: ./course %s\n  expected exit %s and a line with: %s\n  got exit %s and:\n%s\n' "$*" "$code" \
            "$pattern" "$got" "$(head -5 <<<"$output")"
        failed=1
    fi
}

expect 0 './course run --list' help
expect 0 './course run --list'
expect 0 '^  two_looks *three steps' run --list --no-install
expect 2 '--quick is the small version, --full the whole one: one of them' run --quick --full
expect 2 '--full means nothing here' test --full
expect 2 'unknown command: frobnicate' frobnicate
expect 2 'there is no chapter 99' run 99
expect 2 'there is no chapter 98' test 98
expect 2 "name one chapter before drop" run drop
expect 2 'unknown option: --frob' run --frob
expect 2 "unknown word: 'word'" test word
expect 2 '--list means nothing here' test --list
expect 2 '--quick means nothing here' bench --quick
expect 2 'there is no chapter 97' sanitize 97
expect 2 '--live means nothing here' run --live
expect 2 '--renew takes the numbers of a full run' docs --quick --renew
expect 2 'there is no file no_such.py' python no_such.py --no-install
expect 2 'unknown option: --frob' python --frob
expect 2 'holds no tables' compare "$scratch" "$scratch"

# The exercises: an untouched clone is told what is next, nothing is compiled for that, and nothing is right.
expect 1 'of [0-9]* hold. Next: ' check --no-install
expect 1 'of 2 hold. Next: 1.2' check 1.2 1.3 --no-install
expect 2 'there is no exercise 9.9. There are: 1.1' check 9.9 --no-install
expect 2 'name one exercise, as in 3.1' solution 3
expect 2 'there is no layer 98. There are: 0, 1' prove --layers 98 --no-install
expect 2 'part 5/4 should be K/N' prove --layers 1 --part 5/4 --no-install
expect 0 'std::optional<PlaneInterval> find_plane_interval' solution 1.1
expect 0 'A right answer prints' exercise 2.2
expect 2 "no_such_folder is not a folder" grade "$scratch/no_such_folder" --no-install

for main in chapters/[0-9][0-9]_*/main.cpp; do
    [[ -e $main ]] || continue
    number=$((10#$(basename "$(dirname "$main")" | cut -c1-2)))
    expect 0 "^  [a-z_]* *[^ ]" run "$number" --list --no-install
    expect 2 "has no experiment 'no_such'" run "$number" no_such --no-install
done

# All solvers together; a scene of one's own under one of them.
expect 0 '^  ledger  *[^ ]' run solvers --list --no-install
expect 2 "has no experiment 'no_such'" run solvers no_such --no-install
sed 's/"density"/"densty"/' common/scenes/falling_sphere.json >"$scratch/ball.json"
expect 2 'ball.json: /bodies/0/densty: unknown key; did you mean "density"' run solvers --quick --no-install -- --scene "$scratch/ball.json" --out "$scratch/own"
expect 0 'scene.png' run solvers --quick --no-install -- --scene common/scenes/falling_sphere.json --out "$scratch/own"
if [[ ! -s $scratch/own/energy.svg ]]; then echo "FAILED: the own scene left no plot of its energy"; failed=1; fi

# A chapter's program runs it under its own solver; an experiment that reads no scene refuses it.
expect 0 'solver of chapter 7' run 7 --no-install -- --scene common/scenes/falling_sphere.json --no-pictures --out "$scratch/bare"
if [[ -n $(find "$scratch/bare" ! -name '*.csv' -type f) || ! -s $scratch/bare/energy.csv ]]; then
    echo "FAILED: without pictures there is more than tables, or less: $(ls "$scratch/bare")"; failed=1
fi
refuses() { # PROGRAM EXPERIMENT PATTERN
    local said code=0
    said=$("${ENDURING_BUILD:-build/release}/bin/$1" "$2" --scene common/scenes/slope.json --out "$scratch/refused" 2>&1) || code=$?
    if ((code != 2)) || ! grep -q -e "$3" <<<"$said" || [[ -e $scratch/refused ]]; then
        echo "FAILED: $1 $2 --scene ends with $code and says: $(head -1 <<<"$said")"; failed=1
    fi
}
refuses chapter07 stack "'stack' reads no scene file, and no other does"
refuses chapter04 turning "'turning' reads no scene file; these do: slope, mesh_slope"

# A warning does not stop a reader's build. CI's it stops, in the same folder.
echo 'void leaves_it_alone(int number) {}' >"$scratch/warns.cpp"
compiles_with_a_warning() { # by the command of a file of ours
    ninja -C "$scratch/build" -t commands CMakeFiles/enduring_fem.dir/common/fem/material.cpp.o | tail -1 |
        sed "s, -c .*, -c $scratch/warns.cpp," >"$scratch/command"
    (cd "$scratch/build" && mkdir -p CMakeFiles/enduring_fem.dir/common/fem && bash "$scratch/command" 2>"$scratch/said")
}
env -u CI cmake --preset release -B "$scratch/build" >/dev/null
if ! compiles_with_a_warning || ! grep -q 'warning: unused parameter' "$scratch/said"; then
    echo "FAILED: a warning is not shown, or stops a reader's build: $(cat "$scratch/said")"; failed=1
fi
CI=true ENDURING_BUILD=$scratch/build expect 1 'of [0-9]* hold' check --no-install
if compiles_with_a_warning || ! grep -q 'error: unused parameter' "$scratch/said"; then
    echo "FAILED: a warning does not stop CI's build: $(cat "$scratch/said")"; failed=1
fi

# A bare root that cannot be made: its exit code, and nothing left behind.
if ((EUID == 0)); then
    printf '#!/bin/bash\nexit 7\n' >"$scratch/debootstrap"
    chmod +x "$scratch/debootstrap"
    PATH=$scratch:$PATH TMPDIR=$scratch .ci/bare_root trixie --mirror file:///nowhere >"$scratch/said" 2>&1
    if [[ $? -ne 7 ]] || ! grep -q 'MB   a bare root: exit code 7' "$scratch/said" || [[ -n $(find "$scratch" -name 'enduring_trixie*') ]]; then
        echo "FAILED: a bare root that cannot be made: $(cat "$scratch/said")"; failed=1
    fi
fi

if command -v shellcheck >/dev/null; then shellcheck -x course .ci/run .ci/bare_root docs/tests/*.sh || failed=1; fi
exit $failed
