// uses: world/shared/Real.cl*LANES
// Which pairs of circles become contacts.

// Whether two circles may meet within the step. dx, dy: difference of the bases; reaches: the sum of both.
MASK NAME(isNear)(REAL dx, REAL dy, REAL reaches) { return dx * dx + dy * dy < reaches * reaches; }

// Whether two circles push each other at all: of two static ones neither moves. Given their inverse masses.
MASK NAME(mayCollide)(REAL invMassA, REAL invMassB) { return invMassA != 0.0f || invMassB != 0.0f; }
