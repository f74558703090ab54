/**
 * Small numerical kernels that know nothing of the problem: probability vectors, match scores, the directional density
 * of a gesture, and named random streams. Depends on no other package of the project.
 */
package handover.math;
