/// \file
/// The method is free, so that no numbers are those of a mistake: what students do wrong is seen at work, by the tests
/// themselves (seen.h). Here the calls to the worker are compiled.

#include "challenge.h"

#include "grader/testing/seen.h"

MUELLE_SEEN_MISTAKE(squeezedRabbit, asked_nothing);
MUELLE_SEEN_MISTAKE(squeezedRabbit, grows_without_bound);
MUELLE_SEEN_MISTAKE(squeezedRabbit, no_number);
MUELLE_SEEN_MISTAKE(squeezedRabbit, asked_too_often);
MUELLE_SEEN_MISTAKE(squeezedRabbit, explicit_euler);
MUELLE_SEEN_MISTAKE(squeezedRabbit, symplectic_euler);
MUELLE_SEEN_MISTAKE(squeezedRabbit, another_time);
MUELLE_SEEN_MISTAKE(squeezedRabbit, kept_between_calls);
MUELLE_SEEN_MISTAKE(squeezedRabbit, too_inexact);

MUELLE_SEEN_MISTAKE(stiffCloth, asked_nothing);
MUELLE_SEEN_MISTAKE(stiffCloth, grows_without_bound);
MUELLE_SEEN_MISTAKE(stiffCloth, no_number);
MUELLE_SEEN_MISTAKE(stiffCloth, asked_for_ever);
MUELLE_SEEN_MISTAKE(stiffCloth, asked_too_often);
MUELLE_SEEN_MISTAKE(stiffCloth, backward_euler);
MUELLE_SEEN_MISTAKE(stiffCloth, another_time);
MUELLE_SEEN_MISTAKE(stiffCloth, kept_between_calls);
MUELLE_SEEN_MISTAKE(stiffCloth, too_inexact);

MUELLE_SEEN_MISTAKE(bouncingBall, asked_nothing);
MUELLE_SEEN_MISTAKE(bouncingBall, draught_left_out);
MUELLE_SEEN_MISTAKE(bouncingBall, grows_without_bound);
MUELLE_SEEN_MISTAKE(bouncingBall, no_number);
MUELLE_SEEN_MISTAKE(bouncingBall, asked_for_ever);
MUELLE_SEEN_MISTAKE(bouncingBall, asked_too_often);
MUELLE_SEEN_MISTAKE(bouncingBall, explicit_euler);
MUELLE_SEEN_MISTAKE(bouncingBall, another_time);
MUELLE_SEEN_MISTAKE(bouncingBall, kept_between_calls);
MUELLE_SEEN_MISTAKE(bouncingBall, too_inexact);
