#!/usr/bin/env bash
# shellcheck disable=SC2016  # what is quoted is for the false programs
# What the course command asks apt for, and what its doctor says: with a false apt, dpkg-query, sudo and id before the real ones.
set -u
cd "$(dirname "$(readlink -f "$0")")/../.." || exit 1
failed=0
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir "$scratch/bin"
export ENDURING_ANSWERS=$scratch/answers # not the reader's
export PATH=$scratch/bin:$PATH

program() { # NAME: a false one, from standard input
    { echo '#!/bin/bash'; cat; } >"$scratch/bin/$1"
    chmod +x "$scratch/bin/$1"
}

# Knows every package but those in `missing`, and fails for these as the real one does.
program dpkg-query <<END
for word in "\$@"; do grep -qx -e "\$word" "$scratch/missing" || echo "installed \$word"; done
[[ ! -s $scratch/missing ]]
END
# Writes down what it is asked to install, and installs it if it \`works\`.
program apt-get <<END
[[ \$1 == -s ]] && { for word in "\${@:2}"; do [[ \$word == -* || \$word == install ]] || echo "Inst \$word (1.0 Debian)"; done; exit; }
[[ \$1 == update ]] && { echo "Fetched 8,000 kB in 2s (4,000 kB/s)"; exit; }
[[ \$1 == install ]] && echo "\$*" >>"$scratch/asked"
[[ -e $scratch/works ]] && : >"$scratch/missing"
END
program apt-cache <<END
[[ \$1 == pkgnames ]] && { grep -vx -f "$scratch/unknown" "$scratch/missing"; exit; }
for word in "\${@:3}"; do printf 'Package: %s\nSize: 40000000\nInstalled-Size: 300000\n\n' "\$word"; done
END
program sudo <<<'exit 1'
program id <<<'echo "${FALSE_ID:-0}"'

missing() { # PACKAGE...
    rm -f "$scratch/asked" "$scratch/works"
    printf '%s\n' "$@" | grep . >"$scratch/missing"
    : >"$scratch/unknown"
}

expect() { # EXIT-CODE PATTERN ARGUMENT...: the code, and a line of the output
    local code=$1 pattern=$2 output got=0
    output=$(./course "${@:3}" 2>&1 </dev/null) || got=$?
    if [[ $got -ne $code ]] || ! grep -q -e "$pattern" <<<"$output"; then
        printf 'FAILED: ./course %s\n  expected exit %s and a line with: %s\n  got exit %s and:\n%s\n' "${*:3}" "$code" "$pattern" "$got" "$output"
        failed=1
    fi
}

asked() { # PACKAGE...: apt was asked for exactly these, or not at all
    local got
    got=$(sed 's/^install -y --no-install-recommends //' "$scratch/asked" 2>/dev/null | tr ' ' '\n' | sort | paste -sd' ')
    [[ $got == "$*" ]] || { printf 'FAILED: apt was asked for "%s", and should have been for "%s"\n' "$got" "$*"; failed=1; }
}

missing libcli11-dev
expect 1 '1 packages: 40 MB to download, 300 MB on the disk; less than a minute, at 4.0 MB a second' setup
asked libcli11-dev
missing libcli11-dev ffmpeg
touch "$scratch/works"
expect 0 'Everything is installed' setup
asked ffmpeg libcli11-dev
missing
expect 0 'Everything is installed' setup
asked
expect 2 "no group 'frobnicate' of packages. There are: start pictures films" setup frobnicate

# The groups that the container's image asks for are groups.
read -ra image < <(grep -oE 'course setup( [a-z]+)+' .devcontainer/Dockerfile | sed 's/course setup//')
((${#image[@]})) || { echo "FAILED: the container's image asks for no group"; failed=1; }
expect 0 'Everything is installed' setup "${image[@]}"

# A command asks for its own groups only.
missing ffmpeg doxygen clang libbenchmark-dev gnuplot-nox
expect 0 'Everything is installed' setup start
asked
missing libcli11-dev ffmpeg doxygen clang libbenchmark-dev gnuplot-nox
expect 1 'cannot do without libcli11-dev' run 1
asked gnuplot-nox libcli11-dev
missing libcli11-dev ffmpeg doxygen clang
expect 1 '^   films: ' run 3
asked ffmpeg libcli11-dev
missing libcli11-dev ffmpeg doxygen clang
expect 1 'cannot do without libcli11-dev' check
asked libcli11-dev
missing libcli11-dev gnuplot-nox
expect 0 'two_looks' run 1 --list
asked

# What the archive does not have is left out, and the rest is installed.
missing libcli11-dev libosmesa6-dev
echo libosmesa6-dev >"$scratch/unknown"
expect 1 "archive does not have libosmesa6-dev" setup
asked libcli11-dev

# Neither root nor sudo: what to ask an administrator for; without pictures a command goes on.
export FALSE_ID=1000
missing libcli11-dev ffmpeg
expect 2 '^  apt-get install --no-install-recommends ffmpeg libcli11-dev$' setup
expect 2 '^  apt-get install --no-install-recommends libcli11-dev$' run 1
missing gnuplot-nox
expect 2 "has no experiment 'no_such'" run 1 no_such
expect 2 'Going on without them' run 1 no_such
asked
unset FALSE_ID

# What a build folder had to do without, and is here now, is looked for again.
mkdir "$scratch/built"
touch "$scratch/built/build.ninja"
program cmake <<<"echo \"\$*\" >>'$scratch/configured'"
for without in '' libbenchmark-dev ffmpeg; do
    missing ffmpeg
    rm -f "$scratch/configured"
    printf '%s' "$without" >"$scratch/built/left_out.txt"
    CI='' ENDURING_BUILD=$scratch/built expect 1 'of [0-9]* hold' check --no-install
    if [[ -e $scratch/configured ]]; then again=libbenchmark-dev; else again=''; fi
    [[ ${without/ffmpeg/} == "$again" ]] || { echo "FAILED: without '$without', which is $([[ $again ]] || echo not) looked for"; failed=1; }
done
rm "$scratch/bin/cmake"

# The doctor.
missing
expect 0 '^  ok  *start: ' doctor
expect 0 'You can start' doctor
missing ffmpeg
expect 0 '^  missing  films: ' doctor
expect 0 '^  *ffmpeg: clips' doctor
missing libcli11-dev
expect 1 '^  missing  start: ' doctor
expect 1 '^To install: ./course setup start$' doctor
missing
CXX=no-such-compiler expect 1 'missing  the compiler no-such-compiler' doctor
program old-compiler <<<'[[ $1 == --version ]] && echo "g++ 7"; exit 1'
CXX=old-compiler expect 1 'wrong .*g++ 7' doctor
program cmake <<<'echo "cmake version 3.22.1"'
expect 1 'cmake 3.22.1 is older than 3.25' doctor
rm "$scratch/bin/cmake"
mkdir -p "$scratch/moved"
echo 'CMAKE_HOME_DIRECTORY:INTERNAL=/somewhere/else' >"$scratch/moved/CMakeCache.txt"
ENDURING_BUILD=$scratch/moved expect 1 'was made for /somewhere/else: remove it' doctor
expect 2 'unknown option: --frob' doctor --frob
exit $failed
