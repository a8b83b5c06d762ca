#!/usr/bin/env bash
# Tests of the script ./mapbed: in a folder with a blank in its name, with a PATH on which dpkg-query, apt,
# cmake and ninja are stand-ins that note how they were called. Nothing is installed or compiled.
set -euo pipefail

source_dir=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
chmod 755 "$work"
tree="$work/a clone"
bin=$work/bin

fake() {  # fake NAME <<<BODY
  { printf '#!/bin/bash\n'; cat; } >"$bin/$1"
  chmod +x "$bin/$1"
}

# A fresh clone on a machine where every package is there and everything builds.
fresh() {
  rm -rf "$tree" "$bin" "$work/calls"
  mkdir -p "$tree" "$bin"
  : >"$work/calls"
  chmod 666 "$work/calls"
  cp "$source_dir/mapbed" "$source_dir/debian-packages.txt" "$tree"
  touch -d '1 minute ago' "$tree"/*
  local tool
  for tool in bash env cat chmod find grep sed tee mkdir mv dirname readlink flock head nproc setpriv \
    sleep tail; do
    ln -s "$(command -v "$tool")" "$bin/$tool"
  done
  export FAKE_CALLS=$work/calls FAKE_MISSING='' FAKE_UNKNOWN=''
  unset MAPBED_YES MAPBED_PACKAGES CI
  fake dpkg-query <<'END'
for name in "${@:4}"; do
  [[ " $FAKE_MISSING " == *" $name "* ]] || echo "$name installed"
done
END
  fake apt-cache <<'END'
for name in "${@:2}"; do
  [[ " $FAKE_UNKNOWN " == *" $name "* ]] || printf '%s:\n  Installed: (none)\n  Candidate: 1.0\n' "$name"
done
END
  fake apt-get <<'END'
echo "apt-get $*" >>"$FAKE_CALLS"
[[ $* == *--assume-no* ]] && printf '%s\n' "Need to get 12 MB of archives." \
  "After this operation, 34 MB of additional disk space will be used."
exit 0
END
  fake cmake <<'END'
echo "cmake $*" >>"$FAKE_CALLS"
while [[ $1 != -S ]]; do shift; done
mkdir -p "$2/build/release/bench"
echo >"$2/build/release/build.ninja"
tests=OFF
[[ $* == *MAPBED_TESTS=ON* ]] && tests=ON
werror=OFF
[[ $* == *MAPBED_WERROR=ON* ]] && werror=ON
printf '%s\n' "CMAKE_HOME_DIRECTORY:INTERNAL=$2" "MAPBED_TESTS:BOOL=$tests" \
  "MAPBED_WERROR:BOOL=$werror" "" >"$2/build/release/CMakeCache.txt"
END
  fake ninja <<'END'
echo "ninja $*" >>"$FAKE_CALLS"
printf '#!/bin/bash\nprintf "<%%s>" "$@"; echo; exit 7\n' >"$2/bench/mapbed"
chmod +x "$2/bench/mapbed"
END
  fake ctest <<'END'
echo "ctest $*" >>"$FAKE_CALLS"
END
}

# As somebody without root's rights, whoever runs this test.
without_root() {
  if [[ $EUID == 0 ]]; then
    chmod 777 "$tree"
    setpriv --reuid=65534 --regid=65534 --clear-groups "$@"
  else
    "$@"
  fi
}

# Runs a command on the fake machine; leaves its output, and its exit status.
run() {
  status=0
  output=$(PATH=$bin "$@" </dev/null 2>&1) || status=$?
}

failures=0
expect() {  # expect WHAT CONDITION…
  local what=$1
  shift
  "$@" && return
  printf 'FAILED: %s: %s\n  status %s, output:\n%s\n  calls:\n%s\n' "$test" "$what" "$status" \
    "$output" "$(cat "$work/calls")"
  failures=$((failures + 1))
}
expect_status() { expect "status $1" test "$status" == "$1"; }
expect_output() { expect "says '$1'" grep -qF -- "$1" <<<"$output"; }
expect_call() { expect "calls '$1'" grep -qF -- "$1" "$work/calls"; }
expect_no_call() { expect "does not call '$1'" test -z "$(grep -F -- "$1" "$work/calls")"; }

passes_arguments_and_exit_status_on() {
  run "$tree/mapbed" map "my log.clf" ''
  expect_status 7
  expect "the arguments alone come out" test "$output" == "<map><my log.clf><>"
  expect_call "ninja -C $tree/build/release mapbed"
  expect_no_call "apt-get"
}

works_from_any_folder_and_through_a_link() {
  ln -s "$tree/mapbed" "$bin/linked"
  cd /
  run "$bin/linked" list
  expect_status 7
}

configures_once() {
  run "$tree/mapbed" list
  run "$tree/mapbed" list
  expect "one call of cmake" test "$(grep -c ^cmake "$work/calls")" == 1
}

starts_at_once_where_nothing_changed() {
  mkdir -p "$tree/core" "$tree/.git"
  echo first >"$tree/.git/HEAD"
  run "$tree/mapbed" list
  echo 'echo "dpkg-query $*" >>"$FAKE_CALLS"' >>"$bin/dpkg-query"
  : >"$work/calls"
  run "$tree/mapbed" map log.clf
  expect_status 7
  expect "the arguments alone come out" test "$output" == "<map><log.clf>"
  expect "builds nothing, asks for no package" test ! -s "$work/calls"
}

builds_again_after_any_change() {
  mkdir -p "$tree/core/geometry" "$tree/.git"
  echo first >"$tree/.git/HEAD"
  local change
  for change in 'echo >core/geometry/new.cpp' 'rm core/geometry/new.cpp' 'echo second >.git/HEAD' \
    'touch debian-packages.txt' 'rm build/release/bench/mapbed' 'true'; do
    run "$tree/mapbed" list
    : >"$work/calls"
    (cd "$tree" && sleep 0.01 && eval "$change")
    run "$tree/mapbed" list
    if [[ $change == true ]]; then expect_no_call ninja; else expect_call "ninja"; fi
    expect_status 7
  done
}

configures_anew_where_the_clone_was_moved() {
  run "$tree/mapbed" list
  mv "$tree" "$work/moved"
  run "$work/moved/mapbed" list
  rm -rf "$work/moved"
  expect "two calls of cmake" test "$(grep -c ^cmake "$work/calls")" == 2
}

builds_tests_for_test_only() {
  run "$tree/mapbed" list
  expect_call "-DMAPBED_TESTS=OFF"
  run "$tree/mapbed" test -L unit
  expect_call "-DMAPBED_TESTS=ON"
  expect_call "release all"
  expect_call "--output-on-failure"
  expect_call "-L unit"
  run "$tree/mapbed" list
  expect "the build with tests serves the program too" test "$(grep -c ^cmake "$work/calls")" == 2
}

takes_warnings_as_errors_in_ci() {
  export CI=true
  run "$tree/mapbed" test
  expect_call "-DMAPBED_WERROR=ON"
}

says_what_and_how_much_before_it_installs() {
  export FAKE_MISSING='ccache libpng-dev' CI=true
  fake sudo <<<'exec "$@"'
  run "$tree/mapbed" list
  expect_output "these Debian packages are missing: ccache libpng-dev"
  expect_output "Need to get 12 MB"
  expect_output "34 MB of additional disk space"
  expect_call "apt-get install -y -qq --no-install-recommends ccache libpng-dev"
  expect_status 7
}

needs_test_packages_for_test_only() {
  export FAKE_MISSING='libgtest-dev' CI=true
  fake sudo <<<'exec "$@"'
  run "$tree/mapbed" list
  expect_no_call "apt-get install"
  run "$tree/mapbed" test
  expect_call "apt-get install -y -qq --no-install-recommends libgtest-dev"
}

asks_on_a_terminal() {
  export FAKE_MISSING='ccache'
  fake sudo <<<'exec "$@"'
  status=0
  output=$(PATH=$bin:/usr/bin:/bin script -qec "'$tree/mapbed' list" /dev/null <<<n 2>&1) || status=$?
  expect_output "[Y/n]"
  expect_output "nothing installed"
  expect_status 1
  expect_no_call "apt-get install -y"
}

does_not_install_unasked_without_a_terminal() {
  export FAKE_MISSING='ccache'
  fake sudo <<<'exec "$@"'
  run without_root "$tree/mapbed" list
  expect_status 1
  expect_output "MAPBED_YES=1"
  expect_no_call "apt-get install -y"
}

says_who_can_install_without_root_and_sudo() {
  export FAKE_MISSING='ccache'
  run without_root "$tree/mapbed" list
  expect_status 1
  expect_output "needs root, and there is no sudo"
  expect_output "apt-get install ccache"
}

says_what_to_do_on_another_distribution() {
  rm "$bin/dpkg-query" "$bin/apt-get"
  run "$tree/mapbed" list
  expect_status 1
  expect_output "this is not Debian"
  expect_output "libeigen3-dev"
  export MAPBED_PACKAGES=skip
  run "$tree/mapbed" list
  expect_status 7
}

fetches_the_lists_where_apt_does_not_know_a_package() {
  export FAKE_MISSING='ccache' FAKE_UNKNOWN='ccache' CI=true
  fake sudo <<<'exec "$@"'
  run "$tree/mapbed" list
  expect_call "apt-get update"
  expect_output "apt offers no package ccache"
  expect_status 1
}

shows_what_apt_said_where_it_fails() {
  export FAKE_MISSING='ccache' CI=true
  fake sudo <<<'exec "$@"'
  fake apt-get <<<'echo "E: Unable to fetch some archives"; exit 100'
  run "$tree/mapbed" list
  expect_status 1
  expect_output "E: Unable to fetch some archives"
  expect_output "try: apt-get update"
}

shows_the_errors_of_a_failed_build_and_where_all_of_it_is() {
  fake ninja <<'END'
echo "[1/9] Building good.o"
echo "FAILED: bad.o"
echo "bad.cpp:3:1: error: expected ';'"
exit 1
END
  run "$tree/mapbed" list
  expect_status 1
  expect_output "bad.cpp:3:1: error"
  expect_output "$tree/build/build.log"
  expect "says nothing of what was built" test -z "$(grep -F good.o <<<"$output")"
}

says_how_far_a_long_build_is_without_a_terminal() {
  fake nproc <<<'echo 2'
  fake ninja <<'END'
for ((i = 1; i <= FAKE_FILES; ++i)); do echo "[$i/$FAKE_FILES] Building $i.o"; done
printf '#!/bin/bash\necho out\n' >"$2/bench/mapbed"
chmod +x "$2/bench/mapbed"
END
  export FAKE_FILES=480
  run "$tree/mapbed" list
  expect_output "mapbed: building 480 files, about 5 min; messages are in $tree/build/build.log"
  expect_output "mapbed: building 48/480"
  expect_output "mapbed: building 480/480"
  expect "a line for each tenth" test "$(grep -c 'mapbed: building [0-9]*/480$' <<<"$output")" == 10
  touch "$tree/debian-packages.txt"
  FAKE_FILES=4
  run "$tree/mapbed" list
  expect "nothing of a short one" test "$output" == out
}

shows_one_line_of_progress_on_a_terminal() {
  fake ninja <<'END'
for i in 1 2 3 4; do echo "[$i/4] Building $i.o"; done
printf '#!/bin/bash\necho out\n' >"$2/bench/mapbed"
chmod +x "$2/bench/mapbed"
END
  status=0
  output=$(PATH=$bin:/usr/bin:/bin script -qec "'$tree/mapbed' list" /dev/null 2>&1) || status=$?
  expect_output $'\r\e[Kbuilding [4/4] Building 4.o\r\e[K'
  expect "one line" test "$(grep -c building <<<"$output")" == 1
}

ends_cleanly_when_interrupted() {
  fake ninja <<<'sleep 30'
  status=0
  # A session of its own, so that all its processes get the signal, as from Ctrl-C.
  output=$(PATH=$bin:/usr/bin:/bin timeout -s INT 1 "$tree/mapbed" list </dev/null 2>&1) || status=$?
  expect_output "interrupted"
  expect "ends at once, not after 30 s" test "$SECONDS" -lt "$((started + 10))"
}

lists_every_package_under_third_party() {
  local group name rest
  while read -r group name rest; do
    [[ $group == program || $group == test ]] || continue
    expect "THIRD_PARTY.md names $name" grep -qF -- "$name" "$source_dir/THIRD_PARTY.md"
  done <"$source_dir/debian-packages.txt"
}

for test in passes_arguments_and_exit_status_on works_from_any_folder_and_through_a_link configures_once \
  starts_at_once_where_nothing_changed builds_again_after_any_change \
  configures_anew_where_the_clone_was_moved builds_tests_for_test_only takes_warnings_as_errors_in_ci \
  says_what_and_how_much_before_it_installs needs_test_packages_for_test_only asks_on_a_terminal \
  does_not_install_unasked_without_a_terminal says_who_can_install_without_root_and_sudo \
  says_what_to_do_on_another_distribution fetches_the_lists_where_apt_does_not_know_a_package \
  shows_what_apt_said_where_it_fails shows_the_errors_of_a_failed_build_and_where_all_of_it_is \
  says_how_far_a_long_build_is_without_a_terminal shows_one_line_of_progress_on_a_terminal \
  ends_cleanly_when_interrupted lists_every_package_under_third_party; do
  fresh
  status=0 output='' started=$SECONDS
  "$test"
done
((failures == 0)) && echo "all passed"
